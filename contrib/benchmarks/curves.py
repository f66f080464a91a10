# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves over time, as CSV files with one header line."""

import csv
import os


def read_curves(path, name="curves.csv"):
    with open(os.path.join(path, name), newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return {name: [float(row[i]) for row in rows[1:]] for i, name in enumerate(rows[0])}


def interpolate(x, xs, ys):
    """Linear; constant outside."""
    if x <= xs[0]:
        return ys[0]
    for i in range(1, len(xs)):
        if x <= xs[i]:
            return ys[i - 1] + (ys[i] - ys[i - 1]) * (x - xs[i - 1]) / (xs[i] - xs[i - 1])
    return ys[-1]
