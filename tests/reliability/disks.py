#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Disks that become full: after a random number of bytes of a tmpfs (as root, in a
mount of its own), or of each file (RLIMIT_FSIZE).

disks.py SEICHE

Exit code 4 (2 where not even the folder could be made), the message names a file;
none is left under its final name that is cut short, and --restart with room goes on
from the last checkpoint to the results of an undisturbed run, byte for byte.
"""
import pathlib
import resource
import shutil
import subprocess

from harness import (ROOT, ROWS, Account, amount, arguments, chance, limit, over_all, run,
                     scratch)
from runs import Program, checkpoints, read

SCENE = str(ROOT / "tests/restart/dam_break_2d.prm")
OPTIONS = ["Output/Interval = 0.02"]


def can_mount():
    return subprocess.run(["unshare", "-m", "mount", "-t", "tmpfs", "none", "/mnt"],
                          capture_output=True, check=False).returncode == 0


def cut_short(folder):
    """Files that are replaced as a whole and do not end as they must."""
    ends = {"*.vtu": b"</VTKFile>\n", "*.pvd": b"</VTKFile>\n", "summary.json": b"}\n",
            "progress.json": b"}\n"}
    for pattern, end in ends.items():
        for file in pathlib.Path(folder).glob(pattern):
            if not file.read_bytes().rstrip().endswith(end.rstrip()):
                return f"{file.name} is cut short"
    return ""


def main():
    options = arguments(__doc__)
    account = Account("disks")
    mounts = can_mount()
    with scratch() as folder:
        program = Program(options.seiche, options.mpirun, SCENE, 1, OPTIONS)
        program.run(f"{folder}/whole")
        whole = [read(f"{folder}/whole", name) for name in ROWS]
        sizes = [file.stat().st_size for file in pathlib.Path(folder, "whole").iterdir()]

        def one(case):
            luck = chance(case)
            parts = f"{folder}/{case}"
            by_limit = case % 2 == 0 or not mounts
            if by_limit:
                size = int(max(sizes) ** luck.uniform(0.3, 1.0))
                outcome = run([*program.command, "--output", parts],
                              prepare=limit(resource.RLIMIT_FSIZE, size))
            else:
                size = int(sum(sizes) * luck.uniform(0.01, 0.9))
                outcome = in_small_disk(case, size)
            problem = cut_short(parts) if pathlib.Path(parts).exists() else ""
            if outcome.code in (2, 4) and folder not in outcome.text:
                problem = "a message without a file"
            if not problem and outcome.code == 4 and pathlib.Path(parts).exists():
                problem = goes_on(parts)
            account.add(f"{case}, {size} bytes", outcome, {0, 2, 4} if by_limit else {2, 4},
                        problem)
            shutil.rmtree(parts, ignore_errors=True)

        def in_small_disk(case, size):
            """What is on the disk is copied from it, for it ends with the process."""
            parts = f"{folder}/{case}"
            pathlib.Path(parts).mkdir()
            script = ('disk=$1 size=$2 kept=$3; shift 3; '
                      'mount -t tmpfs -o size=$size none "$disk" && "$@"; code=$?; '
                      'cp -a "$disk/." "$kept"; exit $code')
            disk = f"{folder}/disk-{case}"
            pathlib.Path(disk).mkdir()
            return run(["unshare", "-m", "bash", "-c", script, "-", disk, str(size), parts,
                        *program.command, "--output", disk])

        def goes_on(parts):
            if not checkpoints(parts):
                return ""
            outcome = run([*program.command, "--output", parts, "--restart"])
            if outcome.code != 0:
                return f"the restart ends with {outcome.code}: {outcome.text}"
            return "" if [read(parts, name) for name in ROWS] == whole else "other results"

        def without_shared_memory():
            """The header of a checkpoint is made elsewhere."""
            parts = f"{folder}/shm"
            outcome = run(["unshare", "-m", "bash", "-c",
                           'mount -t tmpfs -o size=4k none /dev/shm && exec "$@"', "-",
                           *program.command, "--output", parts])
            same = outcome.code == 0 and [read(parts, name) for name in ROWS] == whole
            account.add("no room in /dev/shm", outcome, {0}, "" if same else "other results")

        if mounts:
            without_shared_memory()
        over_all(one, range(amount("disks")))
    return account.verdict("full disks" + ("" if mounts else " (limits of files only)"))


if __name__ == "__main__":
    raise SystemExit(main())
