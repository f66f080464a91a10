# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is compared: scenes, runs of each code, errors. See `benchmark`."""

import math
import os
import statistics
from dataclasses import dataclass

from curves import interpolate, read_curves

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


@dataclass
class Run:
    name: str
    code: str  # of codes.CODES
    arguments: list
    reference: str = None  # name of the run that its errors are taken against
    is_reference: bool = False

    @property
    def series(self):
        """What the plot joins by a line: the program."""
        return self.name.split()[0].rstrip(",")


@dataclass
class Case:
    title: str
    runs: list
    errors: dict  # {column: function(run folder, folder of the reference run or None)}
    time: str = "cpu_seconds"  # what the plot has on its axis
    by_default: bool = True  # run if no case is named

    def rows(self, results):
        """A dictionary a run: name, best and median times, errors. `results`:
        [(run, [(result, folder)])]."""
        folders = {run.name: rounds[0][1] for run, rounds in results if rounds}
        rows = []
        for run, rounds in results:
            if not rounds:
                continue
            first, folder = rounds[0]
            row = {"run": run.name, "version": first["version"], "rounds": len(rounds),
                   "steps": first["steps"], "newton": first.get("newton"),
                   "krylov": first.get("krylov"), "is_reference": run.is_reference,
                   "arguments": run.arguments, "series": run.series}
            for key in ("cpu_seconds", "seconds_a_step", "start_seconds"):
                values = [r[key] for r, _ in rounds if r.get(key) is not None]
                row[key] = min(values) if values else None
                row[key + " median"] = statistics.median(values) if values else None
            reference = folders.get(run.reference)
            for name, function in self.errors.items():
                needs = run.reference is not None
                row[name] = None if run.is_reference or (needs and reference is None) \
                    else function(folder, reference)
            rows.append(row)
        return rows


# ---- errors ----


def rms_difference(column, begin, end, scale, change=False):
    """rms over 50 times in begin..end of the difference to the reference run, over scale;
    change: of what has been added since the start."""

    def error(folder, reference):
        ours, theirs = read_curves(folder), read_curves(reference)
        for curves in (ours, theirs) if change else ():
            curves[column] = [value - curves[column][0] for value in curves[column]]
        times = [begin + (end - begin) * (i + 0.5) / 50 for i in range(50)]
        squares = [(interpolate(t, ours["t"], ours[column])
                    - interpolate(t, theirs["t"], theirs[column])) ** 2 for t in times]
        return math.sqrt(sum(squares) / len(squares)) / scale

    return error


def largest(column):
    """Of all times; None, too, if there is none."""
    return lambda folder, _: max(read_curves(folder).get(column, []), default=None) or None


def centre_pressure(folder, _):
    """rms of p(centre) of the patch over omega t <= 1.75, in rho omega^2 L^2."""
    table = os.path.join(ROOT, "prm", "benchmarks", "rotating_patch", "reference")
    exact = read_curves(table, "centre_pressure.csv")
    time, pressure = list(exact.values())[:2]
    curves, total, weight = read_curves(folder), 0.0, 0.0
    last = 0.0
    for t, end, p in zip(curves["t_pressure"], curves["t"], curves["p_centre"]):
        if end > 1.7501:
            break
        total += (end - last) * (p - interpolate(t, time, pressure)) ** 2
        weight, last = weight + end - last, end
    return math.sqrt(total / weight)


def against_record(column, begin, end):
    """rms over begin..end of the difference to the measured record of MARIN's tank."""

    def error(folder, _):
        table = os.path.join(ROOT, "prm", "benchmarks", "marin_box", "reference")
        record, curves = read_curves(table, "pressure_height.csv"), read_curves(folder)
        measured = record[next(name for name in record if name.split()[0] == column)]
        times = [begin + (end - begin) * (i + 0.5) / 300 for i in range(300)]
        own = curves["t_pressure" if column[0] == "P" and "t_pressure" in curves else "t"]
        squares = [(interpolate(t, own, curves[column])
                    - interpolate(t, record["t [s]"], measured)) ** 2 for t in times]
        return math.sqrt(sum(squares) / len(squares))

    return error


