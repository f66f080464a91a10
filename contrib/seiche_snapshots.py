# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the material points coloured by pressure and of the free surface, for
plot_run."""

import collections
import re

import matplotlib.pyplot as plt
import numpy
from matplotlib.collections import LineCollection
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from seiche_output import read_frame

FRAMES_2D = 6
FRAMES_3D = 3
POINTS_IN_PERSPECTIVE = 15000  # more only blacken the picture
PRESSURE_LABEL = "pressure [Pa]"

# time [s], positions [n, 3] [m], pressure [n] [Pa], whether there is a pressure
# at all, typical distance of neighbouring points [m]
Frame = collections.namedtuple("Frame", "time positions pressure known spacing")


def field(frame, name):
    """A field by the first word of its name (units may follow), or None."""
    for key, values in frame.items():
        if re.split(r"[ \[(]", key)[0] == name:
            return values
    return None


def choose(frames, number):
    """About `number` frames, evenly spaced, the first and last included."""
    if len(frames) <= number:
        return frames
    places = numpy.round(numpy.linspace(0, len(frames) - 1, number)).astype(int)
    return [frames[i] for i in places]


def load_frames(run, number):
    """Chosen frames, and limits of the pressure for the colours."""
    chosen = []
    for time, path in choose(run.frames("points"), number):
        frame = read_frame(path)
        pressure, radius = field(frame, "pressure"), field(frame, "radius")
        if pressure is None or len(frame["points"]) == 0:
            continue
        chosen.append(
            Frame(
                time,
                frame["points"],
                pressure,
                # Before the first step there is no pressure yet.
                time > 0 or bool(numpy.any(pressure != 0)),
                2 * float(numpy.median(radius)) if radius is not None else 0.0,
            )
        )
    values = [frame.pressure for frame in chosen if frame.known]
    if not values:
        return [], (0.0, 1.0)
    low, high = numpy.percentile(numpy.concatenate(values), (1, 99))
    return chosen, (min(low, 0.0), max(high, 1e-12))


def surface(run, time, dim):
    """Lines (2D) or triangles of the free surface [n, dim, dim] [m], or None."""
    path = run.frame_at("surface", time)
    return read_frame(path)["points"].reshape(-1, dim, 3)[:, :, :dim] if path else None


def domain(run, positions):
    """Corners of the domain; of the points if the parameters are missing."""
    lower = run.numbers("Grid/Lower corner")
    upper = run.numbers("Grid/Upper corner")
    if not lower or len(lower) != len(upper):
        return positions.min(axis=0), positions.max(axis=0)
    return numpy.array(lower), numpy.array(upper)


def obstacles(run):
    """Lower and upper corners of the obstacles whose corners are given."""
    names = ["Obstacle %s/%%s corner" % name for name in run.instances("Obstacle")]
    corners = [(run.numbers(name % "Lower"), run.numbers(name % "Upper")) for name in names]
    return [(lower, upper) for lower, upper in corners if lower and upper]


def draw_obstacles(axes, run, horizontal, vertical, plane=None):
    """All, or those that a plane (direction, place [m]) goes through."""
    for lower, upper in obstacles(run):
        if plane is None or lower[plane[0]] <= plane[1] <= upper[plane[0]]:
            axes.add_patch(
                plt.Rectangle(
                    (lower[horizontal], lower[vertical]),
                    upper[horizontal] - lower[horizontal],
                    upper[vertical] - lower[vertical],
                    fc="0.6",
                    ec="k",
                    lw=0.6,
                )
            )


def view_limits(run, frames, horizontal, vertical):
    """The part of the domain that the points ever reach in these frames."""
    lower, upper = domain(run, frames[0].positions)
    limits = []
    for d in (horizontal, vertical):
        low = min(frame.positions[:, d].min() for frame in frames)
        high = max(frame.positions[:, d].max() for frame in frames)
        margin = 0.05 * (high - low)
        limits.append((max(lower[d], low - margin), min(upper[d], high + margin)))
    return limits


def colour_bar(figure, axes, limits):
    """The bar all snapshots share; added before the points, which need the
    final size of their axes."""
    mappable = plt.cm.ScalarMappable(plt.Normalize(*limits), cmap="viridis")
    figure.colorbar(mappable, ax=axes, label=PRESSURE_LABEL, shrink=0.8)
    figure.canvas.draw()


def colours(frame, order, limits):
    """Arguments of scatter() for the points in a given order."""
    if not frame.known:
        return {"color": "0.6", "lw": 0, "rasterized": True}
    return {
        "c": frame.pressure[order],
        "cmap": "viridis",
        "vmin": limits[0],
        "vmax": limits[1],
        "lw": 0,
        "rasterized": True,
    }


def scatter(axes, frame, limits, columns, order=slice(None)):
    """Points as discs of about their spacing, coloured by pressure."""
    per_metre = axes.get_window_extent().width / numpy.ptp(axes.get_xlim())
    diameter = 1.1 * frame.spacing * per_metre * 72 / axes.figure.dpi  # printer's points
    x, y = (frame.positions[order, column] for column in columns)
    axes.scatter(x, y, s=max(diameter, 1.0) ** 2, **colours(frame, order, limits))


def snapshots_2d(run, scene, path):
    frames, limits = load_frames(run, FRAMES_2D)
    if not frames:
        return False
    view = view_limits(run, frames, 0, 1)
    ratio = (view[1][1] - view[1][0]) / (view[0][1] - view[0][0])
    columns = 3 if ratio > 0.7 else 2
    rows = -(-len(frames) // columns)
    width = 12.0 / columns
    figure, all_axes = plt.subplots(
        rows,
        columns,
        figsize=(12, rows * (width * ratio + 0.5) + 0.6),
        squeeze=False,
        layout="constrained",
    )
    for axes in all_axes.flat[len(frames) :]:
        axes.set_visible(False)
    for axes, frame in zip(all_axes.flat, frames):
        axes.set_xlim(*view[0])
        axes.set_ylim(*view[1])
        axes.set_aspect("equal")
        axes.set_title("t = %.4g s" % frame.time, fontsize=10)
        draw_obstacles(axes, run, 0, 1)
    for axes in all_axes[:, 0]:
        axes.set_ylabel("y [m]")
    for axes in all_axes[-1]:
        axes.set_xlabel("x [m]")
    colour_bar(figure, all_axes, limits)
    for axes, frame in zip(all_axes.flat, frames):
        scatter(axes, frame, limits, (0, 1))
        lines = surface(run, frame.time, 2)
        if lines is not None:
            axes.add_collection(LineCollection(lines, colors="k", linewidths=0.8))
        if scene and hasattr(scene, "overlay_snapshot"):
            scene.overlay_snapshot(axes, frame.time)
    figure.savefig(path, dpi=120, bbox_inches="tight")  # else labels on the left are cut off
    return True


def perspective(axes, run, frame, limits):
    """The points of a 3D frame seen from the front right."""
    order = slice(None, None, max(1, len(frame.positions) // POINTS_IN_PERSPECTIVE))
    axes.scatter(*frame.positions[order].T, s=5, **colours(frame, order, limits))
    triangles = surface(run, frame.time, 3)
    if triangles is not None:
        axes.add_collection3d(Poly3DCollection(triangles, alpha=0.25, facecolor="0.8", lw=0))
    lower, upper = domain(run, frame.positions)
    axes.set(xlim=(lower[0], upper[0]), ylim=(lower[1], upper[1]), zlim=(lower[2], upper[2]),
             xlabel="x [m]", ylabel="y [m]", zlabel="z [m]")
    axes.set_box_aspect(upper - lower, zoom=1.2)
    axes.locator_params(nbins=4)
    axes.tick_params(labelsize=7)
    axes.view_init(elev=22, azim=-60)


def snapshots_3d(run, scene, path):
    """Side view (left, nearest points in front) and perspective (right)."""
    frames, limits = load_frames(run, FRAMES_3D)
    if not frames:
        return False
    view = view_limits(run, frames, 0, 2)
    rows = len(frames)
    figure = plt.figure(figsize=(12, 3.4 * rows), layout="constrained")
    sides = [figure.add_subplot(rows, 2, 2 * i + 1) for i in range(rows)]
    spaces = [figure.add_subplot(rows, 2, 2 * i + 2, projection="3d") for i in range(rows)]
    for axes, frame in zip(sides, frames):
        axes.set_xlim(*view[0])
        axes.set_ylim(*view[1])
        axes.set_aspect("equal")
        axes.set_title("t = %.4g s, side view" % frame.time, fontsize=10)
        axes.set(xlabel="x [m]", ylabel="z [m]")
        draw_obstacles(axes, run, 0, 2)
    colour_bar(figure, sides, limits)
    for side, space, frame in zip(sides, spaces, frames):
        order = numpy.argsort(-frame.positions[:, 1], kind="stable")
        scatter(side, frame, limits, (0, 2), order)
        perspective(space, run, frame, limits)
    figure.savefig(path, dpi=120, bbox_inches="tight")
    return True


def snapshots(run, scene, path):
    dim = int(run.parameter("Dimension", "2") or 2)
    return (snapshots_3d if dim == 3 else snapshots_2d)(run, scene, path)
