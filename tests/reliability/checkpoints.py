#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checkpoints damaged at random: never taken for whole.

checkpoints.py SEICHE

The newest is damaged: the restart names it, takes the older one and ends with the
results of a run without an interruption, byte for byte. Both are damaged (one case
in eight): exit code 4, both named.
"""
import pathlib
import shutil

from harness import ROOT, ROWS, Account, amount, arguments, chance, over_all, run, scratch
from runs import Program, checkpoints, read

SCENE = str(ROOT / "tests/restart/dam_break_2d.prm")
OPTIONS = ["Output/Interval = 0"]
BROKEN_OFF = "0.37"


def damage(luck, file, case):
    """Bits of the head in turn, then bytes, pieces and lengths by chance."""
    data = bytearray(pathlib.Path(file).read_bytes())
    kind = luck.randrange(8)
    at = luck.randrange(len(data))
    if kind == 0:
        at = case % 512
        data[at] ^= 1 << luck.randrange(8)
    elif kind <= 3:
        data[at] ^= luck.randrange(1, 256)
    elif kind == 4:
        del data[at:]
    elif kind == 5:
        length = luck.choice([1, 8, 512, 4096])
        data[at:at + length] = bytes(len(data[at:at + length]))
    elif kind == 6:
        del data[at:at + luck.choice([1, 8, 4096])]
    else:
        data[at:at] = bytes(luck.choice([1, 8, 4096]))
    changed = bytes(data) != pathlib.Path(file).read_bytes()
    pathlib.Path(file).write_bytes(data)
    return changed


def main():
    options = arguments(__doc__)
    account = Account("checkpoints")
    with scratch() as folder:
        program = Program(options.seiche, options.mpirun, SCENE, 1, OPTIONS)
        program.run(f"{folder}/whole")
        program.run_until(f"{folder}/origin", BROKEN_OFF)
        whole = [read(f"{folder}/whole", name) for name in ROWS]

        def one(case):
            luck = chance(case)
            parts = f"{folder}/{case}"
            shutil.copytree(f"{folder}/origin", parts)
            both = luck.randrange(8) == 0
            damaged = checkpoints(parts) if both else checkpoints(parts)[-1:]
            if not all([damage(luck, file, case) for file in damaged]):
                return
            outcome = run([*program.command, "--output", parts, "--restart"])
            problem = ""
            if any(f"{file}: it is" not in outcome.text for file in damaged):
                problem = "the damage was not seen"
            elif not both and outcome.code == 0 and \
                    [read(parts, name) for name in ROWS] != whole:
                problem = "other results"
            account.add(case, outcome, {4} if both else {0}, problem, damaged)
            shutil.rmtree(parts)

        over_all(one, range(amount("checkpoints")))
    return account.verdict("damaged checkpoints")


if __name__ == "__main__":
    raise SystemExit(main())
