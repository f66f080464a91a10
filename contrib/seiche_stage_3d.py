# SPDX-License-Identifier: LGPL-2.1-or-later
"""Water, walls, obstacles and solids of a run in three dimensions on matplotlib's axes."""

import numpy
from matplotlib.ticker import MaxNLocator

from seiche_scenery import Scenery, room_of
from seiche_scenery_view import SceneryView
from seiche_stage import BALL, THICKNESS, Stage
from seiche_views import View

VIEW = (-0.8, -1.6, 1.0)  # direction to the eye
TICK = 45  # pixels along an edge from label to label at least


class Stage3D(Stage):
    def __init__(self, run, frames, name, eye=None, width=1000):
        super().__init__(run, frames, name)
        if eye is None:  # walls that move stand behind the water
            eye = numpy.array(VIEW)
            for d, side in self.moving:
                if d < 2:
                    eye[d] = abs(eye[d]) * (1 if side == 0 else -1)
        self.eye, self.width, self.still = eye, width, None
        self.low, self.high = room_of(self.all_walls, *self.box)
        # air above the highest splash says nothing
        top = self.reached[1][2] + 0.1 * (self.reached[1][2] - self.reached[0][2])
        tops = [high[2] for _, high in run.walls_at(0).obstacles]
        tops += [walls.solids[~walls.shells, :, 2].max(initial=-numpy.inf) for walls in self.all_walls]
        top = max([top] + tops)
        self.high[2] = min(self.high[2], top)
        self.thickness = THICKNESS * (self.high - self.low).max() if self.moving else 0.0
        small = self.make_view(run.walls_at(0), 100)
        self.ratio = small.shape[0] / small.shape[1]

    def view(self, walls):
        """The same as long as no wall moves."""
        if self.still is None or self.still[0] is not walls or self.still[1] != self.width:
            self.still = walls, self.width, self.make_view(walls, self.width)
        return self.still[2]

    def make_view(self, walls, width):
        cut = [(low, numpy.minimum(high, self.high)) for low, high in
               list(walls.obstacles) + self.pistons(walls, self.thickness)]
        low, high = self.low.copy(), self.high.copy()
        for d, side in self.moving:
            (high if side else low)[d] += (2 * side - 1) * self.thickness
        if not len(walls.solids):
            return View(low, high, self.eye, width, cut)
        return SceneryView(Scenery(walls, self.low, self.high, self.eye), low, high, self.eye, width, cut)

    def skin(self, frame):
        """Corners and normals [n, 3, 3], values [n, 3] and numbers of fluids [n]."""
        skin = numpy.dstack(frame.water.skin(frame.walls, self.field_of(frame)))
        if len(frame.walls.solids):
            wetted = numpy.dstack(frame.water.on_solids(frame.walls, self.field_of(frame)))
            # those behind the water would mix with the solids' own surface
            skin = numpy.concatenate([skin, wetted[wetted[:, :, 3:6].sum(axis=1) @ self.eye > 0]])
        parts = frame.fluids.divided(skin)
        numbers = numpy.concatenate([numpy.full(len(part), number) for number, part in parts])
        skin = numpy.concatenate([part for _, part in parts])
        return skin[:, :, :3], skin[:, :, 3:6], skin[:, :, 6], numbers

    def bodies(self, frame):
        """Corners and normals [n, 3, 3] of fluids inside the water, and their numbers [n];
        none where a field has the colours."""
        if frame.known or not frame.fluids.are_several:
            return numpy.zeros((0, 3, 3)), numpy.zeros((0, 3, 3)), numpy.zeros(0, int)
        return frame.fluids.bodies(frame.water)

    def image(self, frame):
        """The View and its picture [rows, columns, 3]."""
        view = self.view(frame.walls)
        centres, radii, values, fluids = self.drops(frame)
        return view, view.water_picture(
            self.skin(frame), self.bodies(frame), (centres, BALL * radii, values, fluids),
            lambda v, n: self.colours(frame, v, n), opacity=0.92 if frame.known else 0.85,
            light_borders=frame.known)

    def prepare(self, axes):
        axes.set_axis_off()

    def draw(self, axes, frame):
        view, image = self.image(frame)
        ticks = {}
        for d in range(3):
            length = (self.high[d] - self.low[d]) * numpy.linalg.norm(view.axes[:2, d])
            number = min(5 if d < 2 else 3, int(self.width / TICK * length / numpy.ptp(view.extent[:2])))
            places = MaxNLocator(number).tick_values(self.low[d], self.high[d]) if number > 1 else []
            slack = 1e-6 * (self.high[d] - self.low[d])
            ticks[d] = [p for p in places if self.low[d] - slack <= p <= self.high[d] + slack
                        and (d < 2 or p > self.low[d] + slack)] or [self.high[d]]
        view.draw(axes, image, ticks)
        view.draw_rim(axes, view.lower, view.upper, lambda places: frame.walls.distance(places) > 0)
        axes.set_title("t = %.3f s" % frame.time, fontsize=10)
