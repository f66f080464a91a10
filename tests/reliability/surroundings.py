#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Unusual surroundings: languages, names of folders, closed streams, limits of time
and of memory.

surroundings.py SEICHE

The same numbers as ever, or exit code 2 or 4 with a message. --max-hours stops in
time (exit code 5). Too little memory (RLIMIT_AS): exit code 1 with a message that says
so, and files that are whole; never a signal.
"""
import os
import pathlib
import resource
import shutil
import subprocess
import time

from harness import ROOT, ROWS, Account, amount, arguments, limit, run, scratch
from runs import checkpoints, read

SCENE = ROOT / "tests/restart/dam_break_2d.prm"


def close(*streams):
    def closed():
        for stream in streams:
            os.close(stream)
    return closed


def as_nobody():
    os.setgid(65534)
    os.setuid(65534)


def usual(seiche, folder, account):
    """Languages, names and streams."""
    account.add("plain", run([seiche, SCENE, "--output", f"{folder}/plain"]), {0})
    plain = [read(f"{folder}/plain", name) for name in ROWS]
    odd = pathlib.Path(folder, "two words \u00fc\u4e2d\u6587 100% 'quoted'")
    odd.mkdir()
    scene = odd / "a scene \u00e9.prm"
    shutil.copy(SCENE, scene)
    absent = {"LC_ALL": "xx_XX.UTF-8"}
    german = {"LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8", "LC_NUMERIC": "de_DE.UTF-8"}
    cases = {
        "German": dict(environment=german),
        "a language that is not there": dict(environment=absent),
        "blanks and UTF-8 in names": dict(),
        "relative names": dict(folder=str(odd)),
        "missing folders": dict(),
        "no standard input": dict(prepare=close(0), stdin=None),
        "no standard output": dict(prepare=close(1)),
        "no standard error": dict(prepare=close(2)),
        "no stream at all": dict(prepare=close(0, 1, 2), stdin=None),
        "no HOME": dict(environment={"HOME": "/nowhere", "TMPDIR": "/nowhere"}),
    }
    for name, options in cases.items():
        out = f"{folder}/{name}"
        command = [seiche, SCENE, "--output", out]
        if name == "blanks and UTF-8 in names":
            out = str(odd / "results \u00df")
            command = [seiche, scene, "--output", out]
        elif name == "relative names":
            out = str(odd / "here")
            command = [os.path.relpath(seiche, odd), scene.name, "--output", "here"]
        elif name == "missing folders":
            out = f"{folder}/a/b/c"
            command = [seiche, SCENE, "--output", out]
        outcome = run(command, **options)
        account.add(name, outcome, {0}, "" if outcome.code == 0 and
                    [read(out, row) for row in ROWS] == plain else
                    Account.wrong(outcome, {0}) or "other numbers")


def read_only(seiche, folder, account):
    locked = pathlib.Path(folder, "locked")
    locked.mkdir()
    os.chmod(folder, 0o755)
    locked.chmod(0o555)
    for name, out in (("read-only folder", locked), ("folder in it", locked / "new")):
        outcome = run([seiche, SCENE, "--output", out],
                      prepare=as_nobody if os.getuid() == 0 else None)
        account.add(name, outcome, {2, 4},
                    "" if str(out) in outcome.text else "a message without the folder")
    secret = pathlib.Path(folder, "secret.prm")
    shutil.copy(SCENE, secret)
    secret.chmod(0)
    outcome = run([seiche, secret], prepare=as_nobody if os.getuid() == 0 else None)
    account.add("unreadable scene", outcome, {2},
                "" if str(secret) in outcome.text else "a message without the file")


def time_limits(seiche, folder, account):
    """A slack for the start and the end of the process on a loaded machine."""
    slack = 5.0
    for case in range(amount("time_limits")):
        seconds = 0.4 + 0.2 * case
        out = f"{folder}/limit"
        shutil.rmtree(out, ignore_errors=True)
        begin = time.monotonic()
        outcome = run([seiche, SCENE, "--set", "Time/Step control = fixed", "--set",
                       "Time/Step = 0.0002", "--output", out, "--max-hours",
                       seconds / 3600])
        late = time.monotonic() - begin - seconds
        account.add(f"{seconds:.1f} s", outcome, {5},
                    f"{late:.1f} s too late" if late > slack else
                    "no checkpoint" if not checkpoints(out) else "")


def needed_memory(seiche, out):
    """Address space that a run takes at its end [bytes]."""
    with subprocess.Popen([seiche, SCENE, "--output", out],
                          stdout=subprocess.DEVNULL) as process:
        largest = 0
        while process.poll() is None:
            try:
                text = pathlib.Path(f"/proc/{process.pid}/statm").read_text()
                largest = max(largest, int(text.split()[0]) * resource.getpagesize())
            except (OSError, IndexError):
                pass
            time.sleep(0.01)
    return largest


def memory_limits(seiche, folder, account):
    """From where the libraries just load to where the run just fits. Below that the
    loader itself gives up (exit code 127)."""
    enough = needed_memory(seiche, f"{folder}/enough")
    n = amount("memory_limits")
    for case in range(n):
        size = int(enough * (0.9 + 0.1 * (case + 0.5) / n))
        out = f"{folder}/memory"
        shutil.rmtree(out, ignore_errors=True)
        outcome = run([seiche, SCENE, "--output", out],
                      prepare=limit(resource.RLIMIT_AS, size))
        problem = ""
        if outcome.code == 1 and "memory is exhausted" not in outcome.text:
            problem = "no word of memory"
        account.add(f"{size / 2**20:.0f} MiB", outcome, {0, 1, 127}, problem)


def main():
    options = arguments(__doc__)
    verdict = 0
    with scratch() as folder:
        for name, part in (("surroundings", usual), ("read-only", read_only),
                           ("time limits", time_limits),
                           ("memory limits", memory_limits)):
            if part is memory_limits and "ASAN_OPTIONS" in os.environ:
                continue  # whose shadow alone takes 16 TiB of addresses
            account = Account(name)
            part(options.seiche, folder, account)
            verdict |= account.verdict("runs")
    return verdict


if __name__ == "__main__":
    raise SystemExit(main())
