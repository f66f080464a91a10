#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numerical faults in the middle of a run (SEICHE_FAULT, injected_fault.h), on one
rank of one or two.

faults.py SEICHE MPIRUN

A fault that comes once in a solve: the step is repeated with half its size and the run
finishes, with the mass it had. One that stays, or a point that is lost: exit code 3
with a message. Never a hang, never a number that is not finite.
"""
import json
import pathlib
import shutil

from expressions import not_finite
from harness import ROOT, Account, amount, arguments, chance, run, scratch, within_time
from runs import Program

SCENE = str(ROOT / "tests/restart/dam_break_2d.prm")
OPTIONS = ["Output/Interval = 0", "Checkpoint/Every steps = 0"]
SOLVERS = ["direct", "iterative"]
ONCE = ["residual", "update", "stall", "singular"]
POINTS = ["position", "velocity", "speed"]
ON_ALL = ["stall", "singular"]
FOR_EVER = 10**9


def main():
    options = arguments(__doc__)
    account = Account("faults")
    with scratch() as folder:
        for case in within_time(range(amount("faults"))):
            luck = chance(case)
            kinds = ONCE + POINTS
            kind = kinds[case % len(kinds)]
            ranks = 1 + case // len(kinds) % 2
            count = FOR_EVER if kind in ONCE and case % 3 == 2 else 1
            rank = "" if kind in ON_ALL or ranks == 1 else luck.randrange(ranks)
            call = luck.randrange(1, 60 if kind in ONCE else 30)
            fault = f"{kind} {call} {count} {rank}"
            out = pathlib.Path(folder, "out")
            shutil.rmtree(out, ignore_errors=True)
            program = Program(options.seiche, options.mpirun, SCENE, ranks, OPTIONS +
                              [f"Solver/Linear solver = {luck.choice(SOLVERS)}"])
            outcome = run([*program.launcher, *program.command, "--output", out],
                          environment={"SEICHE_FAULT": fault})
            problem = not_finite(out)
            if outcome.code == 0 and not problem:
                problem = wrong_summary(out, kind)
            allowed = {3} if count == FOR_EVER or kind in POINTS else {0}
            account.add(f"{case}: {ranks} ranks, {fault}", outcome, allowed, problem)
    return account.verdict("injected faults")


def wrong_summary(out, kind):
    summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    if abs(summary["ledger"]["mass_relative_change"]) > 1e-12:
        return "mass has changed"
    if summary["ledger"]["lost_points"] != 0:
        return "points are lost"
    if summary["rejected_steps"] == 0:
        return f"no step was repeated after a fault of kind {kind}"
    return ""


if __name__ == "__main__":
    raise SystemExit(main())
