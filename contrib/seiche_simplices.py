# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cells divided into triangles and tetrahedra as the program divides them, and cut
where a level is zero (numpy only). Corners of cells are in bit order: bit d of the
number is direction d."""

import itertools

import numpy


def smooth_normals(corners, size):
    """Normals [n, 3, 3] of triangles, shared by corners that lie within a small
    part of a size [m]."""
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    keys = numpy.rint(corners.reshape(-1, 3) / (1e-3 * size)).astype(numpy.int64)
    vertex = numpy.unique(keys, axis=0, return_inverse=True)[1].reshape(-1, 3)
    sums = numpy.zeros((vertex.max() + 1 if len(vertex) else 0, 3))
    for c in range(3):
        numpy.add.at(sums, vertex[:, c], normals)
    for _ in range(2):  # what is left of the cells' edges
        around = sums[vertex].sum(axis=1)
        sums = numpy.zeros_like(sums)
        for c in range(3):
            numpy.add.at(sums, vertex[:, c], around)
        sums /= numpy.maximum(numpy.linalg.norm(sums, axis=1), 1e-300)[:, None]
    return sums[vertex]


def clip_triangles(corners, level):
    """The parts of triangles with attributes [n, 3, k] where the level [n, 3] is
    negative, as triangles [m, 3, k]."""
    inside = level < 0
    number = inside.sum(axis=1)
    parts = [corners[number == 3]]
    for wanted in (1, 2):
        c, l, i = (a[number == wanted] for a in (corners, level, inside))
        # the odd corner first, the direction of rotation kept
        odd = numpy.argmax(i == (wanted == 1), axis=1)
        turn = (odd[:, None] + numpy.arange(3)) % 3
        rows = numpy.arange(len(c))[:, None]
        c, l = c[rows, turn], l[rows, turn]
        share = (l[:, :1] / (l[:, :1] - l[:, 1:]))[:, :, None]
        cut = c[:, :1] + share * (c[:, 1:] - c[:, :1])
        if wanted == 1:
            parts.append(numpy.stack([c[:, 0], cut[:, 0], cut[:, 1]], axis=1))
        else:
            parts.append(numpy.stack([cut[:, 0], c[:, 1], c[:, 2]], axis=1))
            parts.append(numpy.stack([cut[:, 0], c[:, 2], cut[:, 1]], axis=1))
    return numpy.concatenate(parts)


def quartered(triangles):
    """Triangles with attributes [n, 3, k] as four each, between the middles of their
    edges [4 n, 3, k]."""
    a, b, c = (triangles[:, i] for i in range(3))
    ab, bc, ca = 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)
    return numpy.concatenate([numpy.stack(part, axis=1) for part in (
        (a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])


def cut_lines(corners, level):
    """Where the level [n, 3] of triangles with attributes [n, 3, k] is zero: lines
    [m, 2, k]."""
    inside = level < 0
    number = inside.sum(axis=1)
    lines = []
    for wanted in (1, 2):
        c, l, i = (a[number == wanted] for a in (corners, level, inside))
        odd = numpy.argmax(i == (wanted == 1), axis=1)
        rows = numpy.arange(len(c))
        ends = []
        for turn in (1, 2):
            other = (odd + turn) % 3
            share = (l[rows, odd] / (l[rows, odd] - l[rows, other]))[:, None]
            ends.append(c[rows, odd] + share * (c[rows, other] - c[rows, odd]))
        lines.append(numpy.stack(ends, axis=1))
    return numpy.concatenate(lines)


def without_needles(triangles, thickness):
    """Triangles [n, 3, (x, y, ...)] without those thinner than [m]: matplotlib widens
    triangles to close the gaps between them; of needles that would be seen."""
    a, b = (triangles[:, i, :2] - triangles[:, 0, :2] for i in (1, 2))
    longest = numpy.sqrt(numpy.max([(v**2).sum(axis=1) for v in (a, b, a - b)], axis=0))
    return triangles[abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) > thickness * longest]


def fans(corners, level):
    """Quadrilaterals in bit order, attributes [n, 4, k], as four triangles around
    their centres each, as the program divides its cells."""
    centre, middle = corners.mean(axis=1), level.mean(axis=1)
    triangles, levels = [], []
    for a, b in ((0, 1), (1, 3), (3, 2), (2, 0)):
        triangles.append(numpy.stack([centre, corners[:, a], corners[:, b]], axis=1))
        levels.append(numpy.stack([middle, level[:, a], level[:, b]], axis=1))
    return numpy.concatenate(triangles), numpy.concatenate(levels)


def tetrahedra():
    """The program's 24 tetrahedra of a cell: weights of the eight corners at the
    four vertices [24, 4, 8] (doc/theory.md, the free surface)."""
    result = []
    for d, side in itertools.product(range(3), (0, 1)):
        face = [v for v in range(8) if v >> d & 1 == side]
        for v, e in itertools.product(face, range(3)):
            if e != d and not v >> e & 1:
                weights = numpy.zeros((4, 8))
                weights[0] = 1 / 8
                weights[1, face] = 1 / 4
                weights[2, v] = weights[3, v | 1 << e] = 1
                result.append(weights)
    return numpy.array(result)


def surface_of_tetrahedra(corners, level):
    """Triangles [m, 3, k] of the zero level in tetrahedra with attributes [n, 4, k];
    the first three are coordinates, by which the triangles face outwards."""
    inside = level < 0
    number = inside.sum(axis=1)
    order = numpy.argsort(~inside, axis=1, kind="stable")  # inside ones first
    triangles, inner = [], []
    for wanted, pieces in ((1, (((0, 1), (0, 2), (0, 3)),)), (3, (((0, 3), (1, 3), (2, 3)),)),
                           (2, (((0, 2), (0, 3), (1, 3)), ((0, 2), (1, 3), (1, 2))))):
        chosen = number == wanted
        turn, rows = order[chosen], numpy.arange(chosen.sum())[:, None]
        c, l = corners[chosen][rows, turn], level[chosen][rows, turn]
        for piece in pieces:
            cut = []
            for a, b in piece:
                share = (l[:, a] / (l[:, a] - l[:, b]))[:, None]
                cut.append(c[:, a] + share * (c[:, b] - c[:, a]))
            triangles.append(numpy.stack(cut, axis=1))
            inner.append(c[:, 0, :3])  # a vertex that is inside
    triangles, inner = numpy.concatenate(triangles), numpy.concatenate(inner)
    x = triangles[:, :, :3]
    normal = numpy.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])
    inwards = numpy.einsum("ij,ij->i", normal, inner - x[:, 0]) > 0
    triangles[inwards] = triangles[inwards][:, [0, 2, 1]]
    return triangles
