#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a scene on 1 and 2 ranks, or on mirrored halves, and compare numbers.

compare_ranks.py SEICHE MPIRUN SCENE.prm [--mirror-y] [--set "S/E = v"]...

Ranks: all columns of statistics.csv but the iteration counts agree to 1e-8 of
each column's largest value (or of its scale, for columns that are zero but for
round-off). --mirror-y: the momentum in y and its like stay zero instead.
"""
import csv
import os
import subprocess
import sys
import tempfile

TOLERANCE = 1e-8
SCALES = {  # columns that may be zero: what they are measured against
    "momentum": "mass [kg]",
    "angular momentum": "mass [kg]",
    "volume_relative_change": None,  # None: against one
    "force": "mass [kg]",
    "moment": "mass [kg]",
}


def run(seiche, launcher, scene, options, directory):
    command = launcher + [seiche, scene, "--output", directory] + options
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(directory, "statistics.csv"), newline="") as file:
        rows = list(csv.reader(file))
    return {
        name: [float(row[i] or "nan") for row in rows[1:]]
        for i, name in enumerate(rows[0])
    }


def scale(name, columns):
    for start, reference in SCALES.items():
        if name.startswith(start):
            return columns[reference][0] if reference else 1.0
    return max(max(abs(v) for v in columns[name] if v == v), 1e-300)


def difference(name, one, other):
    if len(one[name]) != len(other[name]):
        return float("inf")
    pairs = [(a, b) for a, b in zip(one[name], other[name]) if a == a or b == b]
    if not pairs:
        return 0.0
    worst = max(abs(a - b) for a, b in pairs)
    return worst / max(scale(name, one), max(abs(a) for a, _ in pairs))


def main():
    seiche, mpirun, scene = sys.argv[1:4]
    options = sys.argv[4:]
    mirror = "--mirror-y" in options
    options = [o for o in options if o != "--mirror-y"]
    with tempfile.TemporaryDirectory() as folder:
        one = run(seiche, [], scene, options, os.path.join(folder, "1"))
        if mirror:
            errors = {
                name: max(abs(v) for v in one[name]) / one["mass [kg]"][0]
                for name in one
                if name.startswith("momentum y")
                or name in ("angular momentum x [kg m^2/s]", "angular momentum z [kg m^2/s]")
            }
            # about the mirror plane: the moments of a symmetric flow are those
            # of its momentum times the plane's distance
        else:
            launcher = [mpirun, "-n", "2"]
            two = run(seiche, launcher, scene, options, os.path.join(folder, "2"))
            errors = {
                name: difference(name, one, two)
                for name in one
                if "iterations" not in name
            }
    failed = {name: error for name, error in errors.items() if not error <= TOLERANCE}
    print(f"{len(errors)} columns, largest difference {max(errors.values()):.1e}")
    for name, error in failed.items():
        print(f"FAILED {name}: {error:.1e} > {TOLERANCE:g}")
    return 1 if failed or not errors else 0


if __name__ == "__main__":
    sys.exit(main())
