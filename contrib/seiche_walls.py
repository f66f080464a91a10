# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls of a run at one time (numpy only): the box, obstacles, and solids as the pieces
of their surface. Solids that move are written where they lay at the start of a step;
here they lie where they are at its end, as points and water do."""

import collections
import functools

import numpy

AXES = {2: ("angle",), 3: ("roll", "pitch", "yaw")}  # columns of the angles of a solid


class Walls(collections.namedtuple("Walls", "lower upper obstacles open_sides solids shells")):
    """Corners of the box [dim] and of the obstacles [n, 2, dim] [m]; sides without a
    wall, open or periodic, as (direction, 0 lower or 1 upper); corners of the pieces of
    solids [n, dim, dim] [m], their normals into the fluid; which of these [n] belong to
    solids that hold the fluid inside."""

    @staticmethod
    def of_frame(frame, run, time):
        dim = run.dim
        parts = frame["part [-]"].astype(int)
        corners = [frame["points"][parts == p, :dim] for p in range(parts.max() + 1)]
        box = [[places.min(axis=0), places.max(axis=0)] for places in corners]
        lower, upper = box[0]
        sides = set()
        for cell in frame["cells"][frame["open [-]"][frame["cells"][:, 0]] > 0.5]:
            corners = frame["points"][cell, :dim]
            d = int(numpy.ptp(corners, axis=0).argmin())
            is_upper = abs(corners[0, d] - upper[d]) < abs(corners[0, d] - lower[d])
            sides.add((d, int(is_upper)))
        obstacles = numpy.array(box[1:], float).reshape(-1, 2, dim)
        pieces = frame["cells"][parts[frame["cells"][:, 0]] < 0]
        solids = frame["points"][pieces[:, :dim], :dim].astype(float)
        number = -1 - parts[pieces[:, 0]]  # of the solid in the file
        shells = numpy.zeros(len(solids), bool)
        for n, name in enumerate(run.instances("Solid")):
            solids[number == n] = moved(solids[number == n], run, name, time)
            shells[number == n] = run.parameter("Solid %s/Fluid" % name) == "inside"
        return Walls(lower.astype(float), upper.astype(float), obstacles, frozenset(sides),
                     solids, shells)

    @staticmethod
    def without_solids(lower, upper, obstacles, open_sides):
        dim = len(lower)
        return Walls(numpy.array(lower), numpy.array(upper),
                     numpy.array(obstacles, float).reshape(-1, 2, dim), open_sides,
                     numpy.zeros((0, dim, dim)), numpy.zeros(0, bool))

    @functools.cached_property
    def _measured(self):
        return {}

    def distance(self, places, kind="all"):
        """From solids at places [n, dim] [m], positive in the fluid; kind: all, shells
        (those with the fluid inside) or bodies."""
        chosen = {"all": self.shells >= 0, "shells": self.shells, "bodies": ~self.shells}[kind]
        if not chosen.any():
            return numpy.full(len(places), numpy.inf)
        if chosen.all():
            kind = "all"
        if kind not in self._measured:
            from seiche_solids import Solids  # which only pictures need

            self._measured[kind] = Solids(self.solids[chosen], self.lower, self.upper)
        return self._measured[kind].distance(places)


def moved(pieces, run, name, time):
    """The pieces of a solid at the end of the step that ends at a time [s]."""
    times = run.statistics.get("time [s]", numpy.zeros(0))
    row = int(abs(times - time).argmin()) if len(times) else 0
    if row == 0 or "%s displacement x [m]" % name not in run.statistics:
        return pieces
    centre = run.numbers("Solid %s/Motion centre" % name)
    (before, from_place), (after, to_place) = (placement(run, name, r) for r in (row - 1, row))
    return centre + to_place + (pieces - centre - from_place) @ before @ after.T


def placement(run, name, row):
    """Turn [dim, dim] and displacement [dim] [m] of a solid at a row of the statistics."""
    turn = numpy.eye(run.dim)
    for axis, angle in enumerate(AXES[run.dim]):
        value = run.statistics["%s %s [rad]" % (name, angle)][row]
        i, j = ((axis + 1) % 3, (axis + 2) % 3) if run.dim == 3 else (0, 1)
        about = numpy.eye(run.dim)
        about[i, i] = about[j, j] = numpy.cos(value)
        about[j, i], about[i, j] = numpy.sin(value), -numpy.sin(value)
        turn = about @ turn
    return turn, numpy.array([run.statistics["%s displacement %s [m]" % (name, d)][row]
                              for d in "xyz"[:run.dim]])
