#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""wall_position.prm with its walls anywhere in a cell, upright and turned.

    prm/verification/wall_position.py build/seiche [PLACES] ["Entry = value" ...]

moves both walls along their normal through a cell in PLACES steps (50), for normals along
the grid and turned by 30 degrees, and prints of each place iterations a step, the mean
forces on the walls over rho g H^2/2, their largest deviation from theory (upright) and the
fastest point; then how far iterations and forces go apart.
"""
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

SCENE = pathlib.Path(__file__).resolve().with_suffix(".prm")
CELL = 0.05  # [m]
ANGLES = (0, 30)
LENGTH, DEPTH, GRAVITY, PUSH, DENSITY = 1., 0.6, 9.81, 0.5, 1000.
AT_REST = DENSITY * GRAVITY * DEPTH**2 / 2


def settings(angle, place):
    """Entries that put the walls at a place, in cells along their normal."""
    cosine, sine = (function(math.radians(angle)) for function in (math.cos, math.sin))
    entries = []
    for wall, sense in (("west", 1), ("east", -1)):
        entries += [f"Solid {wall}/Normal = {sense * cosine:.15g}, {sense * sine:.15g}",
                    f"Solid {wall}/Shift = {place * CELL / cosine:.15g}, 0"]
    return entries


def sway_force(time):
    """What the push adds to the force on the eastern of two upright walls."""
    force = PUSH * LENGTH * DEPTH / 2
    for n in range(1, 2000, 2):
        k = n * math.pi / LENGTH
        tanh = math.tanh(k * DEPTH)
        omega = math.sqrt(GRAVITY * k * tanh)
        force -= (PUSH * 4 * LENGTH / (n * math.pi)**2 * math.cos(omega * time)
                  * tanh / k)
    return DENSITY * force


def measure(output, summary):
    """Iterations a step, forces in each step, their deviation from the theory of
    upright walls and the largest speed."""
    with open(f"{output}/statistics.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))[1:]
    forces, off = [], 0.
    for row in rows:
        sway = sway_force(float(row["pressure_time [s]"])) / AT_REST
        pair = [sense * float(row[f"force {wall} x [N]"]) / AT_REST
                for wall, sense in (("west", -1), ("east", 1))]
        forces.append(pair)
        off = max(off, abs(pair[0] - (1 - sway)), abs(pair[1] - (1 + sway)))
    steps = len(rows)
    return {"krylov": sum(int(row["krylov_iterations"]) for row in rows) / steps,
            "newton": sum(int(row["newton_iterations"]) for row in rows) / steps,
            "forces": forces, "off": off, "rejected": summary["rejected_steps"],
            "speed": max(float(row["speed_max [m/s]"]) for row in rows)}


def mean(values):
    return sum(values) / len(values)


def spread(places):
    """How far the force on a wall goes apart between places: in one of the steps, and
    in the mean of all."""
    def widest(runs):
        return max(max(values) - min(values)
                   for step in zip(*runs) for values in zip(*step))

    runs = [place["forces"] for place in places]
    return widest(runs), widest([[[mean(wall) for wall in zip(*run)]] for run in runs])


def sweep(run, angle, places, entries=()):
    """Measurements at the places; run(settings) gives output folder and summary."""
    return [measure(*run([*settings(angle, place), *entries])) for place in places]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    seiche, *rest = sys.argv[1:]
    count = int(rest.pop(0)) if rest and rest[0].isdigit() else 50
    with tempfile.TemporaryDirectory() as folder:
        def run(entries):
            command = [seiche, str(SCENE), "--output", folder]
            for entry in entries:
                command += ["--set", entry]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
            with open(f"{folder}/summary.json", encoding="utf-8") as file:
                return folder, json.load(file)

        places = [number / count for number in range(count)]
        aligned = None
        for angle in ANGLES:
            print(f"normal turned by {angle} degrees\n"
                  "place   Newton  Krylov  west    east    deviation  speed [m/s]")
            found = []
            for place in places:
                try:
                    found += sweep(run, angle, [place], rest)
                except subprocess.CalledProcessError as error:
                    print(f"{place:.4f}  ended with exit code {error.returncode}")
                    continue
                one = found[-1]
                means = [mean(wall) for wall in zip(*one["forces"])]
                off = "" if angle else f"{one['off']:.5f}"
                print(f"{place:.4f}  {one['newton']:6.2f}  {one['krylov']:6.2f}  "
                      f"{means[0]:.4f}  {means[1]:.4f}  {off:9s}  {one['speed']:.4f}")
            aligned = aligned or found[0]["krylov"]
            most = max(found, key=lambda one: one["krylov"])
            print(f"most iterations over those of the first place: "
                  f"{most['krylov'] / aligned:.3f}; "
                  "forces go {:.5f} apart, in the mean of all steps {:.5f}\n".format(*spread(found)))


if __name__ == "__main__":
    main()
