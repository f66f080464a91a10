#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reference of the tuned damper; `plot.py OUTPUT_DIR` makes the pictures.

overlay(axes, column) is called by contrib/plot_run for every column of
statistics.csv that it draws; see there.
"""

import csv
import math
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


def overlay(axes, column):
    """Amplitudes of the recorded roll, above and below."""
    if column != "tank angle [rad]":
        return
    with open(os.path.join(HERE, "reference", "amplitudes.csv"), newline="") as file:
        rows = [[float(value) for value in row] for row in list(csv.reader(file))[1:]]
    last = axes.lines[-1].get_xdata()[-1]
    rows = [row for row in rows if row[0] <= last]
    for sign, label in ((1, "experiment, amplitude"), (-1, None)):
        axes.plot([row[0] for row in rows],
                  [sign * math.radians(row[1]) for row in rows], "k.", label=label)


if __name__ == "__main__":
    plot_run = os.path.join(HERE, "..", "..", "..", "contrib", "plot_run")
    sys.exit(subprocess.call([sys.executable, plot_run, *sys.argv[1:], "--scene", HERE]))
