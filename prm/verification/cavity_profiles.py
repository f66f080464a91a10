#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Centre-line velocities of lid_driven_cavity.prm against Ghia et al. (1982).

    cavity_profiles.py OUTPUT_DIR REYNOLDS_NUMBER [--table]

Means over the last tenth of the run, against tables I and II (reference/
lid_driven_cavity_*.csv); the speed of the lid is 1 m/s. Their v at x = 0.9063 for
Re = 400 breaks the trend of its neighbours, is commonly taken for a misprint and
left out. Prints the largest and the rms difference of each line, and by how much
a velocity of the lines still varies in that tenth. Needs nothing but Python.
"""

import csv
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
MISPRINTS = {("v", 400, 0.9063)}


def reference(line, reynolds):
    """[(place, velocity or None)] without the walls."""
    path = os.path.join(HERE, "reference", f"lid_driven_cavity_{line}.csv")
    with open(path, encoding="utf-8") as file:
        header, *rows = list(csv.reader(file))
    column = next(i for i, name in enumerate(header) if f"Re={reynolds} " in name)
    return [(float(row[0]), None if (line, reynolds, float(row[0])) in MISPRINTS
             else float(row[column])) for row in rows[1:-1]]


def compare(output, reynolds):
    """{line: [(place, velocity, difference or None)]} and the largest range."""
    with open(os.path.join(output, "statistics.csv"), encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    end = float(rows[-1]["time [s]"])
    rows = [row for row in rows if float(row["time [s]"]) >= 0.9 * end]
    lines, largest_range = {}, 0.
    for line, component in (("u", "x"), ("v", "y")):
        lines[line] = []
        for i, (place, exact) in enumerate(reference(line, reynolds), 1):
            values = [float(row[f"probe {line}{i} velocity {component} [m/s]"])
                      for row in rows]
            mean = sum(values) / len(values)
            lines[line].append(
                (place, mean, None if exact is None else mean - exact))
            largest_range = max(largest_range, max(values) - min(values))
    return lines, largest_range


def errors(output, reynolds):
    """{name: value}: largest and rms difference of each line, range."""
    lines, largest_range = compare(output, reynolds)
    result = {}
    for line, values in lines.items():
        differences = [d for _, _, d in values if d is not None]
        result[f"{line}_max"] = max(map(abs, differences))
        result[f"{line}_rms"] = math.sqrt(
            sum(d * d for d in differences) / len(differences))
    result["range"] = largest_range
    return result


def main():
    arguments = [a for a in sys.argv[1:] if a != "--table"]
    if len(arguments) != 2:
        sys.exit(__doc__)
    output, reynolds = arguments[0], int(arguments[1])
    if "--table" in sys.argv:
        for line, values in compare(output, reynolds)[0].items():
            for place, value, difference in values:
                print(f"{line} {place:.4f} {value:+.5f} " +
                      ("-" if difference is None else f"{difference:+.5f}"))
    for name, value in errors(output, reynolds).items():
        print(f"{name} {value:.4f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
