# SPDX-License-Identifier: LGPL-2.1-or-later
"""Oblique views of water in three dimensions, with numpy alone: balls in a
depth buffer, smoothed to a surface and lit, boxes that hide what is behind them."""

import numpy

FINER = 2  # pixels are averaged over squares of so many
LIGHT = numpy.array([-0.45, 0.55, 0.70])  # right, up, towards the eye
GROUND, WALL = numpy.array([0.94, 0.92, 0.88]), numpy.array([0.62, 0.60, 0.58])


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
        self.background = numpy.ones(self.shape + (3,))
        ground, outline = self.ground()
        self.background[ground], self.background[outline] = GROUND, 0.5
        self.walls, self.wall_colours = self.boxes(boxes)

    @staticmethod
    def corners(lower, upper):
        return numpy.array([[(lower, upper)[i >> d & 1][d] for d in range(3)] for i in range(8)])

    def project(self, points):
        """To the right, upwards, towards the eye [m]."""
        return numpy.asarray(points) @ self.axes.T

    def rays(self):
        """Points of the picture's plane below the pixels [rows, columns, 3]."""
        right = self.low[0] + (numpy.arange(self.shape[1]) + 0.5) * self.pixel
        up = self.low[1] + (numpy.arange(self.shape[0]) + 0.5) * self.pixel
        return right[None, :, None] * self.axes[0] + up[:, None, None] * self.axes[1]

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

    def boxes(self, boxes):
        """Height of the nearest box at each pixel (-inf: none) and its colour."""
        plane, eye = self.rays(), self.axes[2]
        height, colour = numpy.full(self.shape, -numpy.inf), numpy.zeros(self.shape + (3,))
        for low, high in boxes:
            # where the ray plane + z eye leaves the box towards the eye
            ends = [(numpy.array(c) - plane) / eye for c in (low, high)]
            leaves, enters = numpy.maximum(*ends), numpy.minimum(*ends)
            z, face = leaves.min(axis=2), leaves.argmin(axis=2)
            seen = (z > enters.max(axis=2)) & (z > height)
            height[seen] = z[seen]
            light = 0.72 + 0.28 * numpy.abs(eye) @ numpy.eye(3) / numpy.abs(eye).max()
            colour[seen] = (WALL * light[:, None])[face[seen]]
            # two faces at once: an edge
            spare = numpy.sort(leaves, axis=2)
            edge = seen & (spare[:, :, 1] - spare[:, :, 0] < 3 * self.pixel)
            colour[edge] = 0.25
        return height, colour

    def ground(self):
        """Pixels that see the bottom of the domain, and those at its outline."""
        plane, eye = self.rays(), self.axes[2]
        hit = plane + ((self.lower[2] - plane[:, :, 2]) / eye[2])[:, :, None] * eye
        inside = numpy.minimum(hit - self.lower, self.upper - hit)[:, :, :2].min(axis=2)
        return inside >= 0, abs(inside) < 1.5 * self.pixel

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
        rows, columns = self.shape[0] // FINER, self.shape[1] // FINER
        return image.reshape(rows, FINER, columns, FINER, 3).mean(axis=(1, 3))

    def draw(self, axes, image, ticks):
        """The image without its white margins, and ticks {direction: places}
        along the edges of the ground next to the eye."""
        axes.imshow(image, origin="lower", extent=self.extent, interpolation="antialiased")
        used = numpy.flatnonzero((image < 0.999).any(axis=(1, 2)))
        axes.set_ylim(self.low[1] + FINER * self.pixel * numpy.array([used[0], used[-1] + 1]))
        near = numpy.where(self.axes[2] > 0, self.upper, self.lower)
        away = 0.05 * numpy.ptp(self.extent[:2])
        for d, places in ticks.items():
            middle = numpy.array([near[0], near[1], self.lower[2]])
            middle[d] = 0.5 * (self.lower[d] + self.upper[d])
            outwards = numpy.eye(3)[1 - d] * (1 if self.axes[2][1 - d] > 0 else -1)
            side = self.project(outwards)[:2]
            side /= numpy.linalg.norm(side)
            for place in places:
                at = middle.copy()
                at[d] = place
                p = self.project(at)[:2]
                axes.plot(*zip(p, p + 0.25 * away * side), color="0.35", lw=0.6, clip_on=False)
                axes.text(*(p + 0.75 * away * side), "%g" % place, fontsize=7, ha="center",
                          va="center")
            axes.text(*(self.project(middle)[:2] + 1.7 * away * side), "%s [m]" % "xyz"[d],
                      fontsize=8, ha="center", va="center")
        axes.set_axis_off()
