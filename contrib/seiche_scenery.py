# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of solids and of the tank stands around the water in three dimensions, as
triangles in the room that is shown (numpy only).

    scenery = Scenery(walls, lower, upper, eye)
    scenery.bodies, scenery.shells   corners and normals [n, 3, 3]; of shells, solids that
                                     hold the fluid inside, the normals say which is in front
    scenery.sides[d]                 what bounds the fluid of the side across d that lies behind
    scenery.rims                     lines [n, 2, 3] where solids meet the room's sides"""

import numpy

from seiche_lattice import lattice_cells
from seiche_simplices import clip_triangles, cut_lines, fans, smooth_normals

CREASE = 0.8  # cosine of the angle from which on an edge is one
TINY = 1e-3  # area over the squared size of the largest piece: its normal says nothing
INSIDE = 2e-3  # of a piece's size: rims lie so far before the sides


def room_of(all_walls, lower, upper):
    """The part of a box [m] that walls of all times leave to the fluid: a side that lies in
    solids is moved to where their surface begins."""
    lower, upper = lower.copy(), upper.copy()
    if not all(walls.shells.any() for walls in all_walls):
        return lower, upper
    for d in range(3):
        for corner, end in ((lower, min), (upper, max)):
            if not any((walls.distance(nodes_of_side(walls, d, corner[d])) > 0).any()
                       for walls in all_walls):
                corner[d] = end(getattr(walls.solids[:, :, d], end.__name__)() for walls in all_walls)
    return lower, upper


def spacing(walls):
    """About the size of the pieces of solids [m]."""
    return float(numpy.ptp(walls.solids, axis=1).max())


def side_of(lower, upper, d, place, width):
    """The rectangle across direction d at a place [m] in squares about as wide as [m]:
    corners [n, 4, 3] in bit order and the numbers of their nodes."""
    across = [e for e in range(3) if e != d]
    lines = [numpy.linspace(lower[e], upper[e], int(numpy.ceil((upper[e] - lower[e]) / width)) + 1)
             for e in across]
    flat, numbers = lattice_cells(lines, [len(line) - 1 for line in lines])
    corners = numpy.full(flat.shape[:2] + (3,), float(place))
    corners[:, :, across] = flat
    return corners, numbers


def nodes_of_side(walls, d, place):
    return side_of(walls.lower, walls.upper, d, place, spacing(walls))[0].reshape(-1, 3)


def inside(triangles, lower, upper):
    """Triangles with attributes [n, 3, k], cut by a box."""
    for d in range(3):
        triangles = clip_triangles(triangles, lower[d] - triangles[:, :, d] - 1e-12)
        triangles = clip_triangles(triangles, triangles[:, :, d] - upper[d] - 1e-12)
    return triangles


def creased(pieces, size):
    """Normals [n, 3, 3] of pieces, smooth but across edges."""
    flat = numpy.cross(pieces[:, 1] - pieces[:, 0], pieces[:, 2] - pieces[:, 0])[:, None]
    area = numpy.linalg.norm(flat, axis=2, keepdims=True)
    smooth = smooth_normals(pieces, size)
    is_edge = (flat * smooth).sum(axis=2, keepdims=True) < CREASE * area
    return numpy.where(is_edge & (area > TINY * size**2), flat / numpy.maximum(area, 1e-300), smooth)


class Scenery:
    def __init__(self, walls, lower, upper, eye):
        self.walls, self.lower, self.upper = walls, lower, upper
        self.width = spacing(walls)
        near = numpy.where(numpy.asarray(eye) > 0, upper, lower)
        # a piece may lie in the plane of a side, and with it nothing of a solid
        area = numpy.cross(walls.solids[:, 1] - walls.solids[:, 0], walls.solids[:, 2] - walls.solids[:, 0])
        real = numpy.linalg.norm(area, axis=1) > 0
        self.bodies, self.shells = (self._pieces(walls.solids[real & (walls.shells == kind)])
                                    for kind in (False, True))
        if len(self.bodies[0]):
            caps = [self._cap(d, near[d], 1 if eye[d] > 0 else -1) for d in range(3)]
            self.bodies = [numpy.concatenate(parts) for parts in zip(self.bodies, *caps)]
        self.sides = [self._side(d, (lower + upper - near)[d]) for d in range(3)]
        self.rims = self._rims()

    def _pieces(self, pieces):
        if not len(pieces):
            return numpy.zeros((0, 3, 3)), numpy.zeros((0, 3, 3))
        part = inside(numpy.dstack([pieces, creased(pieces, self.width)]), self.lower, self.upper)
        return part[:, :, :3], part[:, :, 3:]

    def _levels(self, d, place, kind):
        """Side across d in squares, and the distance from solids at their corners."""
        corners, numbers = side_of(self.lower, self.upper, d, place, 0.5 * self.width)
        return corners, self.walls.distance(corners.reshape(-1, 3), kind).reshape(corners.shape[:2])

    def _cap(self, d, place, way):
        """Where a side of the room cuts bodies open."""
        corners, level = self._levels(d, place, "bodies")
        level = numpy.maximum(level, -self._levels(d, place, "shells")[1])
        part = clip_triangles(*fans(corners, level))
        normals = numpy.zeros_like(part)
        normals[:, :, d] = way
        return part, normals

    def _side(self, d, place):
        corners, level = self._levels(d, place, "all")
        return clip_triangles(*fans(corners, -level))

    def _rims(self):
        lines = []
        for d in range(3):
            for side, way in ((self.lower, 1), (self.upper, -1)):
                # none where a shell but touches the room's side
                if (self._levels(d, side[d], "all")[1] > 0.25 * self.width).any():
                    place = side[d] + way * INSIDE * self.width
                    lines += [cut_lines(corners, corners[:, :, d] - place)
                              for corners in (self.bodies[0], self.shells[0])]
        return numpy.concatenate(lines or [numpy.zeros((0, 2, 3))])
