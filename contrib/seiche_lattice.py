# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lattices of cells that points fill, and means on them (numpy only)."""

import itertools

import numpy

LARGEST = 4e6  # cells of a lattice


def deposit(places, sizes, lines, weights):
    """Sums of weights [n] over the cells between lines, one array a direction, [m].
    A point is a cube of a size [m], at most as wide as a cell: taken as a dot it
    would beat with the cells."""
    dim = len(lines)
    first, share = [], []
    for d in range(dim):
        width = lines[d][1] - lines[d][0]
        low = (places[:, d] - 0.5 * sizes - lines[d][0]) / width
        first.append(numpy.floor(low).astype(int))
        share.append(numpy.clip((first[d] + 1 - low) * width / sizes, 0, 1))
    shape = [len(line) - 1 for line in lines]
    result = numpy.zeros(shape)
    for corner in itertools.product((0, 1), repeat=dim):
        index = [(first[d] + c).clip(0, shape[d] - 1) for d, c in enumerate(corner)]
        part = numpy.prod([1 - share[d] if c else share[d] for d, c in enumerate(corner)], axis=0)
        numpy.add.at(result, tuple(index), weights * part)
    return result


def means_of_neighbours(values, passes):
    """Mean over each value and those beside it, in every direction; the edge is
    repeated."""
    for _ in range(passes):
        for d in range(values.ndim):
            padded = numpy.pad(values, [(int(e == d),) * 2 for e in range(values.ndim)], "edge")
            n = values.shape[d]
            values = sum(numpy.take(padded, range(k, k + n), axis=d) for k in range(3)) / 3
    return values


def to_nodes(values):
    """From the cells of a lattice to its nodes."""
    for d in range(values.ndim):
        padded = numpy.pad(values, [(int(e == d),) * 2 for e in range(values.ndim)], "edge")
        n = values.shape[d] + 1
        values = 0.5 * (numpy.take(padded, range(n), axis=d)
                        + numpy.take(padded, range(1, n + 1), axis=d))
    return values


def lattice_about(x, sizes, wide, walls):
    """Lines, one array a direction, about points [n, dim] between the walls, and the width
    between them at most about: `wide` times that of a point [m]."""
    dim = x.shape[1]
    width = max(wide * float(numpy.percentile(sizes, 95)), (numpy.prod(numpy.ptp(x, axis=0)) / LARGEST)**(1 / dim))
    lines = []
    for d in range(dim):
        low, high = walls.lower[d], walls.upper[d]
        line = numpy.linspace(low, high, max(1, int((high - low) / width)) + 1)
        step = line[1] - line[0]
        used = (line > x[:, d].min() - 4 * step) & (line < x[:, d].max() + 4 * step)
        lines.append(line[used])
    return lines, width


def half_cell(run):
    """That of a run over the width of a point."""
    per_cell = run.numbers("Points/Per cell and direction")
    return max(1.0, 0.5 * sum(per_cell))


def lattice_cells(lines, shape):
    """Corners [n, 2^dim, dim] of a lattice's cells, and the numbers of their nodes."""
    dim = len(lines)
    nodes = numpy.stack(numpy.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, dim)
    first = numpy.stack(numpy.meshgrid(*(numpy.arange(n) for n in shape), indexing="ij"), axis=-1)
    first = first.reshape(-1, dim)
    numbers = [
        numpy.ravel_multi_index((first + [v >> d & 1 for d in range(dim)]).T, [n + 1 for n in shape])
        for v in range(2**dim)
    ]
    numbers = numpy.stack(numbers, axis=1)
    return nodes[numbers], numbers


def with_images(start, seams):
    """Numbers of the cells [n, 2^dim, dim] and, behind them, of those that lie at a seam,
    {direction: (lower, upper)} [m], once more for their images beyond the other side;
    how far these are away [m]."""
    number, shift = numpy.arange(len(start)), numpy.zeros((len(start), start.shape[2]))
    for d, (lower, upper) in seams.items():
        place = start[number, :, d] + shift[:, None, d]
        near = 1e-3 * numpy.ptp(place, axis=1).min()
        numbers, shifts = [number], [shift]
        for side, way in ((lower, upper - lower), (upper, lower - upper)):
            beside = (abs(place - side) < near).any(axis=1)
            numbers.append(number[beside])
            shifts.append(shift[beside] + way * numpy.eye(start.shape[2])[d])
        number, shift = numpy.concatenate(numbers), numpy.concatenate(shifts)
    return number, shift
