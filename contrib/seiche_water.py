# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the water of a frame is: a level, negative inside, on cells (numpy only).

    water = water_of(run, time, points)                   a Water
    corners, values = water.triangles("pressure")         2D, to be filled
    corners, normals, values = water.skin(walls, "speed") 3D, free surface and wetted walls
    level, values = water.sample(places, "speed")         anywhere
"""

import itertools

import numpy

from seiche_lattice import (
    deposit, half_cell, lattice_about, lattice_cells, means_of_neighbours, to_nodes, with_images)
from seiche_output import field, read_frame
from seiche_simplices import (
    clip_triangles, cut_lines, fans, smooth_normals, surface_of_tetrahedra, tetrahedra, without_needles)

LEVEL = "level set [cells]"
VTK_ORDER = {2: [0, 1, 3, 2], 3: [0, 1, 3, 2, 4, 5, 7, 6]}  # to bit order
OUTSIDE = 9.0  # level [cells] where there is no cell
SPRAY = 0.25  # level [cells] from which on a point is drawn as spray
INVERSIONS = 3  # of x + u(x), each gains a digit or so
NEAR_SIDE = 1e-3  # [cells] by which a place may miss its cell
BESIDE_WALL = 0.3  # [cells] from a wall to where a cell is looked for
NEEDLE = 0.015  # [cells] triangles that are thinner are not drawn


def scalar(frame, name):
    """Values of "pressure" or "speed" [n]."""
    if name == "speed":
        return numpy.linalg.norm(field(frame, "velocity"), axis=1)
    return field(frame, name)


def water_of(run, time, points):
    """The Water at a time [s]: inside the level set of the grid's frame, or, without
    cut cells or frames of the grid, where the points fill the space; their frame."""
    path = run.frame_at("grid", time)
    frame = read_frame(path) if path else {}
    walls = run.walls_at(time)
    if LEVEL in frame and numpy.any(frame[LEVEL] < 0):
        seams = {d: (walls.lower[d], walls.upper[d]) for d in run.periodic()}
        return Water.of_grid(frame, run.dim, seams, walls)
    return Water.of_points(points, walls, run.dim, half_cell(run))


def left_out_beside(start, walls):
    """Cells beside those [n, 2^dim, dim] that walls of solids cut and that are not occupied,
    as too little of them is wet: the water goes on there as it is at the common face. The
    number of the cell beside, its corner that each corner takes after, how far they are
    away [m]."""
    count, dim = start.shape[1:]
    finder = Water(start, numpy.zeros_like(start), numpy.zeros(start.shape[:2]), None)
    corners = numpy.arange(count)
    numbers, sources, shifts = [], [], []
    for d, side in itertools.product(range(dim), (0, 1)):
        shift = numpy.zeros((len(start), dim))
        shift[:, d] = (2 * side - 1) * (start[:, -1, d] - start[:, 0, d])
        middle = start.mean(axis=1) + shift
        number = numpy.flatnonzero(((middle > walls.lower) & (middle < walls.upper)).all(axis=1)
                                   & (finder._find(middle) < 0))
        there = start[number] + shift[number][:, None]
        # not where smaller cells are
        inner = 0.5 * (there + there.mean(axis=1, keepdims=True)).reshape(-1, dim)
        distance = walls.distance(there.reshape(-1, dim)).reshape(-1, count)
        chosen = ((finder._find(inner).reshape(-1, count) < 0).all(axis=1)
                  & (distance.min(axis=1) < 0) & (distance.max(axis=1) > 0))
        numbers.append(number[chosen])
        shifts.append(shift[number[chosen]])
        sources.append(numpy.repeat([corners | 1 << d if side else corners & ~(1 << d)], chosen.sum(), axis=0))
    numbers, sources, shifts = (numpy.concatenate(parts) for parts in (numbers, sources, shifts))
    middle = numpy.rint((start[numbers].mean(axis=1) + shifts) / (1e-3 * finder.size))
    once = numpy.unique(middle, axis=0, return_index=True)[1]
    return numbers[once], sources[once], shifts[once]


class Water:
    """Cells with a level at their corners, and fields to colour by."""

    def __init__(self, start, displacement, level, fields, own=None):
        """Corners [n, 2^dim, dim] at the start of the step and how far they move [m],
        level [n, 2^dim] [cells]; fields: name -> values [n, 2^dim] or vectors. Cells
        behind the first `own` are images of others."""
        self.dim = start.shape[2]
        self.own = len(start) if own is None else own
        self.start, self.displacement, self.level = start, displacement, level
        self.corners = start + displacement
        self.values = fields
        self.size = float(numpy.median(start[:, 1, 0] - start[:, 0, 0]))
        self._make_finder()

    @staticmethod
    def of_grid(frame, dim, seams, walls):
        cells = frame["cells"][:, VTK_ORDER[dim]]
        places = frame["points"][cells][:, :, :dim].astype(float)
        if len(walls.solids):
            number, corner, shift = left_out_beside(places, walls)
            cells = numpy.concatenate([cells, cells[number[:, None], corner]])
            places = numpy.concatenate([places, places[number] + shift[:, None]])

        def values(name):
            if name == "velocity":
                return field(frame, name)[cells][:, :, :dim].astype(float)
            return scalar(frame, name)[cells].astype(float)

        own = len(cells)
        number, shift = with_images(places, seams)
        cells = cells[number]
        start = places[number] + shift[:, None]
        displacement = field(frame, "displacement")[cells][:, :, :dim].astype(float)
        return Water(start, displacement, frame[LEVEL][cells].astype(float), values, own)

    @staticmethod
    def of_points(frame, walls, dim, wide):
        """Cells `wide` times as wide as a point, half a cell of the run, for flow draws
        rows of points apart; full where points take more than half of the room that
        obstacles and solids leave."""
        x, sizes = frame["points"][:, :dim].astype(float), 2.0 * field(frame, "radius").astype(float)
        lines, width = lattice_about(x, sizes, wide, walls)
        sizes = numpy.minimum(sizes, width)
        volume = numpy.prod([line[1] - line[0] for line in lines])
        corners, numbers = lattice_cells(lines, [len(line) - 1 for line in lines])
        shape = [len(line) - 1 for line in lines]
        centre = corners.mean(axis=1)
        room = numpy.ones(len(centre))
        for low, high in walls.obstacles:
            room[((centre > low) & (centre < high)).all(axis=1)] = 0.0
        room *= numpy.clip(0.5 + walls.distance(centre) / width, 0, 1)
        room = room.reshape(shape)
        free = numpy.maximum(to_nodes(means_of_neighbours(room, 1)), 1e-3)
        own = (2.0 * field(frame, "radius").astype(float))**dim

        def spread(values):
            return to_nodes(means_of_neighbours(deposit(x, sizes, lines, own * values), 1))

        share = spread(numpy.ones(len(x)))
        level = 2.0 * (0.5 - share / (volume * free))
        level = level.ravel()[numbers]
        known = numpy.maximum(share, 1e-12 * volume)

        def values(name):
            if name != "velocity":
                return (spread(scalar(frame, name)) / known).ravel()[numbers]
            velocity = field(frame, name)
            return numpy.stack([(spread(velocity[:, d]) / known).ravel()[numbers]
                                for d in range(dim)], axis=-1)

        kept = room.ravel() > 0
        return Water(corners[kept], numpy.zeros_like(corners[kept]), level[kept],
                     lambda name: values(name)[kept])

    def triangles(self, name):
        """In 2D: corners [n, 3, 2] [m] and values [n, 3] there; beyond the seams also."""
        wet = (self.level < 0).any(axis=1)
        columns = numpy.dstack([self.corners, self.values(name)])[wet]
        clipped = clip_triangles(*fans(columns, self.level[wet]))
        clipped = without_needles(clipped, NEEDLE * self.size)
        return clipped[:, :, :2], clipped[:, :, 2]

    def outline(self):
        """In 2D: the free surface as lines [n, 2, 2] [m]."""
        cut = (self.level.min(axis=1) < 0) & (self.level.max(axis=1) >= 0)
        return cut_lines(*fans(self.corners[cut], self.level[cut]))

    def skin(self, walls, name):
        """What is seen from outside, the free surface and the wetted sides of the box and
        of obstacles, without what lies in solids: corners [n, 3, 3], normals [n, 3, 3]
        and values [n, 3]."""
        columns = numpy.dstack([self.corners, self.values(name)])
        real = numpy.arange(len(self.level)) < self.own
        cut = real & (self.level.min(axis=1) < 0) & (self.level.max(axis=1) >= 0)
        weights = tetrahedra()
        split = numpy.einsum("tvc,nck->ntvk", weights, columns[cut]).reshape(-1, 4, 4)
        level = numpy.einsum("tvc,nc->ntv", weights, self.level[cut]).reshape(-1, 4)
        surface = surface_of_tetrahedra(split, level)
        faces = [numpy.dstack([surface, smooth_normals(surface[:, :, :3], self.size)])]
        for d, side in itertools.product(range(3), (0, 1)):
            on_face = [v for v in range(8) if v >> d & 1 == side]
            wet = self.level[:, on_face].min(axis=1) < 0
            chosen = real & wet & self._on_wall(walls, d, side, on_face)
            face = clip_triangles(*fans(columns[chosen][:, on_face], self.level[chosen][:, on_face]))
            outwards = numpy.zeros((len(face), 3, 3))
            outwards[:, :, d] = 2 * side - 1
            faces.append(numpy.dstack([face, outwards]))
        faces = numpy.concatenate(faces)
        if len(walls.solids):  # into which the level goes on
            inwards = -walls.distance(faces[:, :, :3].reshape(-1, 3)).reshape(-1, 3)
            faces = clip_triangles(faces, inwards)
        return faces[:, :, :3], faces[:, :, 4:], faces[:, :, 3]

    def on_solids(self, walls, name):
        """The same of the wetted walls of solids, which close the skin."""
        normals = -smooth_normals(walls.solids, self.size)
        places = walls.solids.reshape(-1, 3)
        level, values = self.sample(places, name)
        for _ in range(2):  # cells with a little room beside a wall are not occupied
            missing = level == OUTSIDE
            places = places - BESIDE_WALL * self.size * normals.reshape(-1, 3)
            level[missing], values[missing] = self.sample(places[missing], name)
        faces = numpy.dstack([walls.solids, values.reshape(-1, 3), normals])
        faces = clip_triangles(faces, level.reshape(-1, 3))
        return faces[:, :, :3], faces[:, :, 4:], faces[:, :, 3]

    def _on_wall(self, walls, d, side, on_face):
        """Which cells have this face on a side of the box or of an obstacle."""
        places = [(walls.upper if side else walls.lower)[d]]
        near = 1e-3 * self.size
        result = numpy.zeros(len(self.start), bool)
        for corners in (self.start, self.corners):  # fixed walls, moving ones
            face = corners[:, on_face]
            result |= (abs(face[:, :, d] - places[0]) < near).all(axis=1)
            for low, high in walls.obstacles:
                centre = face.mean(axis=1)
                touches = abs(face[:, :, d] - (low if side else high)[d]) < near
                others = [e for e in range(3) if e != d]
                beside = ((centre > low) & (centre < high))[:, others].all(axis=1)
                result |= touches.all(axis=1) & beside
        return result

    def _make_finder(self):
        """Sorted numbers of the finest lattice's cells and the cells there."""
        low, high = self.start[:, 0], self.start[:, -1]
        near = 1e-4 * (high - low).min()
        self.lines = []
        for d in range(self.dim):
            places = numpy.sort(numpy.concatenate([low[:, d], high[:, d]]))
            self.lines.append(places[numpy.append(True, numpy.diff(places) > near)] - near)
        first = self._lattice(low + 2 * near)
        count = self._lattice(high + 2 * near) - first
        keys, owners = [], []
        for offset in itertools.product(*(range(int(count[:, d].max())) for d in range(self.dim))):
            holds = (numpy.array(offset) < count).all(axis=1)
            keys.append(self._key(first[holds] + offset))
            owners.append(numpy.flatnonzero(holds))
        keys, owners = numpy.concatenate(keys), numpy.concatenate(owners)
        order = numpy.argsort(keys)
        self.keys, self.owners = keys[order], owners[order]

    def _lattice(self, places):
        return numpy.stack([numpy.searchsorted(self.lines[d], places[:, d], "right") - 1
                            for d in range(self.dim)], axis=1)

    def _key(self, index):
        result = index[:, 0].astype(numpy.int64)
        for d in range(1, self.dim):
            result = result * (len(self.lines[d]) + 1) + index[:, d]
        return result

    def _find(self, places):
        """Cell of each place [m] at the start of the step (-1: none); what lies on an
        upper side belongs to the cell before it."""
        result = numpy.full(len(places), -1)
        for offset in itertools.product((0, -1, 1), repeat=self.dim):
            missing = numpy.flatnonzero(result < 0)
            key = self._key(self._lattice(places[missing] + NEAR_SIDE * self.size * numpy.array(offset)))
            at = numpy.minimum(numpy.searchsorted(self.keys, key), len(self.keys) - 1)
            result[missing] = numpy.where(self.keys[at] == key, self.owners[at], -1)
        return result

    def _weights(self, places, cell):
        low, high = self.start[cell, 0], self.start[cell, -1]
        unit = numpy.clip((places - low) / (high - low), 0, 1)
        return numpy.stack(
            [numpy.prod([unit[:, d] if v >> d & 1 else 1 - unit[:, d] for d in range(self.dim)],
                        axis=0) for v in range(2**self.dim)], axis=1)

    def sample(self, places, *names):
        """Level [cells] and values of fields at places [n, dim] [m]; where there is no
        cell the level is OUTSIDE and the values are zero."""
        origin = numpy.array(places, float)
        for _ in range(INVERSIONS):
            cell = self._find(origin)
            moved = numpy.zeros_like(origin)
            inside = cell >= 0
            weights = self._weights(origin[inside], cell[inside])
            moved[inside] = numpy.einsum("nv,nvd->nd", weights, self.displacement[cell[inside]])
            origin = numpy.where(inside[:, None], places - moved, origin)
        cell = self._find(origin)
        inside = cell >= 0
        weights = self._weights(origin[inside], cell[inside])
        result = []
        for values, default in [(self.level, OUTSIDE)] + [(self.values(n), 0.0) for n in names]:
            here = values[cell[inside]]
            found = numpy.full((len(places),) + here.shape[2:], default)
            found[inside] = numpy.einsum("nv,nv...->n...", weights, here)
            result.append(found)
        return result

    def spray(self, places):
        """Which points lie outside the water by more than a quarter of a cell."""
        return self.sample(places[:, :self.dim])[0] > SPRAY
