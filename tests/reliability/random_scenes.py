#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes by chance: every combination of method, walls and bodies that is valid.

random_scenes.py SEICHE [--count N] [--first N] [--jobs N] [--folder DIR] [--show N]

Scene number N is the same everywhere. Each runs for some twenty steps. What must not
happen: a signal, a hang, an internal error, an input that is refused, a lost point,
and energy that rises by more than 5 % of its start (and of what moving walls have
done) without a word. At most 1 % may end with exit code 3, each with advice that
leads to a run that finishes. The number of scenes follows SEICHE_RELIABILITY (night,
release; else a handful).
"""
import argparse
import concurrent.futures
import csv
import json
import os
import pathlib
import random
import resource
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "robustness"))
from advice import follow  # noqa: E402

GRAVITY = 9.81
FINISHED, NUMERICAL, STOPPED = 0, 3, 5
LARGEST_GAIN, LARGEST_FAILED, STEPS_OF_ADVICE = 0.05, 0.01, 8
NUMBERS = {None: 6, "night": 100, "release": 500}
GAIN_IS_SAID = ["energy has risen", "sound crosses"]
CPU_SECONDS, WALL_SECONDS = 60, 900
TRANSFERS = ["PIC", "FLIP", "FLIP acceleration", "PIC/FLIP blend", "APIC", "TPIC",
             "affine FLIP", "Taylor least squares", "XPIC", "FMPM"]
SCHEMES = ["generalized midpoint"] * 3 + ["bossak", "newmark"]
SIDES = ["Left", "Right", "Bottom", "Top", "Front", "Back"]


class Scene:
    """The text of scene `number`, and what its verdict has to know."""

    def __init__(self, number):
        self.chance = random.Random(number)
        self.dim = self.chance.choice([2, 2, 2, 3])
        self.h = self.chance.choice([0.05, 0.1])
        cells = (12, 24) if self.dim == 2 else (5, 9)
        self.size = [self.h * self.chance.randint(*cells) for _ in range(self.dim)]
        self.lines, self.level = [f"set Dimension = {self.dim}"], 0
        self.moving = None
        self.slides = False  # walls that need the midpoint scheme
        self.degree = self.chance.choice([1, 1, 2])
        self.points = self.chance.choice([3, 4] if self.degree == 2 else [2, 3, 4])
        if self.dim == 3:
            self.points = self.degree + 1
        for part in (self.grid, self.walls, self.obstacle, self.fluid, self.bodies,
                     self.method, self.time):
            part()
        self.text = "\n".join(self.lines) + "\n"

    def section(self, name, **entries):
        self.lines.append(f"subsection {name}")
        for entry, value in entries.items():
            self.lines.append(f"  set {entry.replace('_', ' ')} = {value}")
        self.lines.append("end")

    def point(self, values, separator=", "):
        return separator.join(f"{value:.6g}" for value in values)

    def grid(self):
        self.section("Grid", Lower_corner=self.point([0.] * self.dim),
                     Upper_corner=self.point(self.size), Cell_size=self.h)

    def walls(self):
        walls = {}
        for side in SIDES[:2 * self.dim]:
            kinds = ["slip"] * 4 + ["no-slip", "unilateral", "friction"]
            if side in ("Right", "Top"):
                kinds.append("open")
            kind = self.chance.choice(kinds)
            self.slides |= kind in ("friction", "unilateral")
            if kind == "friction":
                walls[f"{side} friction"] = 0.01
            elif kind != "slip":
                walls[side] = kind
        if self.chance.random() < 0.25:
            self.moving = self.chance.uniform(0.2, 1.5) * self.h
            self.period = self.chance.uniform(0.3, 1.)
            self.slides = True
            walls.pop("Left friction", None)
            walls.pop("Left", None)
            walls["Left displacement"] = (
                f"{self.moving:.6g}*0.5*(1-cos(2*pi*t/{self.period:.6g}))")
        self.section("Walls", **walls)

    def obstacle(self):
        if self.chance.random() > 0.35:
            return
        lower = [self.chance.choice([0.5, 0.55, 0.6]) * self.size[0]] + [
            self.chance.choice([0., 0.2]) * size for size in self.size[1:]]
        upper = [low + self.chance.choice([1, 1.5, 2]) * self.h for low in lower]
        condition = self.chance.choice(["slip", "no-slip", "unilateral"])
        self.slides |= condition == "unilateral"
        self.section("Obstacle block", Lower_corner=self.point(lower),
                     Upper_corner=self.point(upper), Condition=condition)

    def fluid(self):
        acceleration = ["0"] * self.dim
        acceleration[-1] = f"-{GRAVITY}"
        self.soft = self.chance.random() < 0.15
        self.section("Body force", Acceleration="; ".join(acceleration))
        self.section("Fluid", Density=self.chance.choice([1, 1000]),
                     Dynamic_viscosity=self.chance.choice([0, 0.001, 0.1, 10]),
                     Bulk_modulus=self.chance.choice([1e5, 1e6]) if self.soft
                     else "infinite")

    def bodies(self):
        """One on the bottom or in the air, and up to two more in the air."""
        self.fastest = 0.
        for number in range(self.chance.choice([1, 1, 2, 3])):
            kinds = ["drop", "sheet", "ball"]
            if number == 0:
                kinds += ["column"] * 4 + ["film"]
            self.body(number, self.chance.choice(kinds))

    def body(self, number, kind):
        chance, h, size = self.chance, self.h, self.size
        spacing = h / self.points
        depth = chance.uniform(0.2, 0.5) * size[-1]
        middle = [chance.uniform(0.3, 0.4) * s for s in size[:-1]] + [
            chance.uniform(0.7, 0.75) * size[-1]]
        middle[0] = (0.2 + 0.28 * number) * size[0]
        speed = [chance.uniform(-1, 1) * chance.choice([0, 1, 4]) for _ in size]
        if kind == "column":
            lower = [0.] * self.dim
            upper = [chance.choice([1., chance.uniform(0.2, 0.8)]) * size[0],
                     *size[1:-1], depth]
            speed = [0.] * self.dim
        elif kind == "film":
            lower = [0.] * self.dim
            upper = [*size[:-1], chance.uniform(0.3, 1.2) * h]
            speed = [0.] * self.dim
        elif kind == "sheet":
            half = [0.12 * size[0]] + [0.2 * s for s in size[1:-1]] + [
                chance.uniform(0.5, 1.5) * spacing]
            lower = [m - a for m, a in zip(middle, half)]
            upper = [m + a for m, a in zip(middle, half)]
        else:
            radius = chance.uniform(1., 1.5) * spacing if kind == "drop" else 1.2 * h
            lower = [m - radius for m in middle]
            upper = [m + radius for m in middle]
        if lower[0] < 0.:  # short tanks: against the wall
            middle[0] -= lower[0]
            upper[0] -= lower[0]
            lower[0] = 0.
        entries = {"Shape": "box", "Lower_corner": self.point(lower),
                   "Upper_corner": self.point(upper)}
        if kind in ("drop", "ball"):
            entries = {"Shape": "ball", "Centre": self.point(middle),
                       "Radius": f"{radius:.6g}"}
        self.fastest = max(self.fastest, *map(abs, speed),
                           (GRAVITY * max(upper[-1], h)) ** 0.5)
        self.section(f"Fluid body b{number}", **entries,
                     Velocity=self.point(speed, "; "))

    def method(self):
        chance = self.chance
        self.scheme = "generalized midpoint" if self.slides else chance.choice(SCHEMES)
        mixed = not (self.soft and chance.random() < 0.5)
        transfer = {"Method": chance.choice(TRANSFERS)}
        if transfer["Method"] == "FLIP acceleration" and self.scheme != "newmark":
            transfer["Method"] = "affine FLIP"
        if self.degree == 2 and transfer["Method"] in ("XPIC", "FMPM"):
            transfer["Method"] = "FLIP"
        if transfer["Method"] == "PIC/FLIP blend":
            transfer["FLIP fraction"] = 0.95
        self.section("Formulation", Element_degree=self.degree,
                     **({} if mixed else {"Name": "displacement"}))
        self.section("Transfer", **transfer)
        self.section("Points", Per_cell_and_direction=self.points, Jitter=chance.choice([0, 0, 0.2, 0.4]))
        if chance.random() < 0.2:
            self.section("Quadrature", Rule="material points")
        elif chance.random() < 0.15 and self.degree == 1 and self.moving is None:
            self.section("Refinement surface", Level=1, Criterion="free surface")
            self.h /= 2

    def time(self):
        chance = self.chance
        step = chance.choice([0.1, 0.4]) * self.h / self.fastest
        end = chance.choice([10, 20, 30]) * step
        self.section("Time", Step=f"{step:.4g}", End_time=f"{end:.4g}", Scheme=self.scheme,
                     Step_control=chance.choice(["fixed", "CFL"]))
        if self.moving is not None:
            self.section("Force mover", Walls="left")

    def work_of_walls(self, rows):
        """On the fluid since the start, at the end of each row [J]."""
        def place(t):
            from math import cos, pi
            return self.moving * 0.5 * (1 - cos(2 * pi * t / self.period))
        if self.moving is None:
            return [0.] * len(rows)
        work, total, before = [], 0., 0.
        for row in rows:
            time, force = row["time [s]"], row.get("force mover x [N]") or 0.
            total += -force * (place(time) - place(before))
            before = time
            work.append(total)
        return work


def read_rows(folder):
    with open(folder / "statistics.csv", encoding="utf-8") as file:
        return [{key: float(value) if value else None for key, value in row.items()}
                for row in csv.DictReader(file)]


def energy_gain(scene, folder):
    """Largest rise above the running minimum, less the walls' work, over the start and
    what the walls have done."""
    rows = read_rows(folder)
    work = scene.work_of_walls(rows)
    own = [row["kinetic energy [J]"] + row["potential energy [J]"] - done
           for row, done in zip(rows, work)]
    scale = own[0] + max(map(abs, work))
    lowest, gain = own[0], 0.
    for value in own:
        lowest = min(lowest, value)
        gain = max(gain, (value - lowest) / scale) if scale > 0. else gain
    return gain


def start(seiche, file, folder, entries):
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS + 30))
        os.nice(10)
    options = [part for name, value in entries.items()
               for part in ("--set", f"{name} = {value}")]
    try:
        return subprocess.run([seiche, str(file), "--output", str(folder), *options],
                              text=True, capture_output=True, timeout=WALL_SECONDS,
                              preexec_fn=limit)
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess([], "hang", "", "")


def judge(seiche, number, base):
    """What is wrong with scene `number`, in a word, and a text; "" if nothing is."""
    scene = Scene(number)
    folder = base / str(number)
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "scene.prm"
    file.write_text(scene.text, encoding="utf-8")
    result = start(seiche, file, folder / "run", {})
    message = (result.stderr.strip().split("\n") or [""])[-1]
    if result.returncode == STOPPED:
        return "slow", message
    if result.returncode == NUMERICAL:
        end, taken = follow(lambda entries: start(seiche, file, folder / "advised",
                                                  entries), {}, STEPS_OF_ADVICE)
        kind = "failed" if end.returncode in (FINISHED, STOPPED) else "advice fails"
        return kind, f"{message}\n    taken: {', '.join(taken)} -> {end.returncode}"
    if result.returncode != FINISHED:
        return f"exit {result.returncode}", message
    with open(folder / "run" / "summary.json", encoding="utf-8") as summary:
        summary = json.load(summary)
    if summary["ledger"]["lost_points"] != 0:
        return "lost points", str(summary["ledger"]["lost_points"])
    gain = energy_gain(scene, folder / "run")
    if gain > LARGEST_GAIN:
        said = any(word in result.stdout + result.stderr for word in GAIN_IS_SAID)
        return ("gain that is said" if said else "silent gain"), f"{gain:.3g}"
    return "", ""


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("seiche")
    parser.add_argument("--count", type=int, default=NUMBERS.get(
        os.environ.get("SEICHE_RELIABILITY"), NUMBERS[None]))
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--folder", type=pathlib.Path)
    parser.add_argument("--show", type=int, help="print the scene of this number")
    options = parser.parse_args()
    if options.show is not None:
        print(Scene(options.show).text)
        return
    seiche = str(pathlib.Path(options.seiche).resolve())
    base = options.folder or pathlib.Path(tempfile.mkdtemp())
    numbers = range(options.first, options.first + options.count)
    found = {}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        results = pool.map(lambda number: judge(seiche, number, base), numbers)
        for number, (kind, text) in zip(numbers, results):
            if kind:
                found.setdefault(kind, []).append(number)
                print(f"{number}: {kind}: {text}", flush=True)
    if not options.folder:
        shutil.rmtree(base, ignore_errors=True)
    print(f"{options.count} scenes from {options.first}; "
          + ("; ".join(f"{kind} {len(which)}" for kind, which in sorted(found.items()))
             or "nothing found"))
    failed = len(found.pop("failed", []))
    for harmless in ("slow", "gain that is said"):
        found.pop(harmless, None)
    if found or failed > LARGEST_FAILED * options.count:
        sys.exit(1)


if __name__ == "__main__":
    main()
