#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""References of the 2D dam break; `plot.py OUTPUT_DIR` makes the pictures.

overlay(axes, column) is called by contrib/plot_run for every column of
statistics.csv that it draws; see there.
"""

import csv
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
HEIGHT = 0.6  # [m] of the column
GATE = 1.2  # [m] face of the column
TIME = (HEIGHT / 9.81) ** 0.5  # [s] unit of the experiment's time
PRESSURE = 1000 * 9.81 * HEIGHT  # [Pa] unit of its pressure


def table(name):
    """Columns of a reference table, without its header line."""
    with open(os.path.join(HERE, "reference", name), newline="") as file:
        rows = list(csv.reader(file))[1:]
    return [[float(row[i]) for row in rows] for i in range(len(rows[0]))]


def interfoam(axes, column):
    data = table("interfoam.csv")
    axes.plot(data[0], data[column], "k--", lw=0.8, label="interFoam, h = 0.025 m")


def front(axes):
    for name, style, label in (
        ("lobovsky_front.csv", "k.", "Lobovsky et al. 2014"),
        ("martin_moyce_front_square_column.csv", "k^", "Martin, Moyce 1952"),
    ):
        t, x = table(name)
        axes.plot([TIME * v for v in t], [GATE + HEIGHT * v for v in x], style, ms=3,
                  mfc="none", label=label)
    interfoam(axes, 1)
    axes.set_ylim(GATE - 0.1, 3.4)
    axes.set_xlim(0, 0.8)


def sensor(axes, name, column):
    t, low, median, high = table(name)
    t = [TIME * v for v in t]
    scaled = [[PRESSURE * v for v in values] for values in (low, median, high)]
    axes.fill_between(t, scaled[0], scaled[2], color="0.8", label="experiment, 95 %")
    axes.plot(t, scaled[1], color="0.4", lw=0.8, label="experiment, median")
    interfoam(axes, column)
    axes.set_ylim(-1000, 1.6 * max(scaled[2]))


def overlay(axes, column):
    """Draw the references for a column of statistics.csv, if there are any."""
    if column == "front surge [m]":
        front(axes)
    elif column == "gauge column [m]":
        interfoam(axes, 2)
    elif column == "probe sensor1 pressure [Pa]":
        sensor(axes, "lobovsky_sensor1.csv", 3)
    elif column == "probe sensor4 pressure [Pa]":
        sensor(axes, "lobovsky_sensor4.csv", 4)


if __name__ == "__main__":
    plot_run = os.path.join(HERE, "..", "..", "..", "contrib", "plot_run")
    sys.exit(subprocess.call([sys.executable, plot_run, *sys.argv[1:], "--scene", HERE]))
