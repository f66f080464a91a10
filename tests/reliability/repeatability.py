#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same run again and again gives the same bytes: tables, points, checkpoints.

repeatability.py SEICHE MPIRUN
"""
import hashlib
import pathlib
import shutil

from harness import ROOT, Account, amount, arguments, run, scratch
from runs import Program

SCENES = [("tests/restart/dam_break_2d.prm", 1), ("tests/restart/dam_break_2d.prm", 2),
          ("tests/restart/column_3d.prm", 1), ("tests/restart/column_3d.prm", 2)]
END_OF_SAMPLE = "Time/End time = 0.1"  # two and one checkpoints, frames
# probes.csv, statistics.csv, points and checkpoints in HDF5, frames; not the seconds
KEPT = ["*.csv", "*.h5", "*.vtu"]


def digest(folder):
    result = hashlib.sha256()
    for file in sorted(file for pattern in KEPT
                       for file in pathlib.Path(folder).glob(pattern)):
        content = file.read_bytes()
        if file.suffix == ".vtu":  # deal.II puts the date into a comment
            content = b"\n".join(line for line in content.split(b"\n")
                                 if b"This file was generated" not in line
                                 and not line.startswith(b"#"))
        result.update(file.name.encode() + content)
    return result.hexdigest()


def main():
    options = arguments(__doc__)
    account = Account("repeatability")
    repetitions = amount("repeatability")
    with scratch() as folder:
        for scene, ranks in SCENES:
            program = Program(options.seiche, options.mpirun, str(ROOT / scene), ranks,
                              [END_OF_SAMPLE] if repetitions <= 2 else [])
            first = None
            for case in range(repetitions):
                out = f"{folder}/out"
                outcome = run([*program.launcher, *program.command, "--output", out])
                found = digest(out) if outcome.code == 0 else ""
                first = first or found
                account.add(f"{scene}, {ranks} ranks, run {case}",
                            outcome, {0},
                            "" if found == first else "other bytes")
                shutil.rmtree(out, ignore_errors=True)
    return account.verdict(f"runs, {repetitions} each of 2 scenes on 1 and 2 ranks")


if __name__ == "__main__":
    raise SystemExit(main())
