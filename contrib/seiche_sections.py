# SPDX-License-Identifier: LGPL-2.1-or-later
"""Depth of the water from above and velocity in an upright section of a
three-dimensional run, for pictures. A picture holds all frames that it gets."""

import matplotlib.pyplot as plt
import numpy

from seiche_lattice import deposit, lattice_cells
from seiche_output import field
from seiche_simplices import clip_triangles, fans, without_needles
from seiche_stage import COLOURS, SOLID, draw_borders, fluid_colour, rectangle
from seiche_water import NEEDLE

WIDTH = 12.0  # of a picture [inches]
ARROWS = 45  # along a section
FINEST = 500  # columns along a picture
BESIDE = 0.005  # [cells] from an obstacle's face: NEAR_SIDE < BESIDE < NEEDLE / 2
SEEN = 0.25  # depth [cells] of a fluid at its edge
SAMPLES = 3  # heights a cell at which the depth's level is read


def depth(frame, edges):
    """Height [m] that the points of each column would fill; edges of the columns
    in x and y [m]."""
    size = 2.0 * field(frame, "radius")
    volume = deposit(frame["points"][:, :2], size, edges, size**3)
    return volume / numpy.outer(numpy.diff(edges[0]), numpy.diff(edges[1]))


def columns_of(lower, upper, frame):
    """Edges of columns about two points wide, none narrower than a point."""
    sizes = 2.0 * field(frame, "radius")
    width = max(2.0 * float(numpy.median(sizes)), float(sizes.max()))
    return [
        numpy.linspace(low, high, max(1, int((high - low) / width)) + 1)
        for low, high in zip(lower[:2], upper[:2])
    ]


def lines_of(stage, water, width, d):
    """Places [m] at which a picture is computed in direction d, about a width apart;
    on both sides of every face of an obstacle, so that what is drawn ends there."""
    low, high = stage.low[d], stage.high[d]
    lines = numpy.linspace(low, high, max(2, int(numpy.ceil((high - low) / width))) + 1)
    faces = stage.run.walls_at(0).obstacles[:, :, d].ravel()
    both = numpy.concatenate([faces - BESIDE * water.size, faces + BESIDE * water.size])
    return numpy.unique(numpy.concatenate([lines, both[(both > low) & (both < high)]]))


def level_at(frame, places, *names):
    """Of the water at places [n, 3], outside of solids, in cells, and fields."""
    level, *values = frame.water.sample(places, *names)
    wet = level < 0
    level[wet] = numpy.maximum(level[wet], -frame.walls.distance(places[wet]) / frame.water.size)
    return [level] + values


def depth_of_water(frame, places, low, high):
    """Height [m] of the water of a Frame over each place [n, 2]: how much of the upright
    line between two heights [m] lies inside the level; and those of its fluids
    [number, n]."""
    water = frame.water
    n = max(2, int(numpy.ceil((high - low) / water.size * SAMPLES)))
    step = (high - low) / n
    result = numpy.zeros(len(places))
    of_fluids = numpy.zeros((len(frame.fluids.names), len(places)))
    for k in range(n):
        height = numpy.full((len(places), 1), low + (k + 0.5) * step)
        there = numpy.hstack([places, height])
        level = level_at(frame, there)[0] * water.size
        part = step * numpy.clip(0.5 - level / step, 0, 1)
        result += part
        of_fluids[frame.fluids.at(there), numpy.arange(len(there))] += part
    return result, of_fluids


