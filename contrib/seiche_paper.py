# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the figures of the founding paper have in common: the runs of a study,
references, panels of points, colour bars, files. Used by seiche_paper_*.py."""

import csv
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy
from matplotlib.collections import EllipseCollection

from seiche_output import Run, field, read_frame

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
RECIPE, OURS = "founding paper's recipe", "this code"
COLOUR = {RECIPE: "C1", OURS: "C0"}
NEAR = 0.02  # [s] how far a frame may be from the time of a picture
OVERLAP = 1.8  # diameter of a drawn point over the spacing

plt.rcParams.update({
    "font.size": 9, "axes.titlesize": 9, "axes.labelsize": 9, "legend.fontsize": 8,
    "xtick.labelsize": 8, "ytick.labelsize": 8, "figure.titlesize": 11,
})


class Variant:
    """A run of a study; one that was not run has no frames and no series."""

    def __init__(self, run=None, row=None):
        self.run, self.row = run, row
        self.frames = run.frames("points") if run else []

    def frame_up_to(self, time):
        """(time, frame) of the last frame until then, or (None, None)."""
        past = [frame for frame in self.frames if frame[0] <= time + NEAR]
        return (past[-1][0], read_frame(past[-1][1])) if past else (None, None)

    def frame_at(self, time):
        """The frame of that time, or None if the run did not get there."""
        if not self.frames:
            return None
        nearest = min(self.frames, key=lambda frame: abs(frame[0] - time))
        return read_frame(nearest[1]) if abs(nearest[0] - time) <= NEAR else None

    def series(self, column, time="pressure_time [s]"):
        """(times, values) of a column without the row before the first step,
        which has no pressures; empty without a run."""
        columns = self.run.statistics if self.run else {}
        if column not in columns or len(columns[column]) < 3:
            return numpy.zeros(0), numpy.zeros(0)
        return columns[time][1:], columns[column][1:]

    def ending(self):
        """Why there is no picture."""
        if self.row is None:
            return "not run"
        return "ended at t = %.3f s\n(%s)" % (
            float(self.row["end_time"] or 0), self.row["cause"] or "as asked")


class Runs(dict):
    """{name: Variant} of a study, in the order of its table. The name is that of
    the variant, or its values of scene and settings."""

    def __init__(self, output, study):
        super().__init__()
        self.path = os.path.join(output, study, "results.csv")
        if os.path.isfile(self.path):
            with open(self.path, newline="", encoding="utf-8") as file:
                for row in csv.DictReader(file):
                    run = Run(os.path.join(output, study, "runs", row["folder"], "run"))
                    name = row.get("variant") or "%s: %s" % (row["scene"], row["settings"])
                    self[name] = Variant(run, row)

    def __missing__(self, name):
        return Variant()


def reference(*path):
    """Columns of a CSV file below prm/ with one header line."""
    with open(os.path.join(ROOT, "prm", *path), newline="") as file:
        return numpy.array([[float(v) for v in row] for row in list(csv.reader(file))[1:]]).T


def say(axes, message):
    """A message in the middle of an empty panel."""
    axes.text(0.5, 0.5, message, transform=axes.transAxes, ha="center", va="center", color="0.4")


def draw_points(axes, frame, values, limits, colours, message):
    """Points of the size they have [m], coloured by values (the name of a field
    or an array); a message instead if there is no frame."""
    axes.set_aspect("equal")
    if frame is None:
        say(axes, message)
        return
    values = field(frame, values) if isinstance(values, str) else values
    size = OVERLAP * 2 * field(frame, "radius")
    points = EllipseCollection(
        size, size, numpy.zeros(len(size)), units="xy", offsets=frame["points"][:, :2],
        offset_transform=axes.transData, array=values, cmap=colours, clim=limits, lw=0,
        antialiased=False, rasterized=True)
    axes.add_collection(points)


def colour_bar(figure, axes, limits, colours, label, **options):
    """One for all these axes, whether there are points in them or not."""
    mappable = plt.cm.ScalarMappable(plt.Normalize(*limits), cmap=colours)
    return figure.colorbar(mappable, ax=list(numpy.ravel(axes)), label=label, **options)


def label_edges(all_axes, x, y):
    """Labels at the lower and left edge of panels that share their scales."""
    for axes in all_axes[-1, :]:
        axes.set_xlabel(x)
    for axes in all_axes[:, 0]:
        axes.set_ylabel(y)


def save(figure, output, name, dpi=100):
    path = os.path.join(output, name + ".png")
    figure.savefig(path, dpi=dpi, bbox_inches="tight")
    plt.close(figure)
    print(path)
