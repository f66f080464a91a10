# SPDX-License-Identifier: LGPL-2.1-or-later
"""Water, walls and obstacles of a run on matplotlib's axes: what the pictures and the
film of a run share, so that colours and scales are the same in all of them.

    stage = make_stage(run, frames, "pressure")    frames: [(time, file)] of the points
    stage.draw(axes, stage.load(time, file))
    stage.colour_bar(figure, axes)
"""

import collections

import matplotlib.pyplot as plt
import numpy
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.colors import LinearSegmentedColormap, ListedColormap, to_rgb
from matplotlib.ticker import MaxNLocator

from seiche_output import field, read_frame
from seiche_views import View
from seiche_water import scalar, water_of

FIELDS = {"pressure": "pressure [Pa]", "speed": "speed [m/s]", "plain": None}
COLOURS = {
    "pressure": plt.get_cmap("viridis"),
    "speed": LinearSegmentedColormap.from_list(  # slow water is dark, fast water like foam
        "water", ("#0b3c6f", "#1f6fb2", "#4da3d9", "#9fd3ec", "#e9f7fb")),
}
WATER = "#4b9cd3"  # without a field, or before there is one
SOLID = "#8b8b8b"
SAMPLED = 20  # frames that limits and extents are taken from
VIEW = (-0.8, -1.6, 1.0)  # direction to the eye, 3D
THICKNESS = 0.02  # of a drawn wall over the longest side of the picture
SILENT = 1e-9  # [Pa] round-off, not a pressure
TICK = 45  # pixels along an edge from label to label at least, 3D
BALL = 1.25  # drawn radius of a drop over half the edge of its point

# time [s], points (read_frame), their water, Walls, whether there is a pressure
Frame = collections.namedtuple("Frame", "time points water walls known")


def sampled(frames, number):
    """About `number` of them, evenly spread, the first and last included."""
    if len(frames) <= number:
        return list(frames)
    return [frames[i] for i in numpy.rint(numpy.linspace(0, len(frames) - 1, number)).astype(int)]


def is_known(name, time, points):
    """False for the pressure before the first step."""
    return name == "speed" or (
        name == "pressure" and (time > 0 or bool(numpy.any(field(points, name) != 0))))


class Stage:
    """Limits of the colours, the walls of all times and the room that is shown."""

    def __init__(self, run, frames, name):
        self.run, self.name, self.dim = run, name, run.dim
        low, high, limits = [], [], []
        for time, path in sampled(frames, SAMPLED):
            points = read_frame(path)
            if len(points["points"]) == 0:
                continue
            radius = float(numpy.median(field(points, "radius")))
            low.append(points["points"][:, :self.dim].min(axis=0) - radius)
            high.append(points["points"][:, :self.dim].max(axis=0) + radius)
            if is_known(name, time, points):
                limits.append(numpy.percentile(scalar(points, name), (1, 99)))
        if not low:
            raise ValueError("no frames with points")
        self.reached = numpy.min(low, axis=0), numpy.max(high, axis=0)
        # spray has the greatest values; it must not take the whole scale
        limits = numpy.array(limits or [(0, 1)])
        self.limits = min(0.0, limits[:, 0].min()), max(limits[:, 1].max(), 1e-12)
        if name == "pressure" and abs(limits).max() < SILENT:
            self.name = "plain"
        at_times = [run.walls_at(time) for time, _ in sampled(frames, SAMPLED)]
        self.box = (numpy.min([w.lower for w in at_times], axis=0),
                    numpy.max([w.upper for w in at_times], axis=0))
        self.open_sides = at_times[0].open_sides
        span = [(w.lower, w.upper) for w in at_times]
        self.moving = {(d, side) for d in range(self.dim) for side in (0, 1)
                       if numpy.ptp([s[side][d] for s in span]) > 1e-9}

    def load(self, time, path):
        points = read_frame(path)
        points["points"] = points["points"].astype(float)
        return Frame(time, points, water_of(self.run, time, points), self.run.walls_at(time),
                     is_known(self.name, time, points))

    def colour_bar(self, figure, axes, **options):
        """The bar that all pictures share, none for plain water."""
        if FIELDS[self.name]:
            mappable = plt.cm.ScalarMappable(plt.Normalize(*self.limits), COLOURS[self.name])
            extend = "both" if self.limits[0] < 0 else "max"
            figure.colorbar(mappable, ax=axes, label=FIELDS[self.name], extend=extend,
                            **{"shrink": 0.8, "aspect": 30, **options})

    def colours(self, frame, values):
        """Colours [n, 3] of values."""
        if not frame.known:
            return numpy.tile(to_rgb(WATER), (len(values), 1))
        return COLOURS[self.name](plt.Normalize(*self.limits)(values))[:, :3]

    def field_of(self, frame):
        """The field that there is at this time, to look up in the frame."""
        return self.name if frame.known else "speed"

    def drops(self, frame):
        """Centres, half edges and values of the points outside the water."""
        loose = frame.water.spray(frame.points["points"])
        return (frame.points["points"][loose], field(frame.points, "radius")[loose].astype(float),
                scalar(frame.points, self.field_of(frame))[loose])

    def pistons(self, walls, thickness):
        """Boxes [(lower, upper)] behind the sides that move, as thick as [m]."""
        result = []
        for d, side in sorted(self.moving):
            low, high = self.box[0].copy(), self.box[1].copy()
            low[d], high[d] = ((walls.lower[d] - thickness, walls.lower[d]) if side == 0
                               else (walls.upper[d], walls.upper[d] + thickness))
            result.append((low, high))
        return result


