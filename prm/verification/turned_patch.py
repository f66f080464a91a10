#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reference of turned_patch.prm and aligned_patch.prm.

    build/seiche prm/verification/aligned_patch.prm --output results/aligned_patch \\
        --set "Grid/Cell size = 0.0125" --set "Time/Step = 0.00625"
    prm/verification/turned_patch.py results/aligned_patch

writes reference/turned_patch.csv from that run: velocities at two places at each 0.025 s,
in the axes of the patch and turned by 30 degrees.
"""
import csv
import math
import pathlib
import sys

TABLE = pathlib.Path(__file__).resolve().parent / "reference/turned_patch.csv"
ANGLE = math.radians(30)
PLACES = ("side", "diagonal")


def main():
    with open(f"{sys.argv[1]}/statistics.csv", encoding="utf-8") as file:
        rows = {round(float(row["time [s]"]), 6): row for row in csv.DictReader(file)}

    names = [f"{place} {axis} [m/s]" for place in PLACES for axis in "xy"]
    lines = [",".join(["time [s]", *names, *(f"turned {name}" for name in names)])]
    cosine, sine = math.cos(ANGLE), math.sin(ANGLE)
    for step in range(1, 71):
        time = round(step * 0.025, 6)
        aligned, turned = [], []
        for place in PLACES:
            x, y = (float(rows[time][f"probe {place} velocity {axis} [m/s]"])
                    for axis in "xy")
            aligned += [x, y]
            turned += [cosine * x - sine * y, sine * x + cosine * y]
        lines.append(",".join(f"{number:.6g}" for number in (time, *aligned, *turned)))
    TABLE.write_text("\n".join(lines) + "\n", encoding="utf-8")


main()
