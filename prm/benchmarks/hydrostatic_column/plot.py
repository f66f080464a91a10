#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact values of the hydrostatic column; `plot.py OUTPUT_DIR` makes the
pictures.

overlay(axes, column) is called by contrib/plot_run for every column of
statistics.csv that it draws; see there.
"""

import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
PRESSURE = 1000 * 9.81 * 0.5  # [Pa] at the bottom


def overlay(axes, column):
    """Draw the exact value of a column of statistics.csv, if there is one."""
    if column == "probe bottom pressure [Pa]":
        axes.axhline(PRESSURE, color="k", ls="--", lw=0.8, label="exact")
        axes.set_ylim(0.9 * PRESSURE, 1.1 * PRESSURE)
    elif column == "error pressure [-]":
        axes.axhline(1e-2, color="k", ls=":", lw=0.8, label="target")


if __name__ == "__main__":
    plot_run = os.path.join(HERE, "..", "..", "..", "contrib", "plot_run")
    sys.exit(subprocess.call([sys.executable, plot_run, *sys.argv[1:], "--scene", HERE]))
