#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""bed.csv, paddle_A.csv, paddle_C.csv and reference/gauges_A.csv, gauges_C.csv.

    make_tables.py FOLDER

FOLDER has paddle.csv (time, way of the paddle in cases A, B, C), gauges_A.csv,
gauges_C.csv (time, g1, g2, g3, g4, g6, g9, g16, g22) and runup_A.csv, runup_C.csv
(angle [rad], angle [deg], run-up [m], ...), 25 samples a second, in metres.
Written: the way from its start, means of five samples every 0.12 s; the gauges less
their means before the wave, means of three samples every 0.12 s; t = 0 is START in the
record, of the gauges LATE after it; bed.csv is the cone. Crests and run-ups, the mean of both sides of the island,
are printed.
"""
import csv
import pathlib
import sys

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
START = 22.0
LATE = {"A": 0.12, "C": 0.2}  # [s]: README.md
GAUGES = ["g1", "g2", "g3", "g4", "g6", "g9", "g16", "g22"]


def read(file):
    return np.genfromtxt(file, delimiter=",", skip_header=1)


def write(file, head, rows):
    with open(HERE / file, "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(head)
        writer.writerows(rows)


def paddle(times, way, case):
    """At rest until it has gone 0.5 mm for good, and after the record."""
    way = way - way[times < START + 0.25].mean()
    moves = times > times[np.flatnonzero(way < 0.0005)[-1]]
    way = np.where(moves, way, 0)
    way = np.convolve(np.pad(way, 2, mode="edge"), np.ones(5) / 5, mode="valid")
    places = np.arange(0, 20, 0.12)
    values = np.interp(places + START, times, way)
    write("paddle_%s.csv" % case, ["time [s]", "displacement [m]"],
          [["%.2f" % t, "%.5f" % v] for t, v in zip(places, values)])


def gauges(table, case):
    times = table[:, 0]
    values = table[:, 1:] - table[times < START, 1:].mean(axis=0)
    first = times < START + 15
    for name, column in zip(GAUGES, values[first].T):
        print("case %s: crest at %s %.1f mm at %.2f s" % (case, name, 1000 * column.max(), times[column.argmax()] - START - LATE[case]))
    rows = []
    for time in np.arange(0, 16, 0.12):
        near = abs(times - time - START - LATE[case]) < 0.05
        means = values[near].mean(axis=0)
        rows.append(["%.2f" % time] + ["%.5f" % v for v in [means[:4].mean()] + list(means)])
    write("reference/gauges_%s.csv" % case, ["time [s]", "mean of g1 to g4 [m]"] + [g + " [m]" for g in GAUGES], rows)


def run_up(table, case):
    """Angles of the scene count from the front (270 degrees of the record) to the lee."""
    angle, height = np.append(table[:, 1], 360), np.append(table[:, 2], table[0, 2])
    for place in (0, 45, 90, 135, 180):
        sides = [np.interp((270 + sign * place) % 360, angle, height) for sign in (1, -1)]
        print("case %s: run-up %3d degrees from the front %.1f mm (%.1f and %.1f)"
              % (case, place, 500 * sum(sides), 1000 * sides[0], 1000 * sides[1]))


def bed():
    """The cone between the floor and its crest; below the floor outside of it."""
    rows = []
    for x in [-4, 9] + list(np.arange(91, 169) / 10) + [17, 20]:
        for y in [7, 10] + list(np.arange(101, 144) / 10):
            level = (3.6 - np.hypot(x - 12.96, y - 13.8)) / 4 - 0.32
            rows.append(["%.5g" % x, "%.5g" % y, "%.5f" % min(0.305, max(-0.4, level))])
    write("bed.csv", ["x [m]", "y [m]", "level [m]"], rows)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    bed()
    ways = read(folder / "paddle.csv")
    for case, column in (("A", 1), ("C", 3)):
        paddle(ways[:, 0], ways[:, column], case)
        gauges(read(folder / ("gauges_%s.csv" % case)), case)
        run_up(read(folder / ("runup_%s.csv" % case)), case)


if __name__ == "__main__":
    main()