def harmonic(curves, column, omega, begin, end):
    """Amplitude and phase of A cos(omega t + phase) in begin..end, whole periods."""
    cosine = sine = 0.0
    samples = 400
    for i in range(samples):
        t = begin + (end - begin) * (i + 0.5) / samples
        value = interpolate(t, curves["t"], curves[column])
        cosine += 2 * value * math.cos(omega * t) / samples
        sine += 2 * value * math.sin(omega * t) / samples
    return math.hypot(cosine, sine), math.atan2(-sine, cosine)


def wave_error(which, omega, periods):
    """Loss of amplitude a period, or error of the frequency, of the difference of
    both ends' elevation, from the first period to the last."""

    def error(folder, _):
        curves = read_curves(folder)
        curves["wave"] = [a - b for a, b in zip(curves["left"], curves["right"])]
        period = 2 * math.pi / omega
        first = harmonic(curves, "wave", omega, 0, period)
        last = harmonic(curves, "wave", omega, (periods - 1) * period, periods * period)
        if which == "loss":
            return 1 - (last[0] / first[0]) ** (1 / (periods - 1))
        turn = math.remainder(last[1] - first[1], 2 * math.pi)
        return abs(turn) / (2 * math.pi * (periods - 1))

    return error


# ---- cases ----

DAM = "benchmarks/dam_break_2d/dam_break_2d.prm"
PATCH = "benchmarks/rotating_patch/rotating_patch.prm"
MARIN = "benchmarks/marin_box/marin_box.prm"
WAVE = "verification/standing_wave_small.prm"
ALIGNED = "verification/aligned_dam_break.prm"
TURNED = "verification/turned_dam_break.prm"
COLUMN = "benchmarks/column_collapse_3d/column_collapse_3d.prm"
# Cells that a refinement of the coarse mesh can make; steps of 0.01 s at most, as interFoam's.
H_DAM = {
    "0.05": [], "0.025": ["Grid/Cells x = 48, 80", "Grid/Cells y = 24, 96"],
    "0.0125": ["Grid/Cells x = 96, 160", "Grid/Cells y = 48, 192"],
}
# The front from the height on at which that of interFoam is taken (peers/openfoam.py).
FRONT = ["Front surge/Least height = 0.025"]
# As Kratos: displacements alone, Newmark, the points as quadrature, one step size.
LIKE_KRATOS = [
    "Formulation/Name = displacement", "Fluid/Bulk modulus = 1e5", "Quadrature/Rule = material points",
    "Time/Scheme = newmark", "Time/Step control = fixed", "Time/Step = 0.001",
    "Transfer/Method = FLIP acceleration", "Solver/Newton tolerance = 1e-4",
    "Free surface/Ghost acceleration = 0", "Free surface/Ghost velocity = 0",
    "Free surface/Point inertia = 0",
]


def dam_break():
    runs = [Run("seiche reference h 0.0125 CFL 0.25", "seiche",
                [DAM, *H_DAM["0.0125"], *FRONT, "Time/CFL number = 0.25", "Time/Step = 0.0025",
                 "Time/End time = 0.65"],
                is_reference=True),
            Run("interFoam reference h 0.0125 Co 0.25", "openfoam",
                ["dam_break", "--h", "0.0125", "--co", "0.25", "--tight", "--end", "0.65"],
                is_reference=True)]
    for h, entries in H_DAM.items():
        runs.append(Run(f"seiche h {h}", "seiche", [DAM, *entries, *FRONT], runs[0].name))
        runs.append(Run(f"interFoam h {h} Co 1", "openfoam", ["dam_break", "--h", h, "--co", "1"],
                        runs[1].name))
    # the geometric interface: named apart, so that its runs can be left out (--only)
    iso = ["--solver", "interIsoFoam"]
    runs.append(Run("interIsoFoam reference h 0.0125 Co 0.25", "openfoam",
                    ["dam_break", "--h", "0.0125", "--co", "0.25", "--tight", "--end", "0.65", *iso],
                    is_reference=True))
    reference = runs[-1].name
    for h in ("0.05", "0.025"):
        runs.append(Run(f"interIsoFoam h {h} Co 1", "openfoam",
                        ["dam_break", "--h", h, "--co", "1", *iso], reference))
    return Case("Dam break in two dimensions to 2.5 s; errors against each code's own run with "
                "h 0.0125 m and a Courant number of 0.25, front at y = 0.025 m to 0.5 s and height at the left wall to 0.6 s, "
                "rms over the column's height of 0.6 m", runs,
                {"front": rms_difference("front", 0, 0.5, 0.6),
                 "height": rms_difference("height", 0, 0.6, 0.6)})


