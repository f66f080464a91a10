# SPDX-License-Identifier: LGPL-2.1-or-later
"""Water, walls and obstacles of a run on matplotlib's axes: what the pictures and the
film of a run share, so that colours and scales are the same in all of them.

    stage = make_stage(run, frames, "pressure")    frames: [(time, file)] of the points
    stage.draw(axes, stage.load(time, file))
    stage.draw_key(figure, axes)
"""

import collections

import matplotlib.pyplot as plt
import numpy
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.colors import LinearSegmentedColormap, ListedColormap, to_rgb
from matplotlib.patches import Patch

from seiche_fluids import Fluids
from seiche_output import field, read_frame
from seiche_simplices import without_needles
from seiche_water import NEEDLE, scalar, water_of

FIELDS = {"pressure": "pressure [Pa]", "speed": "speed [m/s]", "plain": None}
COLOURS = {
    "pressure": plt.get_cmap("viridis"),
    "speed": LinearSegmentedColormap.from_list(  # slow water is dark, fast water like foam
        "water", ("#0b3c6f", "#1f6fb2", "#4da3d9", "#9fd3ec", "#e9f7fb")),
}
WATER = "#4b9cd3"  # without a field, or before there is one
# of the first fluid of a scene, the second, ...; as in source/simulation/scene_styles.cc
FLUIDS = (WATER, "#e0a030", "#4f9d69", "#9867ad", "#c65f46", "#85855a")
EDGE = "#0b2a45"  # of a fluid
LABEL = {"boxstyle": "round,pad=0.2", "fc": EDGE, "ec": "none", "alpha": 0.7}  # of its name
SOLID = "#8b8b8b"
RASTER = 401  # places along a side that tell solids from water
SAMPLED = 20  # frames that limits and extents are taken from
THICKNESS = 0.02  # of a drawn wall over the longest side of the picture
SILENT = 1e-9  # [Pa] round-off, not a pressure
BALL = 1.25  # drawn radius of a drop over half the edge of its point

# time [s], points (read_frame), their water, its Fluids, Walls, whether there is a pressure
Frame = collections.namedtuple("Frame", "time points water fluids walls known")


def sampled(frames, number):
    """About `number` of them, evenly spread, the first and last included."""
    if len(frames) <= number:
        return list(frames)
    return [frames[i] for i in numpy.rint(numpy.linspace(0, len(frames) - 1, number)).astype(int)]


def usual_field(run, usual):
    """What a picture is coloured by, unless asked for: several fluids are told apart."""
    return "plain" if len(run.fluids()) > 1 else usual


def is_known(name, time, points):
    """False for the pressure before the first step."""
    return name == "speed" or (
        name == "pressure" and (time > 0 or bool(numpy.any(field(points, name) != 0))))


def keep_free(figure, legend, below):
    """The figure's layout without the strip of a legend below or at the right."""
    extent = legend.get_window_extent(figure.canvas.get_renderer())
    width, height = extent.width / figure.bbox.width, extent.height / figure.bbox.height
    figure.get_layout_engine().set(rect=(0, height, 1, 1 - height) if below else
                                   (0, 0, 1 - width, 1))