def panels(number, lower, upper, directions):
    """Figure and axes of equal scale, so many under and beside each other that
    they can be read."""
    ratio = (upper[directions[1]] - lower[directions[1]]) / (
        upper[directions[0]] - lower[directions[0]]
    )
    across = 1 if ratio < 0.2 or number == 1 else 2
    rows = -(-number // across)
    figure, axes = plt.subplots(
        rows,
        across,
        figsize=(WIDTH, rows * ((WIDTH - 1.3) / across * ratio + 0.5) + 0.4),
        squeeze=False,
        layout="compressed",
    )
    for unused in axes.flat[number:]:
        unused.set_visible(False)
    for used in axes.flat[:number]:
        used.set_xlim(lower[directions[0]], upper[directions[0]])
        used.set_ylim(lower[directions[1]], upper[directions[1]])
        used.set_aspect("equal")
        used.set(xlabel="xyz"[directions[0]] + " [m]", ylabel="xyz"[directions[1]] + " [m]")
        used.label_outer()
    return figure, axes.flat[:number]


def depth_picture(stage, frames, filename):
    """Depth from above of Frames."""
    lower, upper = stage.box
    width = max(frames[0].water.size / 2, (upper - lower)[:2].max() / FINEST)
    lines = [lines_of(stage, frames[0].water, width, d) for d in (0, 1)]
    places = numpy.stack(numpy.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, 2)
    maps, of_fluids = zip(*(depth_of_water(f, places, lower[2], stage.high[2]) for f in frames))
    highest = max(numpy.percentile(m[m > 0], 99.5) if m.any() else 0 for m in maps)
    corners, numbers = lattice_cells(lines, [len(line) - 1 for line in lines])
    figure, all_axes = panels(len(frames), lower, upper, (0, 1))
    image = plt.cm.ScalarMappable(plt.Normalize(0, max(highest, 1e-12)), "Blues")
    for axes, frame, values, parts in zip(all_axes, frames, maps, of_fluids):
        values = values[numbers]
        dry = 0.02 * frame.water.size - values  # the water's edge
        filled = clip_triangles(*fans(numpy.dstack([corners, values]), dry))
        filled = without_needles(filled, NEEDLE * frame.water.size)
        fill(axes, filled, image)
        draw_extents(axes, frame, lines, parts)
        for low, high in frame.walls.obstacles:
            rectangle(axes, low[:2], high[:2], fc=SOLID, ec="#333333", lw=0.8, zorder=3)
        axes.set_title("t = %.3f s" % frame.time, fontsize=10)
    what = "all fluids" if len(of_fluids[0]) > 1 else "the water"
    figure.colorbar(image, ax=list(all_axes), label="depth of %s [m]" % what, extend="max", shrink=0.8)
    figure.savefig(filename, dpi=130, bbox_inches="tight")
    plt.close(figure)


def draw_extents(axes, frame, lines, depths):
    """Where there are fluids beside the first, seen from above: their edges and names."""
    for number in numpy.flatnonzero(depths[1:].max(axis=1) > SEEN * frame.water.size) + 1:
        edge = axes.contour(*lines, depths[number].reshape([len(line) for line in lines]).T,
                            [SEEN * frame.water.size], colors=fluid_colour(number), linewidths=1.8)
        axes.clabel(edge, fmt=lambda _, name=frame.fluids.names[number]: name, fontsize=9)


def fill(axes, triangles, image):
    """Triangles [n, 3, (x, y, value)] in the colours of a mappable."""
    if len(triangles):
        axes.tripcolor(*triangles[:, :, :2].reshape(-1, 2).T,
                       numpy.arange(3 * len(triangles)).reshape(-1, 3), triangles[:, :, 2].ravel(),
                       shading="gouraud", cmap=image.cmap, norm=image.norm, rasterized=True)


def near_plane(frame, place):
    """Positions and velocities of the points within a spacing of the plane
    y = place [m]."""
    half = 2.0 * float(numpy.median(field(frame, "radius")))
    near = abs(frame["points"][:, 1] - place) <= half
    return frame["points"][near], field(frame, "velocity")[near]


def draw_section(axes, x, v, fastest, step, size=3):
    """Points in the plane of x and z coloured by speed [m/s], and mean
    velocities of bins, `step` [m] long, as arrows."""
    image = axes.scatter(
        x[:, 0], x[:, 2], c=numpy.linalg.norm(v, axis=1), s=size, lw=0,
        cmap="viridis", vmin=0, vmax=fastest, rasterized=True,
    )
    bins = numpy.floor(x[:, [0, 2]] / (step, 0.5 * step)).astype(int)
    which = numpy.unique(bins, axis=0, return_inverse=True)[1].ravel()
    means = [
        numpy.bincount(which, values) / numpy.bincount(which)
        for values in (x[:, 0], x[:, 2], v[:, 0], v[:, 2])
    ]
    axes.quiver(
        *means, angles="xy", scale_units="xy", scale=fastest / (1.5 * step), width=0.0012
    )
    return image


def in_plane(places, y):
    """Places (x, z) with a y between them [m]."""
    return numpy.stack([places[:, 0], numpy.full(len(places), y), places[:, 1]], axis=1)


def section_picture(stage, frames, y, filename):
    """Speed and velocity in the plane y [m] of Frames; False if there is no water."""
    lower, upper = stage.low, stage.high
    width = max(frames[0].water.size / 3, (upper[0] - lower[0]) / FINEST)
    lines = [lines_of(stage, frames[0].water, width, d) for d in (0, 2)]
    corners, numbers = lattice_cells(lines, [len(line) - 1 for line in lines])
    nodes = numpy.stack(numpy.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, 2)
    step = (upper[0] - lower[0]) / ARROWS
    at_arrows = numpy.stack(numpy.meshgrid(
        numpy.arange(lower[0] + step / 2, upper[0], step),
        numpy.arange(lower[2] + step / 4, upper[2], step / 2), indexing="ij"), axis=-1).reshape(-1, 2)
    cuts = []
    for frame in frames:
        level, speed = level_at(frame, in_plane(nodes, y), "speed")
        columns = numpy.dstack([corners, speed[numbers]])
        filled = without_needles(clip_triangles(*fans(columns, level[numbers])),
                                 NEEDLE * frame.water.size)
        inside, velocity = level_at(frame, in_plane(at_arrows, y), "velocity")
        inside = inside < -0.1
        cuts.append((filled, at_arrows[inside], velocity[inside]))
    speeds = numpy.concatenate([filled[:, :, 2].ravel() for filled, _, _ in cuts])
    if len(speeds) == 0:
        return False
    fastest = max(float(numpy.percentile(speeds, 99)), 1e-12)
    figure, all_axes = panels(len(frames), lower, upper, (0, 2))
    image = plt.cm.ScalarMappable(plt.Normalize(0, fastest), COLOURS["speed"])
    for axes, frame, (filled, x, v) in zip(all_axes, frames, cuts):
        fill(axes, filled, image)
        there = in_plane(filled[:, :, :2].reshape(-1, 2), y).reshape(-1, 3, 3)
        draw_borders(axes, frame.fluids, there, on_field=True, plane=(0, 2))
        if len(x):
            axes.quiver(*x.T, v[:, 0], v[:, 2], angles="xy", scale_units="xy", color="#f2a33a",
                        scale=fastest / (1.5 * step), width=0.0016)
        for low, high in frame.walls.obstacles:
            if low[1] <= y <= high[1]:  # those that the plane goes through
                rectangle(axes, low[[0, 2]], high[[0, 2]], fc=SOLID, ec="#333333", lw=0.8, zorder=3)
        if len(frame.walls.solids):
            distance = frame.walls.distance(in_plane(nodes, y)).reshape([len(line) for line in lines]).T
            axes.contourf(*lines, distance, [-numpy.inf, 0.0], colors=[SOLID], zorder=3)
            axes.contour(*lines, distance, [0.0], colors="#333333", linewidths=0.8, zorder=4)
        axes.set_title("t = %.3f s, y = %.4g m" % (frame.time, y), fontsize=10)
    figure.colorbar(image, ax=list(all_axes), label="speed [m/s]", extend="max", shrink=0.8)
    figure.savefig(filename, dpi=130, bbox_inches="tight")
    plt.close(figure)
    return True