def dam_break_short():
    """At the right wall particles of PySPH leave the tank, and it ends."""
    end = "0.65"
    runs = [Run("PySPH reference dx 0.00625", "pysph", ["0.00625", end], is_reference=True),
            Run("seiche reference h 0.0125 CFL 0.25", "seiche",
                [DAM, *H_DAM["0.0125"], *FRONT, "Time/CFL number = 0.25", "Time/Step = 0.0025",
                 f"Time/End time = {end}"], is_reference=True)]
    for dx in ("0.025", "0.0125"):
        runs.append(Run(f"PySPH dx {dx}", "pysph", [dx, end], runs[0].name))
    runs.append(Run("seiche h 0.05, points 0.0125 m apart", "seiche",
                    [DAM, *FRONT, f"Time/End time = {end}"], runs[1].name))
    return Case("Dam break in two dimensions to 0.65 s, beside smoothed particles; errors against each code's own run "
                "(PySPH: spacing 0.00625 m; Seiche: h 0.0125 m and a Courant number of 0.25)", runs,
                {"front": rms_difference("front", 0, 0.5, 0.6),
                 "height": rms_difference("height", 0, 0.6, 0.6)})


def rotating_patch():
    runs = []
    for h, dt in (("0.05", "0.05"), ("0.05", "0.025"), ("0.025", "0.0125")):
        runs.append(Run(f"seiche h {h} dt {dt}", "seiche",
                        [PATCH, f"Grid/Cell size = {h}", f"Time/Step = {dt}"]))
    for h in ("0.05", "0.025"):
        runs.append(Run(f"interFoam h {h} Co 0.25", "openfoam",
                        ["patch", "--h", h, "--co", "0.25", "--end", "1.75"]))
    return Case("Rotating square patch to omega t = 1.75", runs, {"p(centre)": centre_pressure})


def small_waves():
    """The scene's tank, started by its elevation in both codes."""
    omega, periods, h = 5.31655337, 10, 0.025
    end = 2 * math.pi * periods / omega
    runs = []
    for ratio in (0.1, 0.2, 0.4, 0.8, 2):
        a = ratio * h
        entries = [f"Time/End time = {end}", "Fluid body water/Shape = expression",
                   f"Fluid body water/Expression = y - 0.5 - {a}*cos(pi*x)",
                   "Fluid body water/Velocity = 0; 0",
                   "Gauge left/Position = 0.0125, 0", "Gauge right/Position = 0.9875, 0"]
        for points in (4, 2):
            runs.append(Run(f"seiche {points**2} points, A/h {ratio}", "seiche",
                            [WAVE, *entries, f"Points/Per cell and direction = {points}"]))
        runs.append(Run(f"interFoam Co 0.25, A/h {ratio}", "openfoam",
                        ["wave", "--h", str(h), "--co", "0.25", "--end", f"{end:.6f}",
                         "--amplitude", f"{a:.6g}"]))
    return Case("First mode of a closed tank, 40 x 28 cells, 10 periods (seiche: 60 steps a period)", runs,
                {"loss a period": wave_error("loss", omega, periods),
                 "frequency": wave_error("frequency", omega, periods)})


def kratos_2d():
    runs = [Run("kratos", "kratos", ["--h", "0.05", "--points", "16", "--steps", "50"]),
            Run("seiche, same settings", "seiche", [DAM, *LIKE_KRATOS, "Time/End time = 0.05"]),
            Run("seiche, mixed, defaults", "seiche",
                [DAM, "Time/Step control = fixed", "Time/Step = 0.001", "Time/End time = 0.05"])]
    return Case("Dam break, h 0.05 m, dt 0.001 s, 16 points a cell, 50 steps", runs, {},
                "seconds_a_step")


