#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write slide.csv: way and speed of the mass that drives the tank.

A cosine of 0.1 m and 1.9432 s whose phase is that of the record (an end at 46.4769 s),
less what brings it from rest within 0.47 s: a cubic that leaves -3 mm and -0.07 m/s at
0.199 s, as recorded.

Usage: prm/benchmarks/tuned_damper/make_slide.py
"""

import math
import pathlib

AMPLITUDE, PERIOD, END = 0.1, 1.9432, 46.4769
START, LAST, STEP = 0.47, 48.0, 0.02


def slide(t):
    """Way [m] and speed [m/s]."""
    w = 2 * math.pi / PERIOD
    x, v = AMPLITUDE * math.cos(w * (t - END)), -AMPLITUDE * w * math.sin(w * (t - END))
    if t < START:
        x0, v0 = AMPLITUDE * math.cos(w * END), AMPLITUDE * w * math.sin(w * END)
        s = t / START
        x -= x0 * (2 * s**3 - 3 * s**2 + 1) + v0 * START * (s**3 - 2 * s**2 + s)
        v -= x0 * (6 * s**2 - 6 * s) / START + v0 * (3 * s**2 - 4 * s + 1)
    return x, v


def main():
    """Write the table beside this file."""
    rows = ["time [s],way [m],speed [m/s]"]
    for i in range(round(LAST / STEP) + 1):
        x, v = slide(i * STEP)
        rows.append(f"{i * STEP:.2f},{x:.7f},{v:.6f}")
    target = pathlib.Path(__file__).with_name("slide.csv")
    target.write_text("\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
