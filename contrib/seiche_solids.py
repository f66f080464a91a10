# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distance from walls of any shape, of which the pieces are known: lines in two
dimensions, triangles in three (numpy only).

    solids = Solids(pieces, lower, upper)    pieces [n, dim, dim] [m], normals into the fluid
    solids.distance(places)                  [n] [m], positive in the fluid

Near a wall the nearest piece is looked for in buckets; farther off the sign counts alone."""

import itertools

import numpy

PAIRS = 1 << 20  # of places and pieces that are worked on at once
MOST = 4e6  # buckets
SAME = 1e-6  # distance of places that are one, over the width of a bucket


def closest(places, pieces):
    """Vectors from the nearest points of lines [n, 2, 2] or triangles [n, 3, 3] to places
    [n, dim]."""
    dim = places.shape[1]
    result, best = None, None
    for i in range(dim if dim == 3 else 1):  # edges
        start = pieces[:, i]
        way, to = pieces[:, (i + 1) % dim] - start, places - start
        share = numpy.clip(dot(to, way) / numpy.maximum(dot(way, way), 1e-300), 0, 1)
        away = to - share[:, None] * way
        square = dot(away, away)
        if result is None:
            result, best = away, square
        else:
            nearer = square < best
            result[nearer], best[nearer] = away[nearer], square[nearer]
    if dim == 3:  # above the face its plane is nearer than any edge
        normal = normals_of(pieces)
        to = places - pieces[:, 0]
        above = numpy.ones(len(places), bool)
        for i in range(3):
            edge = pieces[:, (i + 1) % 3] - pieces[:, i]
            above &= dot(numpy.cross(edge, places - pieces[:, i]), normal) >= 0
        result[above] = (dot(to, normal)[:, None] * normal)[above]
    return result


def dot(a, b):
    return numpy.einsum("nd,nd->n", a, b)


def normals_of(pieces):
    """Of length one [n, dim]; those of lines point to their right."""
    way = pieces[:, 1] - pieces[:, 0]
    if pieces.shape[1] == 2:
        normal = numpy.stack([way[:, 1], -way[:, 0]], axis=1)
    else:
        normal = numpy.cross(way, pieces[:, 2] - pieces[:, 0])
    return normal / numpy.maximum(numpy.linalg.norm(normal, axis=1), 1e-300)[:, None]


def spread(values):
    """Zeros take over what stands before or behind them along one direction, those that
    are left along the next one; in place."""
    for d in range(values.ndim):
        for line in (numpy.moveaxis(values, d, 0), numpy.moveaxis(values, d, 0)[::-1]):
            number = numpy.arange(len(line)).reshape((-1,) + (1,) * (values.ndim - 1))
            last = numpy.maximum.accumulate(numpy.where(line != 0, number, 0), axis=0)
            line[...] = numpy.take_along_axis(line, last, axis=0)


class Solids:
    def __init__(self, pieces, lower, upper):
        self.dim = pieces.shape[2]
        centres = pieces.mean(axis=1)
        reach = numpy.linalg.norm(pieces - centres[:, None], axis=2).max()
        # Twice the reach: every piece within a bucket's width of its middle is found.
        self.width = max(2 * reach, (numpy.prod(upper - lower) / MOST)**(1 / self.dim))
        self.low = lower - 1.5 * self.width
        self.shape = numpy.ceil((upper - lower) / self.width).astype(int) + 3
        key = self._key(self._bucket(centres))
        order = numpy.argsort(key, kind="stable")
        self.pieces, self.normals = pieces[order], normals_of(pieces[order])
        self.centres, self.reach = centres[order], reach
        self.count = numpy.bincount(key, minlength=numpy.prod(self.shape))
        self.first = numpy.cumsum(self.count) - self.count
        self._fill()

    def _bucket(self, places):
        return numpy.clip(((places - self.low) / self.width).astype(int), 0, self.shape - 1)

    def _key(self, index):
        return numpy.ravel_multi_index(index.T, self.shape)

    def _fill(self):
        """Which buckets have pieces around them; distances of the middles of all."""
        occupied = numpy.pad((self.count > 0).reshape(self.shape), 1)
        near = numpy.zeros(self.shape, bool)
        for offset in itertools.product(range(3), repeat=self.dim):
            near |= occupied[tuple(slice(o, o + n) for o, n in zip(offset, self.shape))]
        self.near = near.ravel()
        index = numpy.argwhere(near)
        values = numpy.zeros(len(self.near))
        values[self.near] = self._nearest(self.low + (index + 0.5) * self.width, index)
        # a piece that was not found may lie before one that is far
        values[abs(values) > self.width] = 0.0
        values = numpy.where(values == 0, 0.0, numpy.copysign(self.width, values)).reshape(self.shape)
        spread(values)
        self.beyond = values.ravel()

    def distance(self, places):
        """At places [n, dim] [m]; plus or minus the width of a bucket far from walls."""
        places, number = self._unique(places)
        index = self._bucket(places)
        key = self._key(index)
        result, near = self.beyond[key], self.near[key]
        result[near] = self._nearest(places[near], index[near])
        return result[number]

    def _unique(self, places):
        """Corners that triangles share once, and the number of each place among them."""
        key = numpy.rint(places / (SAME * self.width)).astype(numpy.int64)
        key = numpy.ascontiguousarray(key).view([("", numpy.int64)] * self.dim).ravel()
        first, number = numpy.unique(key, return_index=True, return_inverse=True)[1:]
        return places[first], number.ravel()

    def _nearest(self, places, index):
        """The same from the pieces in and around buckets [n, dim]."""
        offsets = numpy.array(list(itertools.product((-1, 0, 1), repeat=self.dim)))
        around = index[:, None] + offsets
        inside = ((around >= 0) & (around < self.shape)).all(axis=2)
        keys = self._key(numpy.clip(around, 0, self.shape - 1).reshape(-1, self.dim)).reshape(inside.shape)
        count = numpy.where(inside, self.count[keys], 0)
        ends = numpy.cumsum(count.sum(axis=1))
        result, start = numpy.empty(len(places)), 0
        while start < len(places):
            done = ends[start - 1] if start else 0
            end = max(start + 1, int(numpy.searchsorted(ends, done + PAIRS, "right")))
            part = slice(start, end)
            result[part] = self._of_pairs(places[part], self.first[keys[part]], count[part])
            start = end
        return result

    def _of_pairs(self, places, first, count):
        """From count [n, m] pieces behind first [n, m] each. Of pieces that are equally
        near, on both sides of an edge, the one that is seen steeper has the sign."""
        flat = count.ravel()
        piece = numpy.repeat(first.ravel() - (numpy.cumsum(flat) - flat), flat) + numpy.arange(flat.sum())
        number = count.sum(axis=1)
        place = numpy.repeat(numpy.arange(len(places)), number)
        to = places[place] - self.centres[piece]
        to = numpy.sqrt(dot(to, to))
        # no piece is nearer than its centre by more than the reach
        kept = to <= numpy.minimum.reduceat(to, numpy.cumsum(number) - number)[place] + self.reach
        piece, place = piece[kept], place[kept]
        start = numpy.searchsorted(place, numpy.arange(len(places)))
        away = closest(places[place], self.pieces[piece])
        distance = numpy.sqrt(dot(away, away))
        least = numpy.minimum.reduceat(distance, start)
        side = numpy.where(distance <= least[place] * (1 + 1e-6) + 1e-12,
                           dot(away, self.normals[piece]), 0.0)
        steepest = numpy.maximum.reduceat(side, start) + numpy.minimum.reduceat(side, start)
        return numpy.copysign(least, steepest)
