# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reader for the output directory of a run (numpy only, no VTK).

    from seiche_output import Run
    run = Run("results/dam_break_2d")
    run.statistics["front surge [m]"]      array, one value a step
    run.summary["errors"]                  dict
    run.parameter("Grid/Upper corner")     text, as used by the run
    for time, file in run.frames("points"):
        frame = read_frame(file)           dict of arrays; "points": [n, 3]
"""

import base64
import csv
import json
import os
import re
import xml.etree.ElementTree as ElementTree
import zlib

import numpy

from seiche_walls import Walls

TYPES = {
    "Float32": "f4",
    "Float64": "f8",
    "Int8": "i1",
    "UInt8": "u1",
    "Int16": "i2",
    "UInt16": "u2",
    "Int32": "i4",
    "UInt32": "u4",
    "Int64": "i8",
    "UInt64": "u8",
}


class Run:
    """One output directory; what is missing in it is empty here."""

    def __init__(self, directory):
        self.directory = directory
        self.statistics = self._read_statistics()
        self.summary = self._read_summary()
        self.parameters = self._read_parameters()
        self._walls_of = None

    def _path(self, name):
        return os.path.join(self.directory, name)

    def _read_statistics(self):
        """Columns of statistics.csv; a cut last line is left out."""
        if not os.path.isfile(self._path("statistics.csv")):
            return {}
        with open(self._path("statistics.csv"), newline="") as file:
            rows = list(csv.reader(file))
        names = [name.strip() for name in rows[0]] if rows else []
        rows = [row for row in rows[1:] if len(row) == len(names)]

        def number(text):
            try:
                return float(text)
            except ValueError:
                return numpy.nan

        values = numpy.array([[number(text) for text in row] for row in rows])
        values = values.reshape(len(rows), len(names))
        return {name: values[:, i] for i, name in enumerate(names)}

    def _read_summary(self):
        if not os.path.isfile(self._path("summary.json")):
            return {}
        with open(self._path("summary.json")) as file:
            return json.load(file)

    def _read_parameters(self):
        """Entries of parameters.prm by path, such as "Grid/Lower corner"."""
        if not os.path.isfile(self._path("parameters.prm")):
            return {}
        entries, sections, kept = {}, [], ""
        with open(self._path("parameters.prm")) as file:
            for line in file:
                line = kept + line.split("#")[0].strip()
                kept = ""
                if line.endswith("\\"):
                    kept = line[:-1]
                elif line.startswith("subsection "):
                    sections.append(line[len("subsection "):].strip())
                elif line == "end":
                    sections.pop()
                elif line.startswith("set ") and "=" in line:
                    name, value = line[len("set "):].split("=", 1)
                    name = " ".join(name.split())
                    entries["/".join(sections + [name])] = value.strip()
        return entries

    def parameter(self, path, default=""):
        return self.parameters.get(path, default)

    def numbers(self, path):
        """Numbers of an entry such as "0, 0.6", or an empty list."""
        try:
            return [float(text) for text in self.parameter(path).split(",")]
        except ValueError:
            return []

    def instances(self, kind):
        """Names of the subsections "<kind> NAME"."""
        names = []
        for path in self.parameters:
            section = path.split("/")[0]
            if section.startswith(kind + " ") and "/" in path:
                name = section[len(kind) + 1:]
                if name not in names:
                    names.append(name)
        return names

    def fluids(self):
        """{number: name} of the materials that bodies have, with the numbers of the
        points' field "material". The Fluid, 0, has no name of its own: it has that of its
        body, if that is the only one."""
        bodies = {}
        for body in self.instances("Fluid body"):
            bodies.setdefault(self.parameter("Fluid body %s/Material" % body), []).append(body)
        unnamed = bodies.get("", [])
        names = {0: unnamed[0] if len(unnamed) == 1 else "fluid"} if unnamed else {}
        for number, name in enumerate(self.instances("Material"), 1):
            if name in bodies:
                names[number] = name
        return names

    def frames(self, kind):
        """[(time in s, file)] of kind "points", "grid", "surface" or "walls", from the
        PVD file."""
        if not os.path.isfile(self._path(kind + ".pvd")):
            return []
        root = ElementTree.parse(self._path(kind + ".pvd")).getroot()
        frames = [
            (float(entry.get("timestep")), self._path(entry.get("file")))
            for entry in root.iter("DataSet")
        ]
        return sorted(frame for frame in frames if os.path.isfile(frame[1]))

    def frame_at(self, kind, time):
        """File of the frame of this kind at a time [s] of another one, or None."""
        for other, path in self.frames(kind):
            if abs(other - time) <= 1e-9 * max(1.0, abs(time)):
                return path
        return None

    def walls_at(self, time):
        """The Walls of a time [s]: those of the last frame until then; without such
        frames the entries of the start, or None."""
        past = [frame for frame in self.frames("walls") if frame[0] <= time + 1e-9 * max(1.0, abs(time))]
        if past:
            if self._walls_of != past[-1]:  # one object as long as nothing moves
                self._walls_of = past[-1]
                self._walls = Walls.of_frame(read_frame(past[-1][1]), self, past[-1][0])
            return self._walls
        lower, upper = self.numbers("Grid/Lower corner"), self.numbers("Grid/Upper corner")
        if not lower or len(lower) != len(upper):
            return None
        names = ["Obstacle %s/%%s corner" % name for name in self.instances("Obstacle")]
        corners = [[self.numbers(n % "Lower"), self.numbers(n % "Upper")] for n in names]
        return Walls.without_solids(lower, upper, corners, self.sides("open", "periodic"))

    def sides(self, *conditions):
        """Sides of the box with one of these conditions, as (direction, 0 lower or 1
        upper)."""
        pairs = [("Left", "Right"), ("Front", "Back"), ("Bottom", "Top")]
        if self.dim == 2:
            del pairs[1]
        return frozenset((d, side) for d, pair in enumerate(pairs) for side in (0, 1)
                         if self.parameter("Walls/" + pair[side]) in conditions)

    def periodic(self):
        """Directions whose sides are periodic."""
        return sorted(d for d, side in self.sides("periodic") if side == 0)

    @property
    def dim(self):
        return int(self.parameter("Dimension", "2") or 2)


def field(frame, name):
    """A field by the first word of its name (units may follow), or None."""
    for key, values in frame.items():
        if re.split(r"[ \[(]", key)[0] == name:
            return values
    return None


def read_frame(path):
    """Arrays of a .vtu file, or of all pieces of a .pvtu file, by name.

    "points" holds the positions [n, 3], "cells" the numbers of the corners of each
    cell in VTK's order; fields carry the names of the file.
    """
    root = ElementTree.parse(path).getroot()
    if root.get("type", "").startswith("P"):
        folder = os.path.dirname(path)
        pieces = [
            read_frame(os.path.join(folder, piece.get("Source")))
            for piece in root.iter("Piece")
        ]
        pieces = [piece for piece in pieces if len(piece["points"])] or pieces[:1]
        first = 0
        for piece in pieces:
            piece["cells"] = piece["cells"] + first
            first += len(piece["points"])
        return {
            name: numpy.concatenate([piece[name] for piece in pieces])
            for name in pieces[0]
        }

    order = "<" if root.get("byte_order", "LittleEndian") == "LittleEndian" else ">"
    header = order + TYPES[root.get("header_type", "UInt32")]
    compressed = root.get("compressor") is not None
    result = {"points": numpy.zeros((0, 3)), "cells": numpy.zeros((0, 1), int)}
    for piece in root.iter("Piece"):
        for group in ("Points", "PointData", "Cells"):
            element = piece.find(group)
            for array in element.iter("DataArray") if element is not None else ():
                if group == "Cells" and array.get("Name") != "connectivity":
                    continue
                values = _decode(array, order, header, compressed)
                if group == "Cells":
                    # the writer uses one kind of cell in a file
                    n_cells = max(1, int(piece.get("NumberOfCells")))
                    result["cells"] = values.astype(int).reshape(n_cells, -1)
                    continue
                components = int(array.get("NumberOfComponents", "1"))
                if components > 1:
                    values = values.reshape(-1, components)
                name = "points" if group == "Points" else array.get("Name")
                result[name] = values
    return result


def _decode(array, order, header, compressed):
    """Values of a DataArray element: ascii, base64, or base64 of zlib blocks."""
    kind = numpy.dtype(order + TYPES[array.get("type")])
    text = "".join((array.text or "").split()) if array.get("format") != "ascii" else ""
    if array.get("format") == "ascii":
        return numpy.array((array.text or "").split(), dtype=float)
    if not text:
        return numpy.zeros(0, kind)
    word = numpy.dtype(header).itemsize
    if not compressed:
        return numpy.frombuffer(base64.b64decode(text)[word:], kind)

    # Header: number of blocks, their size, size of the last, compressed sizes.
    first = base64.b64decode(text[: 4 * ((word + 2) // 3)])
    blocks = int(numpy.frombuffer(first[:word], header)[0])
    length = 4 * ((word * (3 + blocks) + 2) // 3)
    sizes = numpy.frombuffer(base64.b64decode(text[:length]), header)[3:]
    data, at, parts = base64.b64decode(text[length:]), 0, []
    for size in sizes[:blocks]:
        parts.append(zlib.decompress(data[at : at + int(size)]))
        at += int(size)
    return numpy.frombuffer(b"".join(parts), kind)