class Stage:
    """Limits of the colours, the walls of all times and the room that is shown."""

    def __init__(self, run, frames, name):
        self.run, self.name, self.dim, self.shows_fluids = run, name, run.dim, False
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
        # one object as long as nothing moves
        self.all_walls = list({id(walls): walls for walls in at_times}.values())
        self.box = (numpy.min([w.lower for w in at_times], axis=0),
                    numpy.max([w.upper for w in at_times], axis=0))
        self.open_sides = at_times[0].open_sides
        span = [(w.lower, w.upper) for w in at_times]
        self.moving = {(d, side) for d in range(self.dim) for side in (0, 1)
                       if numpy.ptp([s[side][d] for s in span]) > 1e-9}

    def load(self, time, path):
        points = read_frame(path)
        points["points"] = points["points"].astype(float)
        walls = self.run.walls_at(time)
        return Frame(time, points, water_of(self.run, time, points),
                     Fluids(self.run, points, walls), walls, is_known(self.name, time, points))

    def draw_key(self, figure, axes, **options):
        """The bar that all pictures share, none for plain water; names of several fluids
        where they have been drawn in their own colours."""
        if FIELDS[self.name]:
            mappable = plt.cm.ScalarMappable(plt.Normalize(*self.limits), COLOURS[self.name])
            extend = "both" if self.limits[0] < 0 else "max"
            figure.colorbar(mappable, ax=axes, label=FIELDS[self.name], extend=extend,
                            **{"shrink": 0.8, "aspect": 30, **options})
        names = list(self.run.fluids().values())
        if len(names) > 1 and self.shows_fluids:
            below = bool(FIELDS[self.name])  # beside the axes is the bar
            legend = figure.legend(
                [Patch(fc=fluid_colour(n), ec=EDGE, lw=0.6) for n in range(len(names))], names,
                frameon=False, loc="lower center" if below else "center right",
                ncols=len(names) if below else 1)
            keep_free(figure, legend, below)

    def colours(self, frame, values, fluids):
        """Colours [n, 3] of values [n] in fluids of these numbers [n]."""
        if not frame.known:
            self.shows_fluids = True
            palette = numpy.array([to_rgb(fluid_colour(n)) for n in range(fluids.max(initial=0) + 1)])
            return palette[fluids]
        return COLOURS[self.name](plt.Normalize(*self.limits)(values))[:, :3]

    def field_of(self, frame):
        """The field that there is at this time, to look up in the frame."""
        return self.name if frame.known else "speed"

    def drops(self, frame):
        """Centres, half edges, values and fluids of the points outside the water."""
        loose = frame.water.spray(frame.points["points"])
        return (frame.points["points"][loose], field(frame.points, "radius")[loose].astype(float),
                scalar(frame.points, self.field_of(frame))[loose], frame.fluids.of_point[loose])

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
        walls = run.walls_at(0)
        bodies = list(walls.obstacles)
        if len(walls.solids):
            ends = walls.solids.reshape(-1, 2)
            bodies.append((ends.min(axis=0), ends.max(axis=0)))
        for low_corner, high_corner in bodies:  # none cut off
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
        if frame.known:
            self.fill(axes, corners, values, cmap=COLOURS[self.name], vmin=self.limits[0],
                      vmax=self.limits[1])
        else:
            self.fill_plain(axes, frame, corners)
        draw_borders(axes, frame.fluids, corners, on_field=frame.known)
        centres, radii, values, fluids = self.drops(frame)
        size = 2 * BALL * radii
        axes.add_collection(EllipseCollection(
            size, size, numpy.zeros(len(size)), units="xy", offsets=centres[:, :2],
            offset_transform=axes.transData, facecolors=self.colours(frame, values, fluids), lw=0))
        axes.add_collection(LineCollection(frame.water.outline(), colors=EDGE, linewidths=0.9))
        self.draw_walls(axes, frame.walls)

    def fill_plain(self, axes, frame, corners):
        """Each fluid in its colour."""
        for number, part in frame.fluids.divided(corners):
            if frame.fluids.are_several:
                part = without_needles(part, NEEDLE * frame.water.size)
            colour = self.colours(frame, numpy.zeros(1), numpy.array([number]))[0]
            self.fill(axes, part, numpy.zeros(part.shape[:2]), cmap=ListedColormap([colour]))

    @staticmethod
    def fill(axes, corners, values, **colours):
        """Triangles [n, 3, 2] by values [n, 3]."""
        if len(corners):
            axes.tripcolor(*corners.reshape(-1, 2).T, numpy.arange(3 * len(corners)).reshape(-1, 3),
                           values.ravel(), shading="gouraud", rasterized=True, **colours)

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
        if len(walls.solids):
            across = numpy.linspace(walls.lower[0], walls.upper[0], RASTER)
            up = numpy.linspace(walls.lower[1], walls.upper[1], RASTER)
            places = numpy.stack(numpy.meshgrid(across, up), axis=-1)
            height = walls.distance(places.reshape(-1, 2)).reshape(places.shape[:2])
            axes.contourf(across, up, height, [-numpy.inf, 0.0], colors=[SOLID], zorder=3)
            axes.add_collection(LineCollection(walls.solids, colors="#333333", lw=0.9, zorder=4))


def fluid_colour(number):
    return FLUIDS[number % len(FLUIDS)]


def draw_borders(axes, fluids, triangles, on_field, plane=(0, 1)):
    """Between fluids in triangles [n, 3, dim] of a plane; on a field they are seen in the
    dark and the bright, and the fluids are named."""
    lines = fluids.borders(triangles)[:, :, plane]
    for colour, width in (("white", 2.2),) * on_field + ((EDGE, 0.9),):
        axes.add_collection(LineCollection(lines, colors=colour, linewidths=width, zorder=1.9))
    for number, part in fluids.divided(triangles) if on_field and fluids.are_several else ():
        part = part[:, :, plane]
        if len(part):
            centres = part.mean(axis=1)
            a, b = part[:, 1] - part[:, 0], part[:, 2] - part[:, 0]
            area = abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) + 1e-300
            away = numpy.linalg.norm(centres - numpy.average(centres, axis=0, weights=area), axis=1)
            axes.text(*centres[away.argmin()], fluids.names[number], ha="center", va="center",
                      fontsize=8, color="white", bbox=LABEL)


def rectangle(axes, low, high, **style):
    axes.add_patch(plt.Rectangle(low, *(numpy.asarray(high) - low), **style))


def make_stage(run, frames, name, **options):
    if run.dim == 2:
        return Stage2D(run, frames, name)
    from seiche_stage_3d import Stage3D

    return Stage3D(run, frames, name, **options)
