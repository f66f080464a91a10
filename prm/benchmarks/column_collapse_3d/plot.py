#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reference of the 3D column; `plot.py OUTPUT_DIR` makes the pictures.

overlay(axes, column) is called by contrib/plot_run for every column of
statistics.csv that it draws; see there.
"""

import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


def overlay(axes, column):
    """Draw the theoretical limit of the front speed, 2 sqrt(g H)."""
    if column == "front surge [m]":
        speed = 2 * (9.81 * 0.4) ** 0.5
        t = [0, 0.2]
        axes.plot(t, [0.4 + speed * v for v in t], "k:", lw=0.8, label="2 sqrt(g H) t (Ritter)")
        axes.set_ylim(0.38, 1)


if __name__ == "__main__":
    plot_run = os.path.join(HERE, "..", "..", "..", "contrib", "plot_run")
    sys.exit(subprocess.call([sys.executable, plot_run, *sys.argv[1:], "--scene", HERE]))
