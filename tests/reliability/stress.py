#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every scene of prm/stress with elements of degree 1 and 2, as it stands.

stress.py SEICHE MPIRUN

One that ends with exit code 3 is given the advice of its message, piece by piece, as a
user would, until it finishes: at most STEPS pieces. Never another exit code, never a
hang. Scenes that are known to fail come first and have to fail, so that the advice is
tried at all.
"""
import pathlib
import subprocess
import sys
import time

from harness import HANG, ROOT, Account, Outcome, amount, arguments, scratch, within_time

sys.path.insert(0, str(ROOT / "tests/robustness"))
from advice import FINISHED, INPUT, NUMERICAL, follow, run  # noqa: E402

STEPS, LONGEST = 8, 1800  # pieces of advice; seconds of a run
KNOWN = [("sheets_meet", 1), ("spray", 1), ("acoustic_no_tau2", 1)]


def cases():
    names = sorted(file.stem for file in ROOT.glob("prm/stress/*.prm"))
    every = [(name, degree) for degree in (1, 2) for name in names]
    return KNOWN + [case for case in every if case not in KNOWN]


def walk(seiche, name, degree, folder):
    """What the last run ended with, and what was taken."""
    begin = time.monotonic()
    scene, out = ROOT / f"prm/stress/{name}.prm", pathlib.Path(folder, name)
    try:
        end, taken = follow(lambda entries: run(seiche, str(scene), str(out), entries,
                                                timeout=LONGEST),
                            {"Formulation/Element degree": str(degree)}, STEPS)
        code, text = end.returncode, end.stdout + end.stderr
    except subprocess.TimeoutExpired:
        code, text, taken = HANG, "", []
    return Outcome(code, text, time.monotonic() - begin), taken


def main():
    options = arguments(__doc__)
    account = Account("stress")
    with scratch() as folder:
        for name, degree in within_time(cases()[:amount("stress")]):
            outcome, taken = walk(options.seiche, name, degree, folder)
            problem = ""
            if (name, degree) in KNOWN and not taken and outcome.code == FINISHED:
                problem = "it finishes as it stands: take it from the list"
            if outcome.code == NUMERICAL:
                problem = f"the advice has not helped: {'; '.join(taken) or 'none'}"
            if taken:
                print(f"{name}, degree {degree}: {'; '.join(taken)} -> {outcome.code}",
                      flush=True)
            # some have too few points for degree 2
            allowed = {FINISHED, INPUT} if degree == 2 and not taken else {FINISHED}
            account.add(f"{name}, degree {degree}", outcome, allowed, problem)
    return account.verdict("stress scenes with their advice")


if __name__ == "__main__":
    raise SystemExit(main())
