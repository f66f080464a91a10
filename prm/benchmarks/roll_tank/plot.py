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
MBAR = 100  # [Pa]


def overlay(axes, column):
    """Mean of each peak over the repeated tests, and its standard deviation, where the
    run has its peaks: the record's times are not shipped."""
    if column != "probe sensor pressure [Pa]":
        return
    import numpy  # plot_run has found a Python with it

    with open(os.path.join(HERE, "reference", "peaks.csv"), newline="") as file:
        rows = [[float(value) for value in row] for row in list(csv.reader(file))[1:]]
    time, pressure = (numpy.asarray(data, float) for data in axes.lines[-1].get_data())
    pressure = numpy.nan_to_num(pressure)
    first = time[numpy.argmax(pressure > 0.25 * pressure.max())]
    times = []
    for row in rows:
        near = numpy.abs(time - first - (row[0] - 1) * PERIOD) < PERIOD / 2
        times.append(time[near][numpy.argmax(pressure[near])] if near.any() else numpy.nan)
    axes.errorbar(times,
                  [MBAR * row[1] for row in rows],
                  yerr=[MBAR * row[2] for row in rows],
                  fmt="k.", capsize=3, label="experiment, peak and deviation")
    axes.set_xlim(right=time[-1])
    axes.set_ylim(top=1.3 * pressure.max())  # room for the legend


if __name__ == "__main__":
    plot_run = os.path.join(HERE, "..", "..", "..", "contrib", "plot_run")
    sys.exit(subprocess.call([sys.executable, plot_run, *sys.argv[1:], "--scene", HERE]))
