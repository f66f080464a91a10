#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frequency and damping of standing_wave*.prm against the reference table.

    wave_fit.py OUTPUT_DIR [TABLE]

Half the difference of the surface at crest and trough, of the run and of the
table: the times of its zeros give the ratio of the frequencies, the logarithms
of its extrema the ratio of the damping rates. Needs nothing but Python.
"""

import csv
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


def signal(rows, time, crest, trough):
    points = [(float(row[time]), float(row[crest]), float(row[trough])) for row in rows]
    return [t for t, _, _ in points], [(a - b) / 2 for _, a, b in points]


def zeros_and_extrema(t, d):
    """Times of the zeros (linear) behind the start, heights of the extrema
    (parabola), with their times."""
    zeros, extrema = [], []
    for i in range(1, len(t) - 1):
        if d[i] * d[i + 1] < 0:
            zeros.append(t[i] + (t[i + 1] - t[i]) * d[i] / (d[i] - d[i + 1]))
        if (d[i] - d[i - 1]) * (d[i + 1] - d[i]) < 0:
            slope, bend = (d[i + 1] - d[i - 1]) / 2, d[i + 1] - 2 * d[i] + d[i - 1]
            if abs(d[i]) > 1e-4:
                extrema.append((t[i] - slope / bend * (t[1] - t[0]),
                                abs(d[i] - slope**2 / (2 * bend))))
    return zeros, extrema


def slope(points):
    """Of the least squares line."""
    n = len(points)
    mean_x, mean_y = (sum(p[i] for p in points) / n for i in (0, 1))
    return (sum((x - mean_x) * (y - mean_y) for x, y in points)
            / sum((x - mean_x) ** 2 for x, y in points))


def fit(output, table):
    """Frequency and damping rate of the run over those of the table, minus 1."""
    with open(os.path.join(output, "statistics.csv"), encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    run = signal(rows, "time [s]", "gauge crest [m]", "gauge trough [m]")
    with open(table, encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file)
                if float(row["t [s]"]) <= run[0][-1] + 1e-9]
    reference = signal(rows, "t [s]", "crest [m]", "trough [m]")
    (zeros, extrema), (zeros_0, extrema_0) = (zeros_and_extrema(*s) for s in (run, reference))
    n = min(len(zeros), len(zeros_0))
    m = min(len(extrema), len(extrema_0))
    assert n >= 2 and m >= 2, "too short for a fit"
    frequency = ((zeros_0[n - 1] - zeros_0[0]) / (zeros[n - 1] - zeros[0])) - 1
    damping = [slope([(t, math.log(a)) for t, a in e[:m]]) for e in (extrema, extrema_0)]
    return frequency, damping[0] / damping[1] - 1


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    name = sys.argv[2] if len(sys.argv) > 2 else os.path.join(HERE, "reference", "standing_wave.csv")
    print("frequency %+.4f, damping rate %+.4f" % fit(sys.argv[1], name))
