#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""reference/gauges_A.csv and gauges_B.csv from the records.

    make_tables.py FOLDER

FOLDER has gauges_A.csv and gauges_B.csv: time, gauges 4 to 10 [m], 20 samples
a second, of benchmarks 2 and 5 of NTHMP. Written: the same less the level before
the wave, from the crest at gauge 4 on, means of three samples every 0.1 s.
Height and time of that crest, which the scenes start from, are printed.
"""
import csv
import pathlib
import sys

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
SECONDS = {"A": 17, "B": 10}
NEAR = {"A": 0.5, "B": 0.2}  # [s] on either side of the crest


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for case, seconds in SECONDS.items():
        table = np.genfromtxt(pathlib.Path(sys.argv[1]) / ("gauges_%s.csv" % case), delimiter=",", skip_header=1)
        times = table[:, 0]
        values = table[:, 1:] - table[times < times[0] + 2, 1:].mean(axis=0)
        first = times < times[0] + 9
        top = times[first][values[first, 0].argmax()]
        near = abs(times - top) <= NEAR[case] + 0.01
        a, b, c = np.polyfit(times[near] - top, values[near, 0], 2)
        start = top - b / (2 * a)
        print("case %s: crest of %.2f mm at %.2f s" % (case, 1000 * (c - b * b / (4 * a)), start))
        with open(HERE / ("reference/gauges_%s.csv" % case), "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["time [s]"] + ["G%d [m]" % n for n in range(4, 11)])
            for time in np.arange(0, seconds, 0.1):
                near = abs(times - time - start) < 0.074
                writer.writerow(["%.1f" % time] + ["%.5f" % v for v in values[near].mean(axis=0)])


if __name__ == "__main__":
    main()
