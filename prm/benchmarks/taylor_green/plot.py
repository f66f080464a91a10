#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decay and convergence of the Taylor-Green vortex.

`plot.py OUTPUT_DIR` makes the pictures of one run; `plot.py DIR16 DIR32 ...`
prints the table of errors and orders of several runs and draws it.
overlay(axes, column) is called by contrib/plot_run; see there.
"""

import json
import math
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
NAMES = ("velocity_l2", "pressure_l2", "velocity_points")


def overlay(axes, column):
    """Draw the exact value of a column of statistics.csv, if there is one."""
    if column == "kinetic energy [J]":
        t = [0.02 * i for i in range(51)]
        exact = [math.pi**2 / 4 * math.exp(-0.04 * v) for v in t]
        axes.plot(t, exact, "k--", lw=0.8, label="exact")


def convergence(folders):
    """Table and picture of the errors over the cell size."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    runs = []
    for folder in folders:
        with open(os.path.join(folder, "summary.json")) as file:
            summary = json.load(file)
        runs.append((math.pi / math.sqrt(summary["cells"]), summary["errors"]))
    runs.sort(key=lambda run: -run[0])

    figure, axes = plt.subplots(figsize=(5, 4))
    for name in NAMES:
        line, last = "%-16s" % name, None
        for h, errors in runs:
            line += "  %.3e" % errors[name]
            if last:
                order = math.log(last[1] / errors[name]) / math.log(last[0] / h)
                line += " (%.2f)" % order
            last = (h, errors[name])
        print(line)
        axes.loglog([h for h, _ in runs], [e[name] for _, e in runs], "o-", label=name)
    h = [h for h, _ in runs]
    axes.loglog(h, [runs[0][1]["velocity_l2"] * (v / h[0]) ** 2 for v in h], "k:", label="order 2")
    axes.set_xlabel("cell size [m]")
    axes.set_ylabel("error [-]")
    axes.legend()
    path = os.path.join(folders[0], "convergence.png")
    figure.savefig(path, dpi=120, bbox_inches="tight")
    print(path)


if __name__ == "__main__":
    if len([a for a in sys.argv[1:] if not a.startswith("-")]) > 1:
        convergence(sys.argv[1:])
    else:
        plot_run = os.path.join(HERE, "..", "..", "..", "contrib", "plot_run")
        sys.exit(subprocess.call([sys.executable, plot_run, *sys.argv[1:], "--scene", HERE]))
