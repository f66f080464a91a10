#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signals in every phase of a run, on one rank and on two.

signals.py SEICHE MPIRUN

From the first file on a run ends with exit code 5 and a checkpoint (0 if it was
just ending), and the restart ends with the results of an undisturbed run within the
tolerances of the solver. Before that nothing was written, and the signal may end
the process. A second one kills; nothing is lost then either.
"""
import os
import pathlib
import shutil
import signal
import sys
import time

from harness import (ROOT, SLOWEST, Account, amount, arguments, outcome_of, scratch,
                     within_time)
from runs import Program, checkpoints, ranks_of

sys.path.insert(0, str(ROOT / "tests/ranks"))
from compare_ranks import difference, read_columns  # noqa: E402

SCENE = str(ROOT / "tests/restart/dam_break_2d.prm")
OPTIONS = ["Solver/Newton tolerance = 1e-12", "Solver/Newton absolute tolerance = 1e-13",
           "Solver/Linear tolerance = 1e-12", "Solver/Projection tolerance = 1e-13",
           "Time/Step control = fixed", "Time/Step = 0.004", "Time/End time = 0.2",
           "Checkpoint/Every steps = 0", "Output/Interval = 0.02",
           "Checkpoint/Every wall time = 0.2"]
TOLERANCE = 1e-6  # of a chaotic flow that stopped anywhere; compare_ranks has the scales

SIGNALS = {"TERM": 1, "INT": 1, "INT twice": 2, "USR1": 1, "HUP": 1, "XCPU": 1, "PIPE": 1}


def rows(folder):
    try:
        return pathlib.Path(folder, "statistics.csv").read_bytes().count(b"\n")
    except FileNotFoundError:
        return 0


def any_file(pattern):
    return lambda folder: any(pathlib.Path(folder).glob(pattern))


PHASES = {  # a test of the output folder: the phase has begun
    "at once": lambda _: True,
    "set-up": any_file(".lock"),
    "first step": any_file("statistics.csv"),
    "in the middle": lambda folder: rows(folder) > 20,
    "writing a checkpoint": any_file("checkpoint-*.writing"),
    "near the end": lambda folder: rows(folder) > 48,
}


def interrupt(program, folder, name, times, reached):
    """Start, wait for the phase, send; the outcome and how many rows there were."""
    begin = time.monotonic()
    process = program.start(folder)
    target = None
    while process.poll() is None and time.monotonic() < begin + SLOWEST:
        target = target or next(iter(ranks_of(process, program.command[0])), None)
        if target and reached(folder):
            break
        time.sleep(0.0005)
    before = rows(folder)
    for _ in range(times):
        if process.poll() is None and target:
            try:
                os.kill(target, getattr(signal, f"SIG{name}"))
            except ProcessLookupError:
                pass
            time.sleep(0.01)
    return outcome_of(process, begin), before


def main():
    options = arguments(__doc__)
    account, kinds = Account("signals"), {}
    with scratch() as folder:
        cases = [(ranks, signal_name, phase) for ranks in (1, 2) for signal_name in SIGNALS
                 for phase in PHASES]
        n = amount("signals")
        cases = [cases[(2 * i + 1) * len(cases) // (2 * n)] for i in range(n)]
        programs = {ranks: Program(options.seiche, options.mpirun, SCENE, ranks, OPTIONS)
                    for ranks in (1, 2)}
        programs[1].run(f"{folder}/whole")
        whole = read_columns(f"{folder}/whole")

        def goes_on(parts, ranks):
            """What is wrong with the results of a restart (or of a new start)."""
            restart = ["--restart"] if os.path.isdir(parts) and checkpoints(parts) else []
            programs[ranks].run(parts, *restart)
            columns = read_columns(parts)
            for name in whole:
                if "iterations" not in name and \
                        not difference(name, whole, columns) <= TOLERANCE:
                    return f"other results in {name}: " \
                           f"{difference(name, whole, columns):.1e}"
            return ""

        for ranks, name, phase in within_time(cases):
            parts = f"{folder}/parts"
            shutil.rmtree(parts, ignore_errors=True)
            times = SIGNALS[name]
            number = name.split()[0]
            outcome, before = interrupt(programs[ranks], parts, number, times,
                                        PHASES[phase])
            allowed = {0, 5}
            early = before == 0  # the handler may not be there yet
            if times == 2 or early:
                killed = getattr(signal, f"SIG{number}").value
                allowed |= {-killed, 128 + killed, killed}
            problem = Account.wrong(outcome, allowed)
            if not problem and outcome.code == 5 and not checkpoints(parts):
                problem = "no checkpoint"
            if not problem and outcome.code != 0:
                problem = goes_on(parts, ranks)
            account.add(f"{ranks} ranks, {name}, {phase}", outcome, allowed, problem)
            kinds.setdefault((ranks, phase), []).append(str(outcome.code))
    for (ranks, phase), codes in kinds.items():
        print(f"    {ranks} ranks, {phase}: exit {' '.join(codes)}")
    return account.verdict(f"signals ({', '.join(SIGNALS)} in {len(PHASES)} phases)")


if __name__ == "__main__":
    raise SystemExit(main())
