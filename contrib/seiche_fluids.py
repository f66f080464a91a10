# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which of a run's fluids is where in the water of a frame: at each place that whose
points have most of the volume around it (numpy only).

    fluids = Fluids(run, points, walls)         points: of read_frame
    fluids.names, fluids.of_point               numbers from 0 on: those of the names
    fluids.divided(triangles)                   [(number, its part of them)]
    fluids.borders(triangles)                   lines where fluids meet
    fluids.bodies(water)                        3D, the surfaces of all but the first
"""

import numpy

from seiche_lattice import deposit, half_cell, lattice_about, means_of_neighbours, to_nodes
from seiche_output import field
from seiche_simplices import (
    clip_triangles, cut_lines, quartered, smooth_normals, surface_of_tetrahedra, tetrahedra)

FINER = 2  # times that triangles near borders are quartered
PURE = -0.999  # level of a fluid without another one
REACH = 6  # cells of the lattice from the nearest points to where a fluid is known


class Fluids:
    """Triangles here have attributes [n, 3, k], of which the first are coordinates [m]."""

    def __init__(self, run, points, walls):
        numbers = run.fluids()
        material = field(points, "material")
        self.names, self.dim = list(numbers.values()), run.dim
        self.of_point = numpy.zeros(len(points["points"]), int)
        if len(numbers) > 1 and material is not None:
            self.of_point = numpy.searchsorted(list(numbers), material)
        self.are_several = len(numpy.unique(self.of_point)) > 1
        if self.are_several:
            self._measure(points, half_cell(run), walls)

    def _measure(self, points, wide, walls):
        """Shares of the volume [number, node of a lattice]."""
        x, sizes = points["points"][:, :self.dim], 2.0 * field(points, "radius").astype(float)
        self.lines, width = lattice_about(x, sizes, wide, walls)
        volumes = []
        for number in range(len(self.names)):
            own = self.of_point == number
            held = deposit(x[own], numpy.minimum(sizes, width)[own], self.lines, sizes[own]**self.dim)
            volumes.append(to_nodes(means_of_neighbours(held, 1)))
        self.shares = numpy.array(volumes)
        for _ in range(REACH):  # the water may reach beyond its points
            total = self.shares.sum(axis=0)
            known = total > 0
            self.shares = numpy.where(known, self.shares / numpy.where(known, total, 1), numpy.array(
                [means_of_neighbours(share, 1) for share in self.shares]))

    def levels(self, places):
        """Of each fluid at places [..., dim] [m], negative inside: the greatest share of
        another one less its own [..., number]."""
        flat = places.reshape(-1, self.dim)
        shares = numpy.zeros((len(self.names), len(flat)))
        first, unit = [], []
        for d, line in enumerate(self.lines):
            at = numpy.clip((flat[:, d] - line[0]) / (line[1] - line[0]), 0, len(line) - 1)
            first.append(numpy.minimum(at.astype(int), len(line) - 2))
            unit.append(at - first[d])
        for corner in numpy.ndindex(*(2,) * self.dim):
            weight = numpy.prod([u if c else 1 - u for u, c in zip(unit, corner)], axis=0)
            shares += weight * self.shares[(slice(None), *(f + c for f, c in zip(first, corner)))]
        others = [numpy.delete(shares, n, axis=0).max(axis=0) for n in range(len(shares))]
        # of equal ones the last has it
        return (others - shares + 1e-12).T.reshape(places.shape[:-1] + (-1,))

    def at(self, places):
        """Numbers of the fluids at places [n, dim] [m]."""
        if not self.are_several:
            return numpy.full(len(places), self.of_point.max(initial=0))
        return self.levels(places).argmin(axis=1)

    def _refined(self, triangles):
        """Smaller where fluids meet: their shares are known on finer cells than the
        triangles' own."""
        for _ in range(FINER):
            places = quartered(triangles[:, :, :self.dim])
            pure = self.levels(places).min(axis=2) < PURE
            pure = pure.all(axis=1).reshape(4, -1).all(axis=0)
            triangles = numpy.concatenate([triangles[pure], quartered(triangles[~pure])])
        return triangles

    def _cuts(self, triangles):
        """For each fluid but the last what those before it leave, with the levels of all
        behind the attributes, and its own level; at the end what is the last one's."""
        left = self._refined(triangles)
        left = numpy.dstack([left, self.levels(left[:, :, :self.dim])])
        for number in range(len(self.names) - 1):
            level = left[:, :, triangles.shape[2] + number]
            yield left, level
            left = clip_triangles(left, -level)
        yield left, None

    def divided(self, triangles):
        """[(number, the triangles inside this fluid)]."""
        if not self.are_several:
            return [(self.of_point.max(initial=0), triangles)]
        parts = [left if level is None else clip_triangles(left, level)
                 for left, level in self._cuts(triangles)]
        return [(number, part[:, :, :triangles.shape[2]]) for number, part in enumerate(parts)]

    def borders(self, triangles):
        """Lines [m, 2, dim] [m] on triangles where fluids meet."""
        if not self.are_several:
            return numpy.zeros((0, 2, self.dim))
        return numpy.concatenate([cut_lines(left, level)[:, :, :self.dim]
                                  for left, level in self._cuts(triangles) if level is not None])

    def bodies(self, water):
        """In 3D: corners and normals [n, 3, 3] of what bounds the fluids but the first
        inside the water, and their numbers [n]."""
        wet = (water.level[:water.own] < 0).any(axis=1)
        corners = numpy.dstack([water.corners[:water.own][wet], water.level[:water.own][wet]])
        levels = self.levels(corners[:, :, :3])
        result = []
        for number in range(1, len(self.names)):
            cut = (levels[:, :, number].min(axis=1) < 0) & (levels[:, :, number].max(axis=1) >= 0)
            split, level = (numpy.einsum("tvc,nc...->ntv...", tetrahedra(), values[cut])
                            for values in (corners, levels[:, :, number]))
            sides = surface_of_tetrahedra(split.reshape(-1, 4, 4), level.reshape(-1, 4))
            normals = smooth_normals(sides[:, :, :3], water.size)
            inside = clip_triangles(numpy.dstack([sides[:, :, :3], normals]), sides[:, :, 3])
            result.append((inside, numpy.full(len(inside), number)))
        sides, numbers = (numpy.concatenate(values) for values in zip(*result))
        return sides[:, :, :3], sides[:, :, 3:], numbers
