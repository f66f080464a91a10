#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reference of turned_dam_break.prm and aligned_dam_break.prm.

    build/seiche prm/verification/aligned_dam_break.prm --output /tmp/aligned \\
        --set "Grid/Cell size = 0.0125" --set "Time/Step = 0.00125"
    prm/verification/turned_dam_break.py /tmp/aligned

writes reference/turned_dam_break.csv from that run: kinetic energy, momentum, places of
two points and force, every 0.01 s, in the frame of the tank and turned by 30 degrees.
"""
import csv
import math
import pathlib
import sys

TABLE = pathlib.Path(__file__).resolve().parent / "reference/turned_dam_break.csv"
ANGLE = math.radians(30)
VECTORS = (("momentum {} [kg m/s]",) * 2, ("point toe {} [m]", "point top {} [m]"),
           ("force tank {} [N]",) * 2)


def column(rows, name, clock="time [s]"):
    """Times and values of a column, without its empty fields."""
    return [(float(row[clock]), float(row[name])) for row in rows if row[name]]


def at(pairs, time):
    """Linear between the rows."""
    for (t0, v0), (t1, v1) in zip(pairs, pairs[1:]):
        if t0 <= time <= t1 or (t1, v1) == pairs[-1] or time < t0:
            return v0 + (v1 - v0) * (time - t0) / (t1 - t0)


def main():
    with open(f"{sys.argv[1]}/statistics.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))

    def value(name, time):
        clock = "pressure_time [s]" if name.startswith("force") else "time [s]"
        return at(column(rows, name, clock), time)

    lines = ["time [s],kinetic energy [J],momentum x [kg m/s],momentum y [kg m/s],toe x [m],"
             "top y [m],force x [N],force y [N],turned momentum x [kg m/s],"
             "turned momentum y [kg m/s],turned toe x [m],turned top y [m],"
             "turned force x [N],turned force y [N]"]
    cosine, sine = math.cos(ANGLE), math.sin(ANGLE)
    for step in range(91):
        time = step / 100
        aligned, turned = [], []
        for first, second in VECTORS:
            aligned += [value(first.format("x"), time), value(second.format("y"), time)]
            turned += [cosine * aligned[-2] - sine * value(first.format("y"), time),
                       sine * value(second.format("x"), time) + cosine * aligned[-1]]
        numbers = [time, value("kinetic energy [J]", time), *aligned, *turned]
        lines.append(",".join(f"{number:.6g}" for number in numbers))
    TABLE.write_text("\n".join(lines) + "\n", encoding="utf-8")


main()
