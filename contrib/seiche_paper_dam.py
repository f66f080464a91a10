# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 7 to 10 of the founding paper: the dam break in two dimensions."""

import matplotlib.pyplot as plt
import numpy

from seiche_output import read_frame
from seiche_paper import (
    COLOUR, OURS, RECIPE, colour_bar, draw_points, label_edges, reference, save)
from seiche_paper_numbers import best_shift, mean_between, smoothed

STUDY = "dam_break_2d"
SMOOTHING = 0.02  # [s] of the sensors: keeps the first peak
HEIGHT, GATE, LENGTH, GRAVITY, DENSITY = 0.6, 1.2, 3.22, 9.81, 1000.0
TIME_UNIT = (HEIGHT / GRAVITY) ** 0.5
PRESSURE_UNIT = DENSITY * GRAVITY * HEIGHT
FRONT_LAST = 0.5  # [s] before the front is at the wall
WINDOW = (0.9, 1.3)  # [s] after the first impact
ROWS = ((RECIPE, "paper, mixed"), (OURS, "mixed"))
PRESSURE, TOP = (0.0, 6000.0), 1.5  # [Pa], [m] of the panels


def record(name):
    """Columns of the experiment, times in s."""
    columns = reference("benchmarks", STUDY, "reference", name + ".csv")
    columns[0] *= TIME_UNIT
    return columns


def displacement(variant, frame):
    """Distance of every point from its place at the start."""
    first = read_frame(variant.frames[0][1])
    number = [sum(f["id %s bits" % part].astype(float) * 2.0**power
                  for part, power in (("low", 0), ("middle", 24), ("high", 48)))
              for f in (first, frame)]
    order = numpy.argsort(number[0])
    found = order[numpy.searchsorted(number[0], number[1], sorter=order)]
    return numpy.linalg.norm(frame["points"] - first["points"][found], axis=1)


def evolution(dam, output, numbers):
    """Figure 7: pressure and displacement at 0.5, 1.4, 1.7, 2.5 s."""
    figure, all_axes = plt.subplots(4, 4, figsize=(16, 9), sharex=True, sharey=True,
                                    layout="constrained")
    for row, time in zip(all_axes, (0.5, 1.4, 1.7, 2.5)):
        for i, (method, name) in enumerate(ROWS):
            frame = dam[name].frame_at(time)
            moved = displacement(dam[name], frame) if frame else None
            draw_points(row[i], frame, "pressure", PRESSURE, "viridis", dam[name].ending())
            draw_points(row[2 + i], frame, moved, (0, 3), "plasma", dam[name].ending())
            for axes, what in ((row[i], "pressure"), (row[2 + i], "displacement")):
                axes.set(xlim=(0, LENGTH), ylim=(0, TOP))
                axes.set_title("%s, %s, t = %g s" % (method, what, time))
    label_edges(all_axes, "x [m]", "y [m]")
    colour_bar(figure, all_axes[:, :2], PRESSURE, "viridis", "p [Pa]", location="bottom",
               shrink=0.5, aspect=40, extend="both")
    colour_bar(figure, all_axes[:, 2:], (0, 3), "plasma", "displacement [m]", location="bottom",
               shrink=0.5, aspect=40)
    save(figure, output, "figure_07_dam_evolution")


def formulations(dam, output, numbers):
    """Figure 8: mixed beside irreducible at 0.5 and 1.4 s."""
    limits = (-2000, 6000)
    columns = ((RECIPE, "mixed", "paper, mixed"), (RECIPE, "irreducible", "paper, irreducible"),
               (OURS, "mixed", "mixed"), (OURS, "irreducible", "irreducible, kappa 1e5"))
    figure, all_axes = plt.subplots(2, 4, figsize=(16, 5.2), sharex=True, sharey=True,
                                    layout="constrained")
    for row, time in zip(all_axes, (0.5, 1.4)):
        for axes, (method, form, name) in zip(row, columns):
            draw_points(axes, dam[name].frame_at(time), "pressure", limits, "viridis",
                        dam[name].ending())
            axes.set(xlim=(0, LENGTH), ylim=(0, TOP))
            axes.set_title("%s, %s, t = %g s" % (method, form, time))
    label_edges(all_axes, "x [m]", "y [m]")
    colour_bar(figure, all_axes, limits, "viridis", "p [Pa]", location="bottom", shrink=0.5,
               aspect=50, extend="both")
    save(figure, output, "figure_08_dam_formulations")


CURVES = (  # variant, label, line
    ("paper, mixed", "%s, mixed" % RECIPE, dict(color=COLOUR[RECIPE], lw=1.6)),
    ("paper, irreducible", "%s, irreducible" % RECIPE, dict(color=COLOUR[RECIPE], lw=1, ls="--")),
    ("mixed", "%s, mixed" % OURS, dict(color=COLOUR[OURS], lw=1.6)),
    ("mixed, CFL 0.9", "%s, mixed, CFL 0.9" % OURS, dict(color="C2", lw=1.2)),
    ("irreducible, kappa 1e5", r"%s, irreducible, $\kappa = 10^5$ Pa" % OURS,
     dict(color=COLOUR[OURS], lw=1, ls="--")),
    ("irreducible, kappa 1e6", r"%s, irreducible, $\kappa = 10^6$ Pa" % OURS,
     dict(color=COLOUR[OURS], lw=1, ls=":")),
)


