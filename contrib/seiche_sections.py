# SPDX-License-Identifier: LGPL-2.1-or-later
"""Depth of the water from above and velocity in an upright section of a
three-dimensional run, for pictures. A picture holds all frames that it gets."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

from seiche_snapshots import domain, draw_obstacles, field

WIDTH = 12.0  # of a picture [inches]
ARROWS = 45  # along a section


def shares(places, sizes, edges):
    """Which two columns the interval of each point lies in, and how much of it
    in the first. Columns are at least as wide as the intervals."""
    width = edges[1] - edges[0]
    first = numpy.floor((places - 0.5 * sizes - edges[0]) / width).astype(int)
    share = (edges[0] + (first + 1) * width - (places - 0.5 * sizes)) / sizes
    last = len(edges) - 2
    return (first.clip(0, last), (first + 1).clip(0, last)), share.clip(0.0, 1.0)


def depth(frame, edges):
    """Height [m] that the water of each column would fill; edges of the columns
    in x and y [m]. Points are cubes: taken as dots they would beat with the
    columns."""
    size = 2.0 * field(frame, "radius")
    (i, in_x), (j, in_y) = (shares(frame["points"][:, d], size, edges[d]) for d in (0, 1))
    volume = numpy.zeros([len(e) - 1 for e in edges])
    for a, along in enumerate((in_x, 1.0 - in_x)):
        for b, across in enumerate((in_y, 1.0 - in_y)):
            numpy.add.at(volume, (i[a], j[b]), size**3 * along * across)
    return volume / numpy.outer(numpy.diff(edges[0]), numpy.diff(edges[1]))


def columns_of(lower, upper, frame):
    """Edges of columns about two points wide, none narrower than a point."""
    sizes = 2.0 * field(frame, "radius")
    width = max(2.0 * float(numpy.median(sizes)), float(sizes.max()))
    return [
        numpy.linspace(low, high, max(1, int((high - low) / width)) + 1)
        for low, high in zip(lower[:2], upper[:2])
    ]


def panels(number, lower, upper, directions):
    """Figure and axes of equal scale, so many under and beside each other that
    they can be read."""
    ratio = (upper[directions[1]] - lower[directions[1]]) / (
        upper[directions[0]] - lower[directions[0]]
    )
    across = 1 if ratio < 0.3 or number == 1 else 2
    rows = -(-number // across)
    figure, axes = plt.subplots(
        rows,
        across,
        figsize=(WIDTH, rows * (WIDTH / across * ratio + 0.5) + 0.4),
        squeeze=False,
        layout="constrained",
    )
    for unused in axes.flat[number:]:
        unused.set_visible(False)
    for used in axes.flat[:number]:
        used.set_xlim(lower[directions[0]], upper[directions[0]])
        used.set_ylim(lower[directions[1]], upper[directions[1]])
        used.set_aspect("equal")
        used.set(xlabel="xyz"[directions[0]] + " [m]", ylabel="xyz"[directions[1]] + " [m]")
    return figure, axes.flat[:number]


def depth_picture(run, frames, filename):
    """Depth from above, [(time, frame)]."""
    lower, upper = domain(run, frames[0][1]["points"])
    edges = columns_of(lower, upper, frames[0][1])
    maps = [depth(frame, edges) for _, frame in frames]
    highest = max(numpy.percentile(values[values > 0], 99.5) if values.any() else 0 for values in maps)
    figure, all_axes = panels(len(frames), lower, upper, (0, 1))
    for axes, (time, _), values in zip(all_axes, frames, maps):
        shown = numpy.ma.masked_equal(values.T, 0.0)
        image = axes.pcolormesh(*edges, shown, cmap="Blues", vmin=0, vmax=highest, rasterized=True)
        draw_obstacles(axes, run, 0, 1)
        axes.set_title("t = %.3g s" % time, fontsize=10)
    figure.colorbar(image, ax=list(all_axes), label="depth [m]", shrink=0.8)
    figure.savefig(filename, dpi=110)
    plt.close(figure)


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


def section_picture(run, frames, place, filename):
    """Speeds in the plane y = place [m]; [(time, frame)]."""
    lower, upper = domain(run, frames[0][1]["points"])
    cut = [(time, *near_plane(frame, place)) for time, frame in frames]
    speeds = numpy.concatenate([numpy.linalg.norm(v, axis=1) for _, _, v in cut])
    if len(speeds) == 0:
        return False
    fastest = max(float(numpy.percentile(speeds, 99)), 1e-12)
    figure, all_axes = panels(len(frames), lower, upper, (0, 2))
    step = (upper[0] - lower[0]) / ARROWS
    for axes, (time, x, v) in zip(all_axes, cut):
        image = draw_section(axes, x, v, fastest, step)
        # only those that the plane goes through
        draw_obstacles(axes, run, 0, 2, (1, place))
        axes.set_title("t = %.3g s, y = %.4g m" % (time, place), fontsize=10)
    figure.colorbar(image, ax=list(all_axes), label="speed [m/s]", shrink=0.8)
    figure.savefig(filename, dpi=110)
    plt.close(figure)
    return True
