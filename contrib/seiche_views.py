# SPDX-License-Identifier: LGPL-2.1-or-later
"""Oblique views of water in three dimensions, with numpy alone: triangles and balls
in a depth buffer, lit, and boxes that hide what is behind them."""

import numpy

FINER = 2  # pixels are averaged over squares of so many
LIGHT = numpy.array([-0.45, 0.55, 0.70])  # right, up, towards the eye
GROUND, WALL = numpy.array([0.94, 0.92, 0.88]), numpy.array([0.62, 0.60, 0.58])
GLASS = numpy.array([0.955, 0.965, 0.975])  # the sides of the tank behind the water
EDGE_PLACES = 201  # along an edge of the box
SAMPLES = 1 << 21  # pixels of triangles that are worked on at once
BORDER = numpy.array([0.04, 0.16, 0.27])  # between fluids
CLEAR = 0.5  # opacity of a fluid before another one or a body
GLOSS, SHININESS = 0.28, 36  # of the water
SHADOW = numpy.array([1.15, 0.9, 0.5])  # what it takes from red, green and blue


def shifted(values, rows, columns):
    """values[i + rows, j + columns]; the edge is repeated."""
    reach = max(abs(rows), abs(columns))
    padded = numpy.pad(values, reach, mode="edge")
    height, width = values.shape
    return padded[reach + rows:reach + rows + height, reach + columns:reach + columns + width]


