#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reference of the roll tank; `plot.py OUTPUT_DIR` makes the pictures.

overlay(axes, column) is called by contrib/plot_run for every column of
statistics.csv that it draws; see there.
"""

import csv
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
PERIOD = 1.6295  # [s] of the roll
FIRST = 2.2  # [s] of the first impact of the run: the record is not shipped
MBAR = 100  # [Pa]


def overlay(axes, column):
    """Mean of each peak over the repeated tests, and its standard deviation."""
    if column != "probe sensor pressure [Pa]":
        return
    with open(os.path.join(HERE, "reference", "peaks.csv"), newline="") as file:
        rows = [[float(value) for value in row] for row in list(csv.reader(file))[1:]]
    axes.errorbar([FIRST + (row[0] - 1) * PERIOD for row in rows],
                  [MBAR * row[1] for row in rows],
                  yerr=[MBAR * row[2] for row in rows],
                  fmt="k.", capsize=3, label="experiment, peak and deviation")


if __name__ == "__main__":
    plot_run = os.path.join(HERE, "..", "..", "..", "contrib", "plot_run")
    sys.exit(subprocess.call([sys.executable, plot_run, *sys.argv[1:], "--scene", HERE]))