class Stage2D(Stage):
    def __init__(self, run, frames, name):
        super().__init__(run, frames, name)
        low, high = self.reached
        margin = 0.06 * (high - low).max()
        self.thickness = THICKNESS * (numpy.minimum(high, self.box[1])
                                      - numpy.maximum(low, self.box[0])).max()
        beyond = 1.5 * self.thickness
        self.low = numpy.maximum(low - margin, self.box[0] - beyond)
        self.high = numpy.minimum(high + margin, self.box[1] + beyond)
        for low_corner, high_corner in run.walls_at(0).obstacles:  # none cut off
            self.high = numpy.maximum(self.high, numpy.minimum(high_corner + 0.5 * margin, self.box[1]))
            self.low = numpy.minimum(self.low, numpy.maximum(low_corner - 0.5 * margin, self.box[0]))
        for d in run.periodic():  # what lies beyond is shown at the other side
            self.low[d], self.high[d] = self.box[0][d], self.box[1][d]
        self.ratio = (self.high[1] - self.low[1]) / (self.high[0] - self.low[0])

    def prepare(self, axes):
        axes.set(xlim=(self.low[0], self.high[0]), ylim=(self.low[1], self.high[1]), aspect="equal",
                 xlabel="x [m]", ylabel="y [m]")
        # a frame only where no wall is drawn
        for name, (d, side) in {"left": (0, 0), "right": (0, 1), "bottom": (1, 0), "top": (1, 1)}.items():
            wall, end = self.box[side][d], (self.low, self.high)[side][d]
            is_seen = (end - wall) * (2 * side - 1) > 0 and (d, side) not in self.open_sides
            axes.spines[name].set_visible(not is_seen)
            axes.spines[name].set(color="0.75", linewidth=0.6)

    def draw(self, axes, frame):
        self.prepare(axes)
        axes.set_title("t = %.3f s" % frame.time, fontsize=10)
        corners, values = frame.water.triangles(self.field_of(frame))
        if len(corners):
            numbers = numpy.arange(3 * len(corners)).reshape(-1, 3)
            colours = self.colours(frame, values.ravel())
            if frame.known:
                axes.tripcolor(*corners.reshape(-1, 2).T, numbers, values.ravel(), shading="gouraud",
                               cmap=COLOURS[self.name], vmin=self.limits[0], vmax=self.limits[1],
                               rasterized=True)
            else:
                axes.tripcolor(*corners.reshape(-1, 2).T, numbers, numpy.zeros(values.size),
                               shading="gouraud", cmap=ListedColormap([colours[0]]),
                               rasterized=True)
        centres, radii, values = self.drops(frame)
        size = 2 * BALL * radii
        axes.add_collection(EllipseCollection(
            size, size, numpy.zeros(len(size)), units="xy", offsets=centres[:, :2],
            offset_transform=axes.transData, facecolors=self.colours(frame, values), lw=0))
        axes.add_collection(LineCollection(frame.water.outline(), colors="#0b2a45", linewidths=0.9))
        self.draw_walls(axes, frame.walls)

    def draw_walls(self, axes, walls):
        t = self.thickness
        for d, side in ((d, s) for d in (0, 1) for s in (0, 1)):
            if (d, side) in walls.open_sides:
                continue
            low, high = walls.lower - t, walls.upper + t
            low[d], high[d] = ((walls.lower[d] - t, walls.lower[d]) if side == 0
                               else (walls.upper[d], walls.upper[d] + t))
            moves = (d, side) in self.moving
            rectangle(axes, low, high, fc="#b5651d" if moves else "#d0d0d0", ec="none", zorder=3)
            line = numpy.array([walls.lower, walls.upper])
            line[:, d] = (walls.upper if side else walls.lower)[d]
            axes.plot(*line.T, color="#333333", lw=0.9, zorder=4)
        for low, high in walls.obstacles:
            rectangle(axes, low, high, fc=SOLID, ec="#333333", lw=0.9, zorder=3)


