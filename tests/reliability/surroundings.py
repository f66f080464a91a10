#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Unusual surroundings: languages, names of folders, closed streams, limits of time
and of memory.

surroundings.py SEICHE MPIRUN

The same numbers as ever, or exit code 2 or 4 with a message. --max-hours stops in
time (exit code 5). Too little memory (RLIMIT_AS): exit code 4 with a message that says
so and a checkpoint that is whole; never a signal.
"""
import os
import pathlib
import re
import resource
import shutil
import time

from harness import ROOT, ROWS, Account, amount, arguments, outcome_of, run, scratch
from runs import Program, checkpoints, ranks_of, read

SCENE = ROOT / "tests/restart/dam_break_2d.prm"
SHORT = ["--set", "Time/End time = 0.1"]
# takes some 100 MB beyond the libraries
FINE = ["Grid/Cell size = 0.0125", "Time/Step control = fixed", "Time/Step = 0.001",
        "Output/Interval = 0.002", "Checkpoint/Every steps = 2"]
REST = ["--restart", "--set", "Time/End time = 0.004"]


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
    account.add("plain", run([seiche, SCENE, *SHORT, "--output", f"{folder}/plain"]), {0})
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
        command = [seiche, SCENE, *SHORT, "--output", out]
        if name == "blanks and UTF-8 in names":
            out = str(odd / "results \u00df")
            command = [seiche, scene, *SHORT, "--output", out]
        elif name == "relative names":
            out = str(odd / "here")
            command = [os.path.relpath(seiche, odd), scene.name, *SHORT, "--output", "here"]
        elif name == "missing folders":
            out = f"{folder}/a/b/c"
            command = [seiche, SCENE, *SHORT, "--output", out]
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
        outcome = run([seiche, SCENE, *SHORT, "--output", out],
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


def with_memory(program, folder, rank, size):
    """Go on from the checkpoint in the folder and, once the libraries are there, limit
    the addresses of a rank to what it has and size(it) more [bytes]. The outcome, what
    it had, and the most that it took."""
    begin = time.monotonic()
    lock = pathlib.Path(folder, ".lock")
    lock.unlink(missing_ok=True)
    process = program.start(folder, *REST)
    while process.poll() is None and not lock.exists():
        time.sleep(0.0005)
    pid = dict(enumerate(ranks_of(process, program.command[0]))).get(rank)
    had = most = 0
    try:
        had = addresses(pid, "VmSize")
        if size is not None:
            resource.prlimit(pid, resource.RLIMIT_AS, (int(had + size),) * 2)
        while size is None and process.poll() is None:
            most = max(most, addresses(pid, "VmPeak"))
            time.sleep(0.002)
    except (OSError, AttributeError):  # it has ended
        pass
    return outcome_of(process, begin), most - had


def addresses(pid, key):
    """Address space of a process [bytes]."""
    status = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    return 1024 * int(re.search(key + r":\s+(\d+)", status).group(1))


def memory_limits(seiche, mpirun, folder, account):
    """From nothing beyond the libraries to near what the run needs, on one rank and on one
    of two. Starting without memory is the loader's and Open MPI's affair: a restart
    has its lock before the set-up, and the limit is put there."""
    n, hits = amount("memory_limits"), 0
    starts = {}
    for case in range(n):
        ranks = 1 + case % 2
        program = Program(seiche, mpirun, str(SCENE), ranks, FINE)
        start = f"{folder}/start{ranks}"
        if ranks not in starts:
            program.run_until(start, 0.002)
            shutil.copytree(start, f"{folder}/enough")
            starts[ranks] = with_memory(program, f"{folder}/enough", 0, None)[1]
            shutil.rmtree(f"{folder}/enough")
        out = f"{folder}/memory"
        shutil.copytree(start, out)
        share = 0.7 * (case + 0.5) / n
        outcome, _ = with_memory(program, out, case // 2 % ranks, share * starts[ranks])
        problem = ""
        if outcome.code == 4:
            hits += 1
            if not re.search("memory is exhausted|enough memory", outcome.text):
                problem = "no word of memory"
            else:
                program.run(out, *REST)  # the checkpoint is whole
        account.add(f"{share:.0%} of the memory, {ranks} ranks", outcome, {0, 4}, problem)
        shutil.rmtree(out)
    print(f"    {hits} of {n} limits of memory were hit")
    if hits < n / 3:
        account.problems.append("limits too high to be hit")


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
            launcher = [options.mpirun] if part is memory_limits else []
            part(options.seiche, *launcher, folder, account)
            verdict |= account.verdict("runs")
    return verdict


if __name__ == "__main__":
    raise SystemExit(main())