class View:
    """Parallel projection of a domain [m] with boxes in it, [(lower, upper)],
    onto an image `width` pixels wide, seen from a direction (x, y, z), z > 0.
    Heights above the picture's plane are positive towards the eye."""

    def __init__(self, lower, upper, direction, width, boxes=()):
        eye = numpy.array(direction, float) / numpy.linalg.norm(direction)
        right = numpy.cross([0, 0, 1], eye)
        right /= numpy.linalg.norm(right)
        self.axes = numpy.array([right, numpy.cross(eye, right), eye])
        self.lower, self.upper = numpy.array(lower, float), numpy.array(upper, float)
        corners = self.project(self.corners(self.lower, self.upper))
        margin = 0.02 * numpy.ptp(corners[:, 0])
        low, high = corners[:, :2].min(axis=0) - margin, corners[:, :2].max(axis=0) + margin
        self.pixel = (high[0] - low[0]) / (width * FINER)
        rows = FINER * int(numpy.ceil((high[1] - low[1]) / (self.pixel * FINER)))
        self.shape, self.low = (rows, width * FINER), low
        self.extent = (low[0], high[0], low[1], low[1] + rows * self.pixel)
        self.background = numpy.ones(self.shape + (3,), "f4")
        for direction in range(3):
            inside, outline = self.far_side(direction)
            self.background[inside] = GROUND if direction == 2 else GLASS
            self.background[outline] = 0.55
        self.walls, self.wall_colours = self.boxes(boxes)
        self.sunk = numpy.zeros(self.shape, bool)  # what is there is seen through water

    @staticmethod
    def corners(lower, upper):
        return numpy.array([[(lower, upper)[i >> d & 1][d] for d in range(3)] for i in range(8)])

    def project(self, points):
        """To the right, upwards, towards the eye [m]."""
        return numpy.asarray(points) @ self.axes.T

    def rays(self, d, rows=slice(None), columns=slice(None)):
        """Coordinate d of the points of the picture's plane below the pixels."""
        right = self.low[0] + (numpy.arange(self.shape[1])[columns] + 0.5) * self.pixel
        up = self.low[1] + (numpy.arange(self.shape[0])[rows] + 0.5) * self.pixel
        return right[None, :] * self.axes[0, d] + up[:, None] * self.axes[1, d]

    def balls(self, points, radii):
        """Height of the nearest ball at each pixel (-inf: none), and its number."""
        place = self.project(points)
        column, row = ((place[:, d] - self.low[d]) / self.pixel - 0.5 for d in (0, 1))
        height = numpy.full(self.shape[0] * self.shape[1], -numpy.inf)
        owner = numpy.zeros(len(height), int)
        reach = int(numpy.ceil(radii.max() / self.pixel))
        for di in range(-reach, reach + 1):
            for dj in range(-reach, reach + 1):
                i, j = numpy.rint(row).astype(int) + di, numpy.rint(column).astype(int) + dj
                square = radii**2 - ((i - row)**2 + (j - column)**2) * self.pixel**2
                number = numpy.flatnonzero((square > 0) & (i >= 0) & (i < self.shape[0])
                                           & (j >= 0) & (j < self.shape[1]))
                z = place[number, 2] + numpy.sqrt(square[number])
                pixel = i[number] * self.shape[1] + j[number]
                order = numpy.argsort(z)  # of equal pixels the last one stays
                order = order[z[order] > height[pixel[order]]]
                height[pixel[order]], owner[pixel[order]] = z[order], number[order]
        return height.reshape(self.shape), owner.reshape(self.shape)

    def window(self, corners):
        """Rows and columns of pixels that points lie in."""
        place = self.project(corners)[:, [1, 0]]
        low = numpy.floor((place.min(axis=0) - self.low[::-1]) / self.pixel).astype(int) - 2
        high = numpy.ceil((place.max(axis=0) - self.low[::-1]) / self.pixel).astype(int) + 2
        return tuple(slice(max(l, 0), max(h, 0)) for l, h in zip(low, high))

    def boxes(self, boxes):
        """Height of the nearest box at each pixel (-inf: none) and its colour."""
        eye = self.axes[2]
        light = 0.72 + 0.28 * numpy.abs(eye) / numpy.abs(eye).max()
        height, colour = numpy.full(self.shape, -numpy.inf), numpy.zeros(self.shape + (3,), "f4")
        for low, high in boxes:
            window = self.window(self.corners(low, high))
            # where the rays along the eye leave the box and where they enter it
            ends = [numpy.stack([(corner[d] - self.rays(d, *window)) / eye[d] for d in range(3)],
                                axis=2) for corner in (low, high)]
            leaves, enters = numpy.maximum(*ends), numpy.minimum(*ends)
            z, face = leaves.min(axis=2), leaves.argmin(axis=2)
            seen = (z > enters.max(axis=2)) & (z > height[window])
            height[window][seen] = z[seen]
            # two faces at once: an edge
            ordered = numpy.sort(leaves, axis=2)
            edge = seen & (ordered[:, :, 1] - ordered[:, :, 0] < 3 * self.pixel)
            colour[window][seen] = (WALL * light[:, None])[face[seen]]
            colour[window][edge] = 0.25
        return height, colour

    def far_side(self, d):
        """Pixels that see the side of the domain across direction d that lies behind
        the water, and those at its outline."""
        eye = self.axes[2]
        if abs(eye[d]) < 1e-6:
            nothing = numpy.zeros(self.shape, bool)
            return nothing, nothing
        way = ((self.lower if eye[d] > 0 else self.upper)[d] - self.rays(d)) / eye[d]
        inside = numpy.full(self.shape, numpy.inf)
        for e in (e for e in range(3) if e != d):
            hit = self.rays(e) + way * eye[e]
            numpy.minimum(inside, hit - self.lower[e], out=inside)
            numpy.minimum(inside, self.upper[e] - hit, out=inside)
        return inside >= 0, abs(inside) < 0.75 * self.pixel

    def triangles(self, corners, attributes):
        """Height of the nearest triangle at each pixel (-inf: none) and the
        attributes [n, 3, k] there [rows, columns, k]."""
        place = self.project(corners)
        column, row = ((place[:, :, d] - self.low[d]) / self.pixel - 0.5 for d in (0, 1))
        first = numpy.stack([numpy.ceil(row.min(axis=1)), numpy.ceil(column.min(axis=1))], axis=1)
        size = numpy.stack([row.max(axis=1), column.max(axis=1)], axis=1) - first
        size = numpy.floor(size).max(axis=1).astype(int) + 1
        height = numpy.full(self.shape[0] * self.shape[1], -numpy.inf)
        result = numpy.zeros((len(height), attributes.shape[2]), "f4")
        low, edge = 0, 1
        while low < size.max(initial=0):
            group = numpy.flatnonzero((size > low) & (size <= edge))
            part = max(1, SAMPLES // edge**2)
            for start in range(0, len(group), part):
                n = group[start:start + part]
                self._fill(n, edge, first[n], row[n], column[n], place[n, :, 2], attributes,
                           height, result)
            low, edge = edge, 2 * edge
        return height.reshape(self.shape), result.reshape(self.shape + (-1,))

    def _fill(self, number, edge, first, row, column, z, attributes, height, result):
        """Puts triangles into the buffers whose boxes are at most edge pixels wide."""
        i = first[:, 0, None, None] + numpy.arange(edge)[None, :, None]
        j = first[:, 1, None, None] + numpy.arange(edge)[None, None, :]
        r, c = row[:, :, None, None], column[:, :, None, None]
        area = ((r[:, 1] - r[:, 0]) * (c[:, 2] - c[:, 0]) - (r[:, 2] - r[:, 0]) * (c[:, 1] - c[:, 0]))
        area = numpy.where(abs(area) < 1e-12, numpy.inf, area)
        one = ((i - r[:, 0]) * (c[:, 2] - c[:, 0]) - (r[:, 2] - r[:, 0]) * (j - c[:, 0])) / area
        two = ((r[:, 1] - r[:, 0]) * (j - c[:, 0]) - (i - r[:, 0]) * (c[:, 1] - c[:, 0])) / area
        share = numpy.stack([1 - one - two, one, two], axis=1)
        hit = ((share.min(axis=1) >= -1e-9) & (i >= 0) & (i < self.shape[0]) & (j >= 0)
               & (j < self.shape[1]) & numpy.isfinite(area))
        t, k, l = numpy.nonzero(hit)
        share = share[t, :, k, l]
        depth = numpy.einsum("nv,nv->n", share, z[t])
        pixel = (i[t, k, 0] * self.shape[1] + j[t, 0, l]).astype(int)
        order = numpy.argsort(depth)  # of equal pixels the last one stays
        order = order[depth[order] > height[pixel[order]]]
        pixel = pixel[order]
        height[pixel] = depth[order]
        result[pixel] = numpy.einsum("nv,nvk->nk", share[order], attributes[number[t[order]]])

    @staticmethod
    def shade(colours, normals):
        """Colours [n, 3] of a wet surface in the light; normals [n, 3] to the right,
        upwards and towards the eye, of any length."""
        n = normals * numpy.where(normals[:, 2:] < 0, -1, 1) / numpy.maximum(
            numpy.linalg.norm(normals, axis=1), 1e-12)[:, None]
        light = LIGHT / numpy.linalg.norm(LIGHT)
        half = light + (0, 0, 1)
        half /= numpy.linalg.norm(half)
        diffuse = 0.72 + 0.36 * numpy.clip(n @ light, 0, 1)
        gloss = GLOSS * numpy.clip(n @ half, 0, 1)**SHININESS
        shadow = (1 - diffuse)[:, None] * SHADOW
        return numpy.clip(colours * (1 - shadow) + gloss[:, None], 0, 1)

    def water_picture(self, skin, bodies, drops, colour_of, opacity=0.9,
                      light_borders=False):
        """Image [rows, columns, 3], first row at the bottom: a skin (corners, normals
        [n, 3, 3], values [n, 3], fluids [n]) and drops (centres [n, 3], radii, values,
        fluids [n]), and bodies of further fluids inside (corners, normals, fluids);
        colour_of turns values and fluids into colours [n, 3]. Through the water one sees a
        little of what is behind it; light borders are seen in the dark, too."""
        image = self.background.copy()
        wall = numpy.isfinite(self.walls)
        image[wall] = self.wall_colours[wall]
        corners, normals, values, fluids = skin
        fluids = numpy.broadcast_to(fluids[:, None], values.shape)
        water, found = self.triangles(corners, numpy.dstack([normals @ self.axes.T, values, fluids]))
        wet = numpy.isfinite(water) & (water > self.walls)
        fluid = numpy.where(wet, numpy.rint(found[:, :, 4]), -1).astype(int)
        shown = self.shade(colour_of(found[wet][:, 3], fluid[wet]), found[wet][:, :3])
        opacity = numpy.where(self.sunk, CLEAR, opacity)
        self.show_bodies(image, opacity, bodies, water, fluid, colour_of)
        image[wet] += opacity[wet][:, None] * (shown - image[wet])
        for border, colour in zip(self.borders(fluid), (BORDER, 1.0 if light_borders else BORDER)):
            image[border] = colour
        centres, radii, at_drops, fluids = drops
        nearest = numpy.maximum(self.walls, numpy.where(wet, water, -numpy.inf))
        if len(centres):
            ball, owner = self.balls(centres, radii)
            dropped = numpy.isfinite(ball) & (ball > nearest)
            number = owner[dropped]
            row, column = numpy.nonzero(dropped)
            there = numpy.stack([self.low[0] + (column + 0.5) * self.pixel,
                                 self.low[1] + (row + 0.5) * self.pixel, ball[dropped]], axis=1)
            image[dropped] = self.shade(colour_of(at_drops[number], fluids[number]),
                                        there - self.project(centres[number]))
            nearest[dropped] = ball[dropped]
        self.finish(image, nearest)
        return self.averaged(image)

    def finish(self, image, nearest):
        """What stands before the water; the heights of what is nearest so far."""

    def show_bodies(self, image, opacity, bodies, water, fluid, colour_of):
        """Fluids inside the water, seen through those with smaller numbers, whose opacity
        is less there."""
        corners, normals, numbers = bodies
        nearest = numpy.where(fluid >= 0, self.walls, numpy.inf)
        for number in numpy.unique(numbers):
            own = numbers == number
            inside, found = self.triangles(corners[own], normals[own] @ self.axes.T)
            seen = (inside > nearest) & (inside < water) & (fluid < number)
            count = int(seen.sum())
            colours = colour_of(numpy.zeros(count), numpy.full(count, number))
            image[seen] = self.shade(colours, found[seen])
            opacity[seen] = CLEAR
            nearest[seen] = inside[seen]

    def borders(self, fluid):
        """Pixels [rows, columns] beside fluids of greater and of smaller numbers; -1: none."""
        others = [shifted(fluid, *way) for way in ((0, 1), (0, -1), (1, 0), (-1, 0))]
        return ((fluid >= 0) & numpy.any([o > fluid for o in others], axis=0),
                numpy.any([(o >= 0) & (o < fluid) for o in others], axis=0))

    def averaged(self, image):
        """Of the fine pixels."""
        rows, columns = self.shape[0] // FINER, self.shape[1] // FINER
        return image.reshape(rows, FINER, columns, FINER, 3).mean(axis=(1, 3))

    def smooth(self, height, width, passes):
        """Mean over neighbours that belong to the same surface: those within a
        width [m] of it."""
        for _ in range(passes):
            total, weight = numpy.zeros(self.shape), numpy.zeros(self.shape)
            for di in (-2, 0, 2):
                for dj in (-2, 0, 2):
                    other = shifted(height, di, dj)
                    near = abs(numpy.where(numpy.isfinite(other), other, 1e9) - height) < width
                    total[near] += other[near]
                    weight += near
            height = numpy.where(weight > 0, total / numpy.maximum(weight, 1), height)
        return height

    def lit(self, height):
        """Brightness of the surface, about one."""
        filled = numpy.where(numpy.isfinite(height), height, 0.0)
        slope = []
        for di, dj in ((0, 1), (1, 0)):
            ahead, behind = shifted(filled, di, dj) - filled, filled - shifted(filled, -di, -dj)
            slope.append(numpy.where(abs(ahead) < abs(behind), ahead, behind) / self.pixel)
        normal = numpy.stack([-slope[0], -slope[1], numpy.ones(self.shape)], axis=2)
        normal /= numpy.linalg.norm(normal, axis=2)[:, :, None]
        light = LIGHT / numpy.linalg.norm(LIGHT)
        return 0.62 + 0.45 * numpy.clip(normal @ light, 0, 1)

    def picture(self, points, radii, colours, opacity=0.75):
        """Image [rows, columns, 3], first row at the bottom: balls [n, 3] with
        radii [n] [m] and colours [n, 3], and the boxes with an opacity."""
        image = self.background.copy()
        water, owner = self.balls(points, radii)
        spacing = float(numpy.median(radii))
        water = self.smooth(water, 2.5 * spacing, 6)
        wet, walled = numpy.isfinite(water), numpy.isfinite(self.walls)
        shown = numpy.clip(colours[owner] * self.lit(water)[:, :, None], 0, 1)
        for layer in (False, True):  # water behind the walls, walls, water before them
            part = wet & ((water > self.walls) == layer)
            image[part] = shown[part]
            if not layer:
                image[walled] += opacity * (self.wall_colours[walled] - image[walled])
        return self.averaged(image)

    def draw(self, axes, image, ticks):
        """The image without its white margins, and ticks {direction: places}
        along the edges of the domain next to the eye."""
        axes.imshow(image, origin="lower", extent=self.extent, interpolation="antialiased")
        used = numpy.flatnonzero((image < 0.999).any(axis=(1, 2)))
        axes.set_ylim(self.low[1] + FINER * self.pixel * numpy.array([used[0], used[-1] + 1]))
        near = numpy.where(self.axes[2] > 0, self.upper, self.lower)
        away = 0.05 * numpy.ptp(self.extent[:2])
        for d, places in ticks.items():
            middle = numpy.array([near[0], near[1], self.lower[2]])
            outwards = numpy.eye(3)[1 - d] if d < 2 else numpy.zeros(3)
            outwards *= 1 if self.axes[2][1 - d] > 0 else -1
            if d == 2:  # at the edge on the left
                edges = [(x, y) for x in (self.lower[0], self.upper[0])
                         for y in (self.lower[1], self.upper[1])]
                middle[:2] = min(edges, key=lambda e: self.axes[0][:2] @ e)
            middle[d] = 0.5 * (self.lower[d] + self.upper[d])
            side = self.project(outwards)[:2] if d < 2 else numpy.array([-1.0, 0.0])
            side /= numpy.linalg.norm(side)
            anchor = {"ha": "center" if abs(side[0]) < 0.5 else "right" if side[0] < 0 else "left",
                      "va": "center" if abs(side[1]) < 0.7 else "top" if side[1] < 0 else "bottom"}
            for place in places:
                at = middle.copy()
                at[d] = place
                p = self.project(at)[:2]
                axes.plot(*zip(p, p + 0.25 * away * side), color="0.35", lw=0.6, clip_on=False)
                axes.annotate("%.3g" % place, p + 0.25 * away * side, 4 * side, fontsize=8,
                              textcoords="offset points", annotation_clip=False, **anchor)
            axes.annotate("%s [m]" % "xyz"[d], self.project(middle)[:2] + 0.25 * away * side,
                          28 * side, fontsize=9, textcoords="offset points",
                          annotation_clip=False, **anchor)
        axes.set_axis_off()

    def draw_rim(self, axes, lower, upper, is_wall=lambda places: numpy.ones(len(places), bool)):
        """The edges of a box next to the eye, which hide nothing, where there is a wall."""
        eye = self.axes[2]
        near = [(upper if eye[d] > 0 else lower)[d] for d in range(3)]
        for d in range(3):
            for e, f in ((0, 1), (1, 0), (1, 1)):
                ends = numpy.array([near, near], float)
                others = [o for o in range(3) if o != d]
                for other, is_near in zip(others, (e, f)):
                    if not is_near:
                        ends[:, other] = lower[other] + upper[other] - near[other]
                ends[:, d] = lower[d], upper[d]
                places = ends[0] + numpy.linspace(0, 1, EDGE_PLACES)[:, None] * (ends[1] - ends[0])
                line = numpy.where(is_wall(places)[:, None], self.project(places)[:, :2], numpy.nan)
                axes.plot(*line.T, color="0.45", lw=0.5, clip_on=False)