def kratos_3d():
    runs = [Run("kratos, amgcl", "kratos",
                ["--dim", "3", "--h", "0.02", "--points", "8", "--steps", "10", "--amgcl"]),
            Run("seiche, same settings", "seiche", [COLUMN, *LIKE_KRATOS, "Time/End time = 0.02"]),
            Run("seiche, mixed, defaults", "seiche", [COLUMN, "Time/End time = 0.04"])]
    return Case("Column in three dimensions, 8000 cells, 64000 points, dt 0.001 s (mixed: 0.002 s)", runs, {},
                "seconds_a_step")


def kratos_walls():
    """Seiche's walls of solids need the mixed form, Kratos has Newtonian fluids in the
    irreducible one alone."""
    runs = [Run("kratos, along the grid", "kratos_walls", [], is_reference=True)]
    for walls, settings in (("Lagrange", ["lagrange"]), ("Lagrange, contact", ["lagrange", "--contact"]),
                            ("perturbed 1e9", ["perturbed_lagrange", "--penalty", "1e9"]),
                            ("penalty 1e8", ["penalty", "--penalty", "1e8"])):
        runs.append(Run(f"kratos, turned, {walls}", "kratos_walls", ["--walls", *settings], runs[0].name))
    long = ["--dt", "0.005"]
    runs += [Run("kratos, along the grid, dt 0.005", "kratos_walls", long, is_reference=True),
             Run("kratos, turned, Lagrange, dt 0.005", "kratos_walls", ["--walls", "lagrange", *long],
                 "kratos, along the grid, dt 0.005")]
    common = ["Points/Per cell and direction = 4", "Time/Step control = fixed",
              "Formulation/Tau continuity time = 0.005"]
    for kappa, dt in (("1e5", "0.001"), ("infinite", "0.001"), ("infinite", "0.005")):
        entries = [*common, f"Fluid/Bulk modulus = {kappa}", f"Time/Step = {dt}"]
        name = f"bulk modulus {kappa}, dt {dt}"
        along = Run(f"seiche, along the grid, {name}", "seiche", [ALIGNED, *entries], is_reference=True)
        runs += [along, Run(f"seiche, turned, {name}", "seiche", [TURNED, *entries], along.name)]
    return Case("Dam break to 0.9 s in a tank turned by 30 degrees against the grid, h 0.05 m, dt 0.001 s if not "
                "said, 16 points a cell; rms of kinetic energy (over 576 J) and fall (over the column's 1059 J) "
                "against the same code in a tank along the grid", runs,
                {"kinetic energy": rms_difference("kinetic", 0, 0.9, 576),
                 "fall": rms_difference("potential", 0, 0.9, 1059, change=True),
                 "points 0.1 h beyond walls": largest("outside"),
                 "steps not converged": largest("unconverged")}, "seconds_a_step")


def marin(sizes, by_default):
    """Steps by the Courant number alone, in both codes."""
    runs = []
    for h, level in sizes:
        levels = [f"Refinement {name}/Level = {level - coarser}"
                  for name, coarser in (("surface", 0), ("box", 0), ("inside", 1))]
        runs.append(Run(f"seiche h {h}", "seiche", [MARIN, *levels, "Time/Step = 0.02"]))
        runs.append(Run(f"interFoam h {h} Co 1", "openfoam", ["marin", "--h", h, "--co", "1", "--end", "3"]))
    return Case("Dam break against a box in three dimensions to 3 s; rms against the measured record, "
                "depth in m, pressure in Pa", runs,
                {"H1": against_record("H1", 0, 3), "H2": against_record("H2", 0, 3),
                 "H2 to 1.3 s": against_record("H2", 0, 1.3), "H3": against_record("H3", 0, 3),
                 "H4": against_record("H4", 0, 3), "P1": against_record("P1", 0.4, 3),
                 "P3": against_record("P3", 0.4, 3), "P5": against_record("P5", 0, 3)},
                by_default=by_default)


CASES = {"dam_break_2d": dam_break(), "dam_break_short": dam_break_short(),
         "rotating_patch": rotating_patch(),
         "small_waves": small_waves(),
         "kratos_2d": kratos_2d(), "kratos_3d": kratos_3d(),
         "kratos_walls": kratos_walls(), "marin": marin((("0.08", 1), ("0.04", 2)), by_default=True),
         "marin_fine": marin((("0.02", 3),), by_default=False)}