class Stage3D(Stage):
    def __init__(self, run, frames, name, eye=None, width=1000):
        super().__init__(run, frames, name)
        if eye is None:  # walls that move stand behind the water
            eye = numpy.array(VIEW)
            for d, side in self.moving:
                if d < 2:
                    eye[d] = abs(eye[d]) * (1 if side == 0 else -1)
        self.eye, self.width, self.still = eye, width, None
        self.low, self.high = self.box[0].copy(), self.box[1].copy()
        # air above the highest splash says nothing
        top = self.reached[1][2] + 0.1 * (self.reached[1][2] - self.reached[0][2])
        obstacles = run.walls_at(0).obstacles
        top = max([top] + [high[2] for _, high in obstacles])
        self.high[2] = min(self.high[2], top)
        self.thickness = THICKNESS * (self.high - self.low).max() if self.moving else 0.0
        small = self.make_view(run.walls_at(0), 100)
        self.ratio = small.shape[0] / small.shape[1]

    def view(self, walls):
        """The same as long as no wall moves."""
        if self.moving or self.still is None or self.still[0] != self.width:
            self.still = self.width, self.make_view(walls, self.width)
        return self.still[1]

    def make_view(self, walls, width):
        cut = [(low, numpy.minimum(high, self.high)) for low, high in
               list(walls.obstacles) + self.pistons(walls, self.thickness)]
        low, high = self.low.copy(), self.high.copy()
        for d, side in self.moving:
            (high if side else low)[d] += (2 * side - 1) * self.thickness
        return View(low, high, self.eye, width, cut)

    def image(self, frame):
        """The View and its picture [rows, columns, 3]."""
        view = self.view(frame.walls)
        skin = frame.water.skin(frame.walls, self.field_of(frame))
        centres, radii, values = self.drops(frame)
        return view, view.water_picture(
            skin, (centres, BALL * radii, values), lambda v: self.colours(frame, v),
            opacity=0.92 if frame.known else 0.85)

    def prepare(self, axes):
        axes.set_axis_off()

    def draw(self, axes, frame):
        view, image = self.image(frame)
        ticks = {}
        for d in range(3):
            length = (self.high[d] - self.low[d]) * numpy.linalg.norm(view.axes[:2, d])
            number = min(5 if d < 2 else 3, int(self.width / TICK * length / numpy.ptp(view.extent[:2])))
            places = MaxNLocator(number).tick_values(self.low[d], self.high[d]) if number > 1 else []
            slack = 1e-6 * (self.high[d] - self.low[d])
            ticks[d] = [p for p in places if self.low[d] - slack <= p <= self.high[d] + slack
                        and (d < 2 or p > self.low[d] + slack)] or [self.high[d]]
        view.draw(axes, image, ticks)
        view.draw_rim(axes, view.lower, view.upper)
        axes.set_title("t = %.3f s" % frame.time, fontsize=10)


def rectangle(axes, low, high, **style):
    axes.add_patch(plt.Rectangle(low, *(numpy.asarray(high) - low), **style))


def make_stage(run, frames, name, **options):
    if run.dim == 2:
        return Stage2D(run, frames, name)
    return Stage3D(run, frames, name, **options)
