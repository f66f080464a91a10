# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 12 to 14 of the founding paper: the dam break onto a building."""

import csv
import os

import matplotlib.pyplot as plt
import numpy
from matplotlib.colors import LinearSegmentedColormap

from seiche_output import field
from seiche_paper import COLOUR, OURS, RECIPE, ROOT, colour_bar, save, say
from seiche_paper_numbers import smoothed
from seiche_sections import columns_of, depth, draw_section, near_plane
from seiche_stage import rectangle
from seiche_views import View

STUDY = "obstacle_3d"
ROWS = ((RECIPE, "paper"), (OURS, "this code"))
SYMMETRY = 0.6  # [m] y of the plane
SMOOTHING = 0.02  # [s]
EYE = (-0.5, -0.9, 0.95)  # where the views are seen from: the face and the gate
SHOWN = 1.9  # [m] end of the views; the floodplain beyond it is dry
DEEPEST = 0.1  # [m] of the reservoir at the start, the deep end of the colours
WATER = LinearSegmentedColormap.from_list(
    "water", ("#d3eef7", "#8ccbe6", "#3f97cf", "#1a5ba6", "#0a2a66"))
BALL = 1.6  # drawn radius of a point over half its edge: the surface closes
FASTEST = 1.6  # [m/s] end of the colours of the section
FRONT_FACE = "force front_face x [N]"
TIMES = (0.32, 0.38, 0.52, 0.60, 0.68, 0.74)  # of figures 12 and 13


def depths_at(points, values, edges):
    """Depth at the points: bilinear between the middles of the wet columns."""
    index = []
    for d in (0, 1):
        width = edges[d][1] - edges[d][0]
        place = (points[:, d] - edges[d][0]) / width - 0.5
        low = numpy.clip(numpy.floor(place).astype(int), 0, max(values.shape[d] - 2, 0))
        high = numpy.minimum(low + 1, values.shape[d] - 1)
        index.append((low, high, numpy.clip(place - low, 0, 1)))
    (i, i1, a), (j, j1, b) = index
    total = weight = 0.0
    for k, share_x in ((i, 1 - a), (i1, a)):
        for l, share_y in ((j, 1 - b), (j1, b)):
            wet = share_x * share_y * (values[k, l] > 0)
            total, weight = total + wet * values[k, l], weight + wet
    return total / numpy.maximum(weight, 1e-12)


def evolution(runs, output, numbers):
    """Figure 12: the water in three dimensions, coloured by its depth."""
    figure, all_axes = plt.subplots(4, 2, figsize=(12, 15.5), layout="constrained")
    view = None
    for row, time in zip(all_axes, (0.32, 0.38, 0.52, 0.60)):
        for axes, (method, name) in zip(row, ROWS):
            axes.set_title("%s, t = %.2f s" % (method, time), fontsize=10)
            frame = runs[name].frame_at(time)
            if frame is None:
                say(axes, runs[name].ending())
                axes.set_axis_off()
                continue
            walls = runs[name].run.walls_at(0)
            view = view or View(walls.lower, [SHOWN, *walls.upper[1:]], EYE, 800, walls.obstacles)
            edges = columns_of(walls.lower, walls.upper, frame)
            height = depths_at(frame["points"], depth(frame, edges), edges)
            colours = WATER(numpy.clip(height / DEEPEST, 0, 1))[:, :3]
            image = view.picture(frame["points"], BALL * field(frame, "radius"), colours)
            view.draw(axes, image, {0: (0, 0.4, 0.8, 1.2, 1.6), 1: (0, 0.4, 0.8, 1.2)})
    colour_bar(figure, all_axes, (0, DEEPEST), WATER, "depth of the water [m]", location="bottom",
               shrink=0.5, aspect=40, extend="max")
    save(figure, output, "figure_12_obstacle_evolution")


def section(runs, output, numbers):
    """Figure 13: velocity in the plane of symmetry."""
    times = (0.32, 0.52, 0.60, 0.68, 0.74)
    figure, all_axes = plt.subplots(5, 2, figsize=(13, 12.2), sharex=True, sharey=True,
                                    layout="constrained")
    for row, time in zip(all_axes, times):
        for axes, (method, name) in zip(row, ROWS):
            axes.set(xlim=(0.6, 1.5), ylim=(0, 0.25), aspect="equal")
            axes.set_title("%s, t = %.2f s" % (method, time))
            frame = runs[name].frame_at(time)
            if frame is None:
                say(axes, runs[name].ending())
                continue
            draw_section(axes, *near_plane(frame, SYMMETRY), FASTEST, 0.03, size=9)
            for low, high in runs[name].run.walls_at(0).obstacles:
                if low[1] <= SYMMETRY <= high[1]:
                    rectangle(axes, low[[0, 2]], high[[0, 2]], fc="0.6", ec="k", lw=0.6)
    for axes in all_axes[-1]:
        axes.set_xlabel("x [m]")
    for axes in all_axes[:, 0]:
        axes.set_ylabel("z [m]")
    colour_bar(figure, all_axes, (0, FASTEST), "viridis", "speed [m/s]", location="bottom",
               shrink=0.5, aspect=40, extend="max")
    figure.suptitle("Velocity in the plane of symmetry, y = %g m" % SYMMETRY)
    save(figure, output, "figure_13_obstacle_section")


def stated_peak():
    """(value [N], what it is) of the only force that texts state."""
    folder = os.path.join(ROOT, "prm", "benchmarks", "aureli_obstacle", "reference")
    with open(os.path.join(folder, "stated_values.csv"), newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["quantity"].startswith("peak force")]
    return float(rows[0]["value"]), "peak of a 2D shallow-water computation (stated)"


def compare_force(name, time, force, mean, numbers):
    wet = force > 0.5
    title = "Figure 14: building, force on the front face"
    numbers.add(title, name, **{
        "above 0.5 N from [s]": time[wet][0] if wet.any() else None,
        "largest step [N]": force.max(), "largest step at [s]": time[force.argmax()],
        "largest mean of %g ms [N]" % (1000 * SMOOTHING): mean.max(),
        "largest mean at [s]": time[mean.argmax()],
        "impulse to %g s [N s]" % round(time[-1], 2): float(
            numpy.sum(0.5 * (force[1:] + force[:-1]) * numpy.diff(time)))})
    for at in TIMES:
        value = float(numpy.interp(at, time, mean)) if at <= time[-1] else None
        numbers.add(title, name, **{"mean at %g s" % at: value})


def force(runs, output, numbers):
    """Figure 14: force on the front face of the building."""
    figure, axes = plt.subplots(figsize=(10, 5.2), layout="constrained")
    highest = 8.0
    for method, name in ROWS:
        time, values = runs[name].series(FRONT_FACE)
        if len(time) == 0:
            continue
        mean = smoothed(time, values, SMOOTHING)
        axes.plot(time, values, lw=0.6, alpha=0.45, color=COLOUR[method],
                  label="%s, every step" % method)
        axes.plot(time, mean, lw=1.8, color=COLOUR[method],
                  label="%s, mean of %g ms" % (method, 1000 * SMOOTHING))
        highest = max(highest, 1.4 * mean.max())
        compare_force(method, time, values, mean, numbers)
    value, label = stated_peak()
    axes.axhline(value, color="k", ls="--", lw=1, label="%g N: %s" % (value, label))
    axes.set(xlim=(0, 1), ylim=(-0.5, highest), xlabel="t [s]",
             ylabel="force on the front face [N]")
    axes.grid(alpha=0.3)
    axes.legend(loc="upper left")
    save(figure, output, "figure_14_obstacle_force")


FIGURES = (evolution, section, force)
