# SPDX-License-Identifier: LGPL-2.1-or-later
"""Oblique views of water among solids: bodies are opaque; of shells, which hold the
fluid, the far wall is seen behind the water and the near one as glass before it. Bodies
under water shine through it."""

import numpy

from seiche_views import GLASS, GROUND, LIGHT, WALL, View, shifted

BODY = 1.25 * WALL
SHELL = numpy.array([0.88, 0.91, 0.94])
TINT = numpy.array([0.45, 0.52, 0.60])  # of the glass in front
THIN, STEEP = 0.04, 0.45  # its opacity seen straight on and along
LINE = 0.25  # grey of edges, as those of obstacles
JUMP = 15.0  # [pixels] in height that is an edge; less is a slope
STEPS = 2  # points of a line a pixel
HIDDEN = 0.18  # opacity of lines behind something


def matte(colour, normals, contrast):
    """Colours [n, 3] of a dull surface; normals [n, 3] in the picture's directions."""
    n = normals / numpy.maximum(numpy.linalg.norm(normals, axis=1), 1e-12)[:, None]
    light = LIGHT / numpy.linalg.norm(LIGHT)
    return numpy.clip(colour * (1 - contrast * (1 - numpy.clip(n @ light, -0.3, 1)))[:, None], 0, 1)


def around(values):
    """Those of the four pixels beside each."""
    return [shifted(values, *way) for way in ((0, 1), (0, -1), (1, 0), (-1, 0))]


class SceneryView(View):
    def __init__(self, scenery, lower, upper, direction, width, boxes=()):
        super().__init__(lower, upper, direction, width, boxes)
        self.background[:] = 1.0
        for d in range(3):
            self._paint_side(d, scenery.sides[d])
        self._add_shells(*scenery.shells)
        self._add_bodies(*scenery.bodies)
        self.rims = self._pixels_of(scenery.rims)

    def _paint_side(self, d, corners):
        """The side that bounds the fluid."""
        seen = numpy.isfinite(self.triangles(corners, numpy.zeros(corners.shape[:2] + (1,)))[0])
        self.background[seen] = GROUND if d == 2 else GLASS
        outline = self.far_side(d)[1]
        self.background[outline & (seen | numpy.any(around(seen), axis=0))] = 0.55

    def _nearest(self, corners, normals, front):
        """Height and normals in the picture's directions of pieces that face the eye, or
        of those that do not."""
        across = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        across *= numpy.sign((across * normals.sum(axis=1)).sum(axis=1))[:, None]
        chosen = (across @ self.axes[2] > 0) == front
        return self.triangles(corners[chosen], normals[chosen] @ self.axes.T)

    def _add_shells(self, corners, normals):
        far, found = self._nearest(corners, normals, True)
        self._put(far, matte(SHELL, found.reshape(-1, 3), 0.14).reshape(found.shape))
        self.glass, found = self._nearest(corners, normals, False)
        along = 1 - abs(found[:, :, 2]) / numpy.maximum(numpy.linalg.norm(found, axis=2), 1e-12)
        self.opacity = numpy.where(numpy.isfinite(self.glass), THIN + STEEP * along**3, 0.0)

    def _add_bodies(self, corners, normals):
        height, found = self.triangles(corners, normals @ self.axes.T)
        colours = matte(BODY, found.reshape(-1, 3), 0.40).reshape(found.shape)
        filled = numpy.where(numpy.isfinite(height), height, -1e9)
        edge = numpy.any([filled - other > JUMP * self.pixel for other in around(filled)], axis=0)
        colours[edge & numpy.isfinite(height)] = LINE
        self.sunk = self._put(height, colours)

    def _put(self, height, colours):
        """Before what there is; where."""
        seen = height > self.walls
        self.walls[seen] = height[seen]
        self.wall_colours[seen] = colours[seen]
        return seen

    def _pixels_of(self, lines):
        """Numbers of the pixels on lines [n, 2, 3] and heights there."""
        ends = self.project(lines)
        length = numpy.linalg.norm(numpy.diff(ends[:, :, :2], axis=1)[:, 0], axis=1)
        number = numpy.ceil(length / self.pixel * STEPS).astype(int) + 1
        line = numpy.repeat(numpy.arange(len(lines)), number)
        first = numpy.repeat(numpy.cumsum(number) - number, number)
        share = (numpy.arange(number.sum()) - first) / number[line]
        place = ends[line, 0] + share[:, None] * (ends[line, 1] - ends[line, 0])
        column, row = (numpy.floor((place[:, d] - self.low[d]) / self.pixel).astype(int) for d in (0, 1))
        shown = (row >= 0) & (row < self.shape[0]) & (column >= 0) & (column < self.shape[1])
        return row[shown], column[shown], place[shown, 2]

    def finish(self, image, nearest):
        """Glass and rims before the nearest thing at each pixel."""
        opacity = numpy.where(self.glass > nearest, self.opacity, 0.0)[:, :, None]
        image += opacity * (TINT - image)
        row, column, height = self.rims
        strength = numpy.zeros(self.shape)
        clear = height > nearest[row, column] - JUMP * self.pixel
        numpy.maximum.at(strength, (row, column), numpy.where(clear, 0.9, HIDDEN))
        strength = numpy.maximum(strength, shifted(strength, 0, 1))
        image += strength[:, :, None] * (LINE - image)
