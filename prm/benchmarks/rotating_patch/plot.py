#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""References of the rotating patch; `plot.py OUTPUT_DIR` makes the pictures.

overlay(axes, column) and overlay_snapshot(axes, time) are called by
contrib/plot_run; see there.
"""

import csv
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


def table(name):
    """Columns of a reference table, without its header line."""
    with open(os.path.join(HERE, "reference", name), newline="") as file:
        rows = list(csv.reader(file))[1:]
    return [[float(row[i]) for row in rows] for i in range(len(rows[0]))]


def overlay(axes, column):
    """Draw the references for a column of statistics.csv, if there are any."""
    if column == "probe centre pressure [Pa]":
        data = table("centre_pressure.csv")
        axes.plot(data[0], data[1], "k--", lw=0.8, label="reference")
        axes.set_ylim(-0.2, 0.02)
    elif column == "point corner radius ratio [-]":
        t = [0.05 * i for i in range(36)]
        axes.plot(t, [(1 + v * v) ** 0.5 for v in t], "k--", lw=0.8, label="exact")


def overlay_snapshot(axes, time):
    """Draw the reference surface at 0.5, 1 and 1.5 s: one side, turned."""
    for reference in (0.5, 1, 1.5):
        if abs(time - reference) < 1e-6:
            x, y = table("surface_wt%g.csv" % reference)
            for _ in range(4):
                axes.plot(x, y, "k-", lw=0.7)
                x, y = [-v for v in y], x


if __name__ == "__main__":
    plot_run = os.path.join(HERE, "..", "..", "..", "contrib", "plot_run")
    sys.exit(subprocess.call([sys.executable, plot_run, *sys.argv[1:], "--scene", HERE]))
