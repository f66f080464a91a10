#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a scene on 1 and N ranks and compare, or check its mirror symmetry.

compare_ranks.py SEICHE MPIRUN SCENE.prm [--ranks N] [--mirror-y Y]
                 [--iterations] [--set "S/E = v"]...

Ranks: all columns of statistics.csv but the iteration counts agree to 1e-8 of
each column's largest value (or of its scale, for columns that are zero but for
round-off). --iterations: only that Krylov's are within 5 % of those on one rank.
--mirror-y: a flow symmetric about the plane y = Y stays so instead.
"""
import csv
import os
import subprocess
import sys
import tempfile

TOLERANCE = 1e-8
MORE_ITERATIONS = 1.05
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
    return read_columns(directory)


def read_columns(directory):
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
    if any(a != a or b != b for a, b in pairs):
        return float("inf")  # max() passes over a value that is missing on one side
    if not pairs:
        return 0.0
    worst = max(abs(a - b) for a, b in pairs)
    return worst / max(scale(name, one), max(abs(a) for a, _ in pairs))


def mirror_errors(columns, plane):
    """What a flow that is symmetric about y = plane leaves at zero: momentum in
    y, and moments about axes in the plane, over the mass (SI)."""

    def column(name):
        return next(columns[key] for key in columns if key.startswith(name))

    p_x, p_y, p_z = (column(f"momentum {c} ") for c in "xyz")
    l_x, l_z = (column(f"angular momentum {c} ") for c in "xz")
    mass = columns["mass [kg]"][0]
    return {
        "momentum y": max(abs(p) for p in p_y) / mass,
        "moment x": max(abs(l - plane * p) for l, p in zip(l_x, p_z)) / mass,
        "moment z": max(abs(l + plane * p) for l, p in zip(l_z, p_x)) / mass,
    }


def compare_iterations(one, other):
    single, several = (sum(columns["krylov_iterations"]) for columns in (one, other))
    print(f"Krylov iterations {single:.0f} on one rank, {several:.0f} on several")
    return 0 if 0 < several <= MORE_ITERATIONS * single else 1


def main():
    seiche, mpirun, scene = sys.argv[1:4]
    options = sys.argv[4:]
    plane = None
    if "--mirror-y" in options:
        at = options.index("--mirror-y")
        plane = float(options[at + 1])
        del options[at : at + 2]
    ranks = "2"
    if "--ranks" in options:
        at = options.index("--ranks")
        ranks = options[at + 1]
        del options[at : at + 2]
    count_iterations = "--iterations" in options
    if count_iterations:
        options.remove("--iterations")
    with tempfile.TemporaryDirectory() as folder:
        one = run(seiche, [], scene, options, os.path.join(folder, "1"))
        if plane is not None:
            errors = mirror_errors(one, plane)
        else:
            launcher = [mpirun, "-n", ranks]
            two = run(seiche, launcher, scene, options, os.path.join(folder, "n"))
            if count_iterations:
                return compare_iterations(one, two)
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