def compare_front(name, time, front, experiment, numbers):
    """Against the experiment up to FRONT_LAST; the shift, or None."""
    fitted = best_shift(time, front, *experiment, FRONT_LAST)
    unmoved = best_shift(time, front, *experiment, FRONT_LAST, largest=0)
    numbers.add("Figure 9: dam break, front against Lobovsky et al. to %g s" % FRONT_LAST, name, **{
        "one shift of its clock [s]": fitted and fitted[0],
        "rms over H": fitted and fitted[1] / HEIGHT,
        "rms over H without a shift": unmoved and unmoved[1] / HEIGHT})
    return fitted and fitted[0]


def front(dam, output, numbers):
    """Figure 9: height at the wall and front against experiments."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(12.5, 5), layout="constrained")
    t, x = record("lobovsky_front")
    experiment = (t, GATE + HEIGHT * x)
    shifts = {}
    for name, label, line in CURVES:
        time, height = dam[name].series("gauge column [m]", "time [s]")
        if len(time):
            place = dam[name].series("front half_cell [m]", "time [s]")[1]
            left.plot(time, height, label=label, **line)
            right.plot(time, place, label=label, **line)
            shifts[name] = compare_front(name, time, place, experiment, numbers)
    foam = reference("benchmarks", STUDY, "reference", "interfoam.csv")
    left.plot(foam[0], foam[2], "k-.", lw=0.9, label="interFoam, h = 0.025 m")
    right.plot(foam[0], foam[1], "k-.", lw=0.9, label="interFoam, h = 0.025 m, y = 0.0125 m")
    shifts["interFoam"] = compare_front("interFoam", foam[0], foam[1], experiment, numbers)
    # One for the picture: this code's, or the first that there is.
    shift = next(shifts[name] for name in ("mixed", "paper, mixed", "interFoam")
                 if shifts.get(name) is not None)
    right.plot(t, experiment[1], ".", color="0.7", ms=3, label="Lobovsky et al. 2014, as recorded")
    right.plot(t - shift, experiment[1], "k.", ms=4,
               label="the same, %.0f ms %s" % (1000 * abs(shift), "earlier" if shift > 0 else "later"))
    t, x = record("martin_moyce_front_square_column")
    right.plot(t, GATE + HEIGHT * x, "k^", ms=4, mfc="none", label="Martin, Moyce 1952")
    left.set(ylabel="height of the column at x = 0 [m]", ylim=(0.35, 0.65))
    right.set(ylabel="x of the front at y = 0.025 m [m]", ylim=(1.15, 3.3))
    for axes, place in ((left, "lower left"), (right, "upper left")):
        axes.set(xlim=(0, 0.8), xlabel="t [s]")
        axes.grid(alpha=0.3)
        axes.legend(loc=place, fontsize=7)
    right.set_xlim(0, 0.7)
    save(figure, output, "figure_09_dam_front")


def draw_record(axes, columns, foam, foam_column):
    t, low, median, high = columns
    axes.fill_between(t, PRESSURE_UNIT * low / 1e3, PRESSURE_UNIT * high / 1e3, color="0.85",
                      label="experiment, 95 %")
    axes.plot(t, PRESSURE_UNIT * median / 1e3, color="0.35", lw=1, label="experiment, median")
    axes.plot(foam[0], foam[foam_column] / 1e3, "k-.", lw=0.8, label="interFoam")


def compare_sensor(name, sensor, time, p, numbers):
    """Mean after the impact, and the first peak; p smoothed."""
    result = mean_between(time, p, *WINDOW)
    before = time < WINDOW[0]
    numbers.add("Figure 10: dam break, pressures smoothed over %g s" % SMOOTHING, name, **{
        "%s, mean %g to %g s [Pa]" % (sensor, *WINDOW): result and result[0],
        "%s, deviation there [Pa]" % sensor: result and result[1],
        "%s, peak before [Pa]" % sensor: p[before].max() if result else None})


def sensors(dam, output, numbers):
    """Figure 10: pressures of sensors 1 and 4 to 2.5 s."""
    figure, all_axes = plt.subplots(2, 2, figsize=(15, 7.5), sharex=True, layout="constrained")
    foam = reference("benchmarks", STUDY, "reference", "interfoam.csv")
    groups = ("mixed form", [c for c in CURVES if "irreducible" not in c[0]]), \
        ("irreducible form", [c for c in CURVES if "irreducible" in c[0]])
    for column, sensor, foam_column in zip(all_axes.T, ("sensor1", "sensor4"), (3, 4)):
        columns = record("lobovsky_" + sensor)
        for axes, (title, curves) in zip(column, groups):
            draw_record(axes, columns, foam, foam_column)
            for name, label, line in curves:
                time, p = dam[name].series("probe %s pressure [Pa]" % sensor)
                if len(time):
                    mean = smoothed(time, p, SMOOTHING)
                    axes.plot(time, p / 1e3, lw=0.4, alpha=0.35, color=line["color"])
                    axes.plot(time, mean / 1e3, label=label, **{**line, "lw": 1.2})
                    compare_sensor(name, sensor, time, mean, numbers)
            axes.set(xlim=(0, 2.5), ylim=(-1.5, 1.35e-3 * PRESSURE_UNIT * columns[3].max()))
            axes.set(ylabel="p [kPa]", title="sensor %s, %s" % (sensor[-1], title))
            axes.grid(alpha=0.3)
        compare_sensor("experiment, median, not smoothed", sensor, columns[0],
                       PRESSURE_UNIT * columns[2], numbers)
        compare_sensor("interFoam, not smoothed", sensor, foam[0], foam[foam_column], numbers)
        column[-1].set_xlabel("t [s]")
    for axes in all_axes[:, 1]:
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1))
    figure.suptitle("Pressure at the right wall (thin: raw, thick: mean over %g s)" % SMOOTHING)
    save(figure, output, "figure_10_dam_sensors")


FIGURES = (evolution, formulations, front, sensors)
