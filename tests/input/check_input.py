#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run `seiche` on broken files and command lines.

    check_input.py PROGRAM GROUP [--verbose]

Every case must end with the exit code of its kind, one message on standard
error that holds the expected texts (file:line and the entry among them),
nothing on standard output, and must leave the folder as it was. The group "numbers"
compares what a verdict may name with what a run has, "shipped_prm" and "shipped_tests" validate every
parameter file in that folder instead.
"""

import argparse
import fcntl
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from scenes import box_scene

SCENE = box_scene()

INPUT, FILES = 2, 4


class Case:
    """A scene file in which `old` is replaced by `new` (or a whole text)."""

    def __init__(self, name, old=None, new="", expect=(), text=None,
                 arguments=None, code=INPUT, line=True, others=None,
                 validate=True, prepare=None, full_disk=False,
                 silent=False, unexpected=()):
        self.name, self.code, self.expect = name, code, list(expect)
        self.text = SCENE if text is None else text
        if old is not None:
            assert self.text.count(old) == 1, f"{name}: {old!r} is not unique"
            self.text = self.text.replace(old, new)
        if line is True and old is not None and new:
            prefix = os.path.commonprefix([
                self.text, SCENE if text is None else text])
            line = prefix.count("\n") + 1
        if line is not True and line:
            self.expect.append(f"scene.prm:{line}: ")
        self.arguments = ["scene.prm"] if arguments is None else arguments
        self.validate, self.others = validate, others or {}
        self.prepare, self.full_disk = prepare, full_disk
        self.silent, self.unexpected = silent, unexpected


def added(text):
    """Lines appended to the scene; the place of the first is expected."""
    return {"text": SCENE + text}


LAST = SCENE.count("\n")
SOLID = ("subsection Solid ball\n  set Shape = ball\n  set Centre = 0.8, 0.25\n"
         "  set Radius = 0.1\nend\n")
FREE_SOLID = SOLID.replace("end\n", "  set Free = x\n  set Inertia = 10\nend\n")
MOORING = ("subsection Mooring bow\n  set Solid = ball\n  set Fairlead = 0.7, 0.25\n"
           "  set Weight = 10\n  set Axial stiffness = 1e5\nend\n")
# to go before an "end"
PERIODIC = "subsection Walls\n  set Left = periodic\n  set Right = periodic\n"

SYNTAX = [
    Case("missing end", **added("subsection Walls\n"), line=LAST + 1,
         expect=['"Walls"', '"end"']),
    Case("too many ends", **added("end\n"), line=LAST + 1, expect=['"end"']),
    Case("text after end", **added("subsection Walls\nend now\n"),
         line=LAST + 2, expect=['"now"']),
    Case("not a line", "set Density ", "put Density ", line=11,
         expect=['"put Density', '"set NAME = VALUE"']),
    Case("no equals sign", "Cell size    =", "Cell size   ", line=5,
         expect=["set Cell size", '"set NAME = VALUE"']),
    Case("no name before the equals sign", "set Step     =", "set =", line=21),
    Case("entry set twice", "  set Step     = 0.01",
         "  set Step     = 0.01\n  set Step     = 0.02", line=22,
         expect=['"Step"', "twice", "scene.prm:21"]),
    Case("subsection twice, entry twice",
         **added("subsection Fluid\n  set Density = 1\nend\n"),
         line=LAST + 2, expect=['"Density"', "twice", "scene.prm:11"]),
    Case("subsection without name", **added("subsection\nend\n"),
         line=LAST + 1, expect=["needs a name"]),
    Case("slash in a name", "Fluid body column", "Fluid body a/b", line=15,
         expect=["a/b"]),
    Case("empty file", text="", expect=["scene.prm", "empty"]),
    Case("comments only", text="# a scene\n\n", line=2),
    Case("binary file", text="set Dimension = 2\n\0\1\2",
         expect=["scene.prm", "not a text file"]),
    Case("includes itself", **added("include scene.prm\n"), line=LAST + 1,
         expect=["includes itself"]),
    Case("two files include each other", **added("include other.inc\n"),
         others={"other.inc": "# first line\ninclude scene.prm\n"},
         line=None, expect=["other.inc:2: ", "includes itself"]),
    Case("include of a missing file", **added("include none.inc\n"),
         line=LAST + 1, expect=["none.inc", "no such file"]),
    Case("include of a folder", **added("include .\n"), line=LAST + 1,
         expect=["folder"]),
    Case("problem in an included file", **added("include other.inc\n"),
         others={"other.inc": "subsection Walls\n  set Lfet = slip\nend\n"},
         line=None, expect=["other.inc:2: ", '"Lfet"', '"Left"']),
    Case("folder", arguments=["."], expect=["folder"]),
    Case("missing file", arguments=["none.prm"],
         expect=["none.prm", "no such file"]),
    Case("not a regular file", arguments=["/dev/zero"],
         expect=["regular file"]),
    Case("include of what cannot be read", **added("include /proc/self/mem\n"),
         line=LAST + 1, expect=["cannot be read"]),
    Case("include of a device", **added("include /dev/zero\n"), line=LAST + 1,
         expect=["regular file"]),
    Case("deep nesting", text=SCENE + "subsection a\n" * 3000, line=None,
         expect=[f"scene.prm:{LAST + 9}: ", "more than 8 subsections"]),
    Case("control characters", **added("subsection \33[31m\7\nend\n"),
         line=LAST + 1, expect=['"?[31m?"'], unexpected=["\33", "\7"]),
    Case("a megabyte on a line", **added("subsection " + "a" * 1000000 + "\nend\n"),
         line=LAST + 1, expect=["aaa ..."], unexpected=["a" * 5000]),
]

NAMES = [
    Case("unknown entry", "set Density ", "set Densty ",
         expect=['"Densty" in "Fluid"', '"Density"']),
    Case("unknown entry far from all", "set Density ", "set Colour ",
         expect=['"Colour" in "Fluid"', '"Dynamic viscosity"']),
    Case("entry of another subsection", "set Dimension = 2",
         "set Dimension = 2\nset Density = 1", line=2,
         expect=['"Density"', "subsection Fluid"]),
    Case("unknown subsection", "subsection Body force",
         "subsection Body forces", expect=['"Body forces"', '"Body force"']),
    Case("misspelt kind", "Fluid body column", "Fluid bdy column",
         expect=['"Fluid bdy column"', '"Fluid body column"']),
    Case("kind without a name", "Fluid body column", "Fluid body",
         expect=['"Fluid body"', "NAME"]),
    Case("lower case", "set Cell size ", "set cell size ",
         expect=['"cell size"', '"Cell size"']),
    Case("3D wall in 2D", **added("subsection Walls\n  set Front = slip\nend\n"),
         line=LAST + 2, expect=['"Front"']),
    Case("probe entry unknown",
         **added("subsection Probe p\n  set Positon = 0.1, 0.1\nend\n"),
         line=LAST + 2, expect=['"Positon"', '"Position"']),
    Case("unknown entry by --set",
         arguments=["scene.prm", "--set", "Fluid/Viscosity = 1"],
         expect=['--set "Fluid/Viscosity = 1"', '"Dynamic viscosity"']),
    Case("unknown subsection by --set",
         arguments=["scene.prm", "--set", "Fluids/Density = 1"],
         expect=['--set "Fluids/Density = 1"', '"Fluids"', '"Fluid"']),
    Case("name with a comma by --set",
         arguments=["scene.prm", "--set", "Gauge a,b/Position = 0.1, 0"],
         expect=['--set "Gauge a,b/Position', '"Gauge a,b" has one of']),
    Case("name with a dot by --set",
         arguments=["scene.prm", "--set", "Gauge a.b/Position = 0.1, 0"],
         expect=['--set "Gauge a.b/Position', '"Gauge a.b" has one of']),
    Case("kind that there is not",
         **added("subsection Floating body box\n  set Mass = 3\nend\n"),
         line=LAST + 1, expect=['"Floating body box"', "Subsections there"],
         unexpected=["did you mean"]),
    Case("another kind that there is not",
         **added("subsection Wave gauge w\n  set Position = 0.1, 0\nend\n"),
         line=LAST + 1, expect=['"Wave gauge w"', "Subsections there"],
         unexpected=["did you mean"]),
    Case("shape of an obstacle",
         **added("subsection Obstacle o\n  set Lower corner = 0.6, 0\n"
                 "  set Upper corner = 0.7, 0.1\n  set Shape = cylinder\nend\n"),
         line=LAST + 4, expect=['"Shape" in "Obstacle o"', '"Condition"'],
         unexpected=["belongs"]),
]

VALUES = [
    Case("no dimension", "set Dimension = 2\n", "",
         expect=['"Dimension"', "mandatory", "scene.prm:"]),
    Case("wrong dimension", "set Dimension = 2", "set Dimension = 1",
         expect=['"Dimension"', "2 or 3"]),
    Case("dimension of another scene", "set Dimension = 2",
         "set Dimension = 3", line=3,
         expect=['"Lower corner" in "Grid"']),
    Case("mandatory entry missing", "  set Density           = 1000\n", "",
         line=10, expect=['"Density" in "Fluid"', "mandatory", "kg/m^3"]),
    Case("mandatory subsection missing",
         "subsection Time\n  set End time = 0.02\n  set Step     = 0.01\nend\n",
         "", expect=['"End time" in "Time"', '"Step" in "Time"', "scene.prm:"]),
    Case("mandatory entry empty", "= 1000", "=", line=11,
         expect=['"Density" in "Fluid"']),
    Case("negative density", "= 1000", "= -1000",
         expect=['"Density" in "Fluid" = -1000', "kg/m^3"]),
    Case("density zero", "= 1000", "= 0",
         expect=['"Density" in "Fluid" = 0']),
    Case("not a number", "= 1000", "= heavy",
         expect=['"Density" in "Fluid" = heavy', "a number"]),
    Case("number with unit", "= 1000", "= 1000 kg/m^3",
         expect=['"Density" in "Fluid"']),
    Case("decimal comma", "= 0.001", "= 0,001",
         expect=['"Dynamic viscosity" in "Fluid" = 0,001']),
    Case("nan", "= 1000", "= nan", expect=['"Density" in "Fluid" = nan']),
    Case("too large for a double", "= 1000", "= 1e999",
         expect=['"Density" in "Fluid" = 1e999']),
    Case("negative viscosity", "= 0.001", "= -0.001",
         expect=['"Dynamic viscosity" in "Fluid"']),
    Case("word for the bulk modulus", "= infinite", "= unlimited",
         expect=['"Bulk modulus" in "Fluid" = unlimited', '"infinite"']),
    Case("negative bulk modulus", "= infinite", "= -5",
         expect=['"Bulk modulus" in "Fluid" = -5']),
    Case("solid with the irreducible form",
         **added(SOLID + "subsection Formulation\n  set Name = displacement\nend\n"),
         line=None, expect=['"Shape" in "Solid ball"', "displacement-pressure"]),
    Case("solid and points as quadrature",
         **added(SOLID + "subsection Quadrature\n  set Rule = material points\nend\n"),
         line=None, expect=['"Shape" in "Solid ball"', "cut cells"]),
    Case("solid with the name of a side", **added(SOLID.replace("Solid ball", "Solid left")),
         line=None, expect=['"Shape" in "Solid left"', "rename"]),
    Case("mooring of a solid that stays", **added(SOLID + MOORING),
         line=None, expect=['"Solid" in "Mooring bow"', "no solid is moved by the fluid"]),
    Case("mooring of no solid", **added(FREE_SOLID + MOORING.replace("= ball", "= bal")),
         line=None, expect=['"Solid" in "Mooring bow"', 'did you mean "ball"']),
    Case("mooring without length", **added(FREE_SOLID + MOORING),
         line=None, expect=['"Length" in "Mooring bow"', "greater than zero"]),
    Case("mooring without anchor",
         **added(FREE_SOLID + MOORING.replace("end\n", "  set Length = 1\nend\n")),
         line=None, expect=['"Anchor" in "Mooring bow"', "is needed"]),
    Case("free solid in a tank that turns",
         **added(FREE_SOLID + "subsection Tank motion\n  set Rotation = 0.1*sin(t)\nend\n"),
         line=None, expect=['"Rotation" in "Tank motion"', "do not feel"]),
    Case("solid between periodic sides",
         **added(SOLID + "subsection Walls\n  set Left = periodic\n"
                 "  set Right = periodic\nend\n"),
         line=None, expect=['"Shape" in "Solid ball"', "periodic"]),
    Case("solid smaller than a cell",
         **added(SOLID.replace("0.8, 0.25", "0.85, 0.25").replace("= 0.1", "= 0.02")),
         line=None, validate=False, expect=['"Shape" in "Solid ball"', "cuts no cell"]),
    Case("solid outside of the domain", **added(SOLID.replace("0.8, 0.25", "8, 0.25")),
         line=None, validate=False, expect=['"Shape" in "Solid ball"', "cuts no cell"]),
    Case("fluid inside of a solid",
         **added(SOLID.replace("0.8, 0.25", "0.2, 0.1").replace("= 0.1", "= 0.45")),
         line=None, expect=['"Shape" in "Fluid body column"', "no material point"]),
    Case("material of a body that there is not",
         arguments=["scene.prm", "--set", "Fluid body column/Material = oil"],
         line=None, expect=['"Material" in "Fluid body column" = oil',
                            'no subsection "Material oil"']),
    Case("material without a density",
         **added("subsection Material oil\n  set Dynamic viscosity = 1\nend\n"),
         line=None, expect=['"Density" in "Material oil"']),
    Case("choice misspelt",
         **added("subsection Walls\n  set Left = noslip\nend\n"),
         line=LAST + 2,
         expect=['"Left" in "Walls" = noslip', '"no-slip"', '"open"']),
    Case("friction of a wall that sticks",
         **added("subsection Walls\n  set Left = no-slip\n"
                 "  set Left friction = 0.01\nend\n"),
         line=LAST + 3, expect=['"Left friction" in "Walls"', "slip"]),
    Case("friction with newmark",
         **added("subsection Walls\n  set Left friction = 0.01\nend\n"
                 "subsection Time\n  set Scheme = newmark\nend\n"),
         line=LAST + 5, expect=['"Scheme" in "Time"', "friction"]),
    Case("wall that jumps at the start",
         **added("subsection Walls\n  set Left displacement = 0.1*cos(t)\nend\n"),
         line=LAST + 2, expect=['"Left displacement" in "Walls"', "t = 0"]),
    Case("a tank without ends that turns", **added(PERIODIC + "end\n"
         "subsection Tank motion\n  set Rotation = 0.1*sin(t)\nend\n"),
         line=LAST + 6, expect=['"Rotation" in "Tank motion"', "periodic"]),
    Case("wall through the tank",
         **added("subsection Walls\n  set Left displacement = 50*t\nend\n"),
         line=LAST + 2, expect=['"Left displacement" in "Walls"', "leaves"]),
    Case("wall that jumps later",
         **added("subsection Walls\n  set Right displacement = "
                 "if(t>0.007, -0.1, 0)\nend\n"),
         line=LAST + 2, expect=['"Right displacement" in "Walls"', "jumps"]),
    Case("wall that moves in steps",
         **added("subsection Walls\n  set Left displacement = "
                 "0.02*floor(t*1000/7)\nend\n"),
         line=LAST + 2, expect=['"Left displacement" in "Walls"', "jumps"]),
    Case("wall that bends",
         **added("subsection Walls\n  set Left displacement = t*y\nend\n"),
         line=LAST + 2, expect=['"Left displacement" in "Walls"', "t alone"]),
    Case("open side that moves",
         **added("subsection Walls\n  set Left = open\n"
                 "  set Left displacement = t\nend\n"),
         line=LAST + 3, expect=['"Left displacement" in "Walls"', "open"]),
    Case("wall that leaves its place after a while",
         **added("subsection Walls\n  set Left = no-slip\n"
                 "  set Left velocity = t*(t>0.01); 1\nend\n"),
         line=LAST + 3, expect=['"Left velocity" in "Walls"', "t = 0.01"]),
    Case("series with the mass that it stands for",
         **added("subsection Transfer\n  set Method = FMPM\n"
                 "  set Mass = consistent\nend\n"),
         line=LAST + 3, expect=['"Mass" in "Transfer"', "lumped"]),
    Case("step zero", "= 0.01", "= 0", expect=['"Step" in "Time"']),
    Case("negative end time", "= 0.02", "= -1",
         expect=['"End time" in "Time"']),
    Case("no points", **added("subsection Points\n"
                              "  set Per cell and direction = 0\nend\n"),
         line=LAST + 2, expect=['"Per cell and direction" in "Points"']),
    Case("not an integer", **added("subsection Points\n"
                                   "  set Per cell and direction = 2.5\nend\n"),
         line=LAST + 2, expect=['"Per cell and direction" in "Points"']),
    Case("jitter too large",
         **added("subsection Points\n  set Jitter = 0.7\nend\n"),
         line=LAST + 2, expect=['"Jitter" in "Points" = 0.7', "0.5"]),
    Case("value by --set",
         arguments=["scene.prm", "--set", "Fluid/Density = -1"],
         expect=['--set "Fluid/Density = -1"', '"Density" in "Fluid"']),
    Case("several problems at once", "= 1000\n  set Dynamic viscosity = 0.001",
         "= -1\n  set Dynamic viscosity = -1", line=11,
         expect=["scene.prm:12: ", '"Density"', '"Dynamic viscosity"']),
]

GEOMETRY = [
    Case("mistakes of two sections at once", text=SCENE.replace("1.0, 0.5", "-1, 0.5")
         .replace("End time = 0.02", "End time = 1e300"), line=4,
         expect=['"Upper corner" in "Grid"', "scene.prm:20: ", '"End time" in "Time"']),
    Case("corners in the wrong order", "Upper corner = 1.0, 0.5",
         "Upper corner = -1.0, 0.5", expect=['"Upper corner" in "Grid"']),
    Case("three numbers in 2D", "Upper corner = 1.0, 0.5",
         "Upper corner = 1.0, 0.5, 1", expect=['"Upper corner" in "Grid"']),
    Case("cell size zero", "= 0.1", "= 0", expect=['"Cell size" in "Grid"']),
    Case("far too many cells", "= 0.1", "= 1e-9",
         expect=['"Cell size" in "Grid"']),
    Case("break point outside", "  set Cell size    = 0.1",
         "  set Cell size    = 0.1\n  set Break points x = 2", line=6,
         expect=['"Break points x" in "Grid" = 2']),
    Case("break points not ascending", "  set Cell size    = 0.1",
         "  set Cell size    = 0.1\n  set Break points x = 0.5, 0.3", line=6,
         expect=['"Break points x" in "Grid"']),
    Case("wrong number of cell counts", "  set Cell size    = 0.1",
         "  set Cell size    = 0.1\n  set Cells x = 4, 5", line=6,
         expect=['"Cells x" in "Grid" = 4, 5']),
    Case("obstacle outside",
         **added("subsection Obstacle box\n  set Lower corner = 0.9, 0\n"
                 "  set Upper corner = 1.2, 0.1\nend\n"),
         line=LAST + 3, expect=['"Upper corner" in "Obstacle box"']),
    Case("obstacles that overlap",
         **added("subsection Obstacle a\n  set Lower corner = 0.5, 0\n"
                 "  set Upper corner = 0.7, 0.2\nend\n"
                 "subsection Obstacle b\n  set Lower corner = 0.6, 0\n"
                 "  set Upper corner = 0.8, 0.1\nend\n"),
         line=LAST + 6, expect=['"Lower corner" in "Obstacle b"', '"a"']),
    Case("one periodic side", **added("subsection Walls\n  set Left = periodic\nend\n"),
         line=None, expect=['"Right" in "Walls"', '"Left" is periodic']),
    Case("few cells along a periodic direction", "  set Cell size    = 0.1",
         "  set Cells x = 3\n  set Cells y = 5\nend\n" + PERIODIC, line=5,
         expect=['"Cells x" in "Grid"', "at least 4"]),
    Case("periodic side that moves",
         **added("subsection Walls\n  set Left = periodic\n  set Right = periodic\n"
                 "  set Right displacement = 0.1*t\nend\n"),
         line=LAST + 4, expect=['"Right displacement"', "no wall"]),
    Case("friction of a periodic side",
         **added("subsection Walls\n  set Left = periodic\n  set Right = periodic\n"
                 "  set Left friction = 0.01\nend\n"),
         line=LAST + 4, expect=['"Left friction"']),
    Case("velocity of a periodic side",
         **added("subsection Walls\n  set Left = periodic\n  set Right = periodic\n"
                 "  set Left velocity = 0; 1\nend\n"),
         line=LAST + 4, expect=['"Left velocity"', "no-slip"]),
    Case("obstacle at one periodic side", "  set Cell size    = 0.1",
         "  set Cell size    = 0.1\nend\nsubsection Obstacle o\n"
         "  set Lower corner = 0.7, 0\n  set Upper corner = 1, 0.2\nend\n" + PERIODIC,
         line=9, expect=['"Upper corner" in "Obstacle o"', '"right"']),
    Case("front along a periodic direction", "  set Cell size    = 0.1",
         "  set Cell size    = 0.1\nend\nsubsection Front f\n"
         "  set Direction = x\nend\n" + PERIODIC,
         line=8, expect=['"Direction" in "Front f"', "periodic"]),
    Case("force on a periodic side", "  set Cell size    = 0.1",
         "  set Cell size    = 0.1\nend\nsubsection Force f\n"
         "  set Walls = bottom, left\nend\n" + PERIODIC,
         line=8, expect=['"Walls" in "Force f"', '"left" is periodic']),
    Case("run-up on a periodic side", "  set Cell size    = 0.1",
         "  set Cell size    = 0.1\nend\nsubsection Run-up r\n"
         "  set Wall = right\nend\n" + PERIODIC,
         line=8, expect=['"Wall" in "Run-up r"', '"right" is periodic']),
    Case("refinement near a periodic side", "  set Cell size    = 0.1",
         "  set Cell size    = 0.1\nend\nsubsection Refinement r\n"
         "  set Criterion = walls\n  set Distance = 0.1\n  set Names = left\nend\n"
         + PERIODIC, line=10, expect=['"Names" in "Refinement r"', '"left"']),
    Case("sound in an incompressible fluid",
         **added("subsection Time\n  set Elastic pressure = middle\nend\n"),
         line=LAST + 2, expect=['"Elastic pressure" in "Time"', "Bulk"]),
    Case("step control by the error of a scheme of first order",
         **added("subsection Time\n  set Step control = error\n"
                 "  set Rho infinity = 0.5\nend\n"),
         line=LAST + 2, expect=['"Step control" in "Time"', "Rho infinity"]),
    Case("step control by the error of steps that may have failed",
         **added("subsection Time\n  set Step control = error\n"
                 "  set Failing steps = accepted\nend\n"),
         line=LAST + 3, expect=['"Failing steps" in "Time"', "Step control"]),
    Case("a subscale residual without subscales",
         **added("subsection Formulation\n  set Stabilization = none\n"
                 "  set Subscale residual = without inertia\nend\n"),
         line=LAST + 3, expect=['"Subscale residual" in "Formulation"', "whole"]),
    Case("a subscale residual in a form without subscales",
         "  set Bulk modulus      = infinite\n",
         "  set Bulk modulus      = 1e6\n", line=False,
         arguments=["scene.prm",
                    "--set", "Formulation/Name = displacement",
                    "--set", "Formulation/Subscale residual = without inertia"],
         expect=['"Subscale residual" in "Formulation"', "mixed"]),
    Case("lumped inertia of elements of degree 2",
         **added("subsection Formulation\n  set Element degree = 2\n"
                 "  set Inertia = lumped\nend\n"
                 "subsection Points\n  set Per cell and direction = 4\nend\n"),
         line=LAST + 3, expect=['"Inertia" in "Formulation"', "degree"]),
    Case("a multigrid for systems that may be factorised",
         **added("subsection Solver\n  set Multigrid = ML\nend\n"),
         line=LAST + 2, expect=['"Multigrid" in "Solver"',
                                "Linear solver = iterative"]),
    Case("a multigrid for the pressure of a form without any",
         "  set Bulk modulus      = infinite\n",
         "  set Bulk modulus      = 1e6\n", line=False,
         arguments=["scene.prm",
                    "--set", "Formulation/Name = displacement",
                    "--set", "Solver/Linear solver = iterative",
                    "--set", "Solver/Multigrid = ML"],
         expect=['"Multigrid" in "Solver"', "irreducible"]),
    Case("a grid line beside the face of an obstacle",
         "  set Cell size    = 0.1",
         "  set Cell size    = 0.1\n  set Break points x = 0.4999", line=6,
         text=SCENE + "subsection Obstacle box\n  set Lower corner = 0.5, 0\n"
         "  set Upper corner = 0.7, 0.2\nend\n",
         expect=['"Break points x" in "Grid"', "0.0001 m"]),
    Case("a box of refinement outside of the domain",
         **added("subsection Refinement a\n  set Criterion = box\n"
                 "  set Lower corner = 5, 5\n  set Upper corner = 6, 6\nend\n"
                 "subsection Refinement b\n  set Criterion = fluid\nend\n"),
         line=LAST + 3, expect=['"Lower corner" in "Refinement a"', "outside"]),
    Case("more points than memory",
         **added("subsection Points\n  set Per cell and direction = 8\nend\n"
                 "subsection Refinement a\n  set Criterion = free surface\n"
                 "  set Level = 12\nend\n"),
         line=LAST + 2, expect=['"Per cell and direction" in "Points"', "memory", "GB"]),
    Case("unknown refinement criterion",
         **added("subsection Refinement a\n  set Criterion = surface\nend\n"),
         line=LAST + 2, expect=['"Criterion" in "Refinement a"',
                                "free surface"]),
    Case("refinement that never sees the fluid",
         **added("subsection Refinement a\n  set Criterion = box\n"
                 "  set Lower corner = 0, 0\n  set Upper corner = 1, 1\nend\n"),
         line=LAST + 2, expect=['"Criterion" in "Refinement a"', '"fluid"']),
    Case("refinement near walls without a distance",
         **added("subsection Refinement a\n  set Criterion = walls\nend\n"),
         line=LAST + 1, expect=['"Distance" in "Refinement a"']),
    Case("refinement near an unknown wall",
         **added("subsection Refinement a\n  set Criterion = walls\n"
                 "  set Distance = 0.1\n  set Names = left, lid\nend\n"),
         line=LAST + 4, expect=['"Names" in "Refinement a"', '"lid"',
                                '"left"']),
    Case("refinement near probes that are not there",
         **added("subsection Refinement a\n  set Criterion = probes\n"
                 "  set Distance = 0.1\nend\n"),
         line=LAST + 1, expect=['"Names" in "Refinement a"', "no probe"]),
    Case("refinement box inside out",
         **added("subsection Refinement a\n  set Criterion = box\n"
                 "  set Lower corner = 1, 1\n  set Upper corner = 0, 0\nend\n"),
         line=LAST + 4, expect=['"Upper corner" in "Refinement a"']),
    Case("fluid outside the domain", "= 0.4, 0.3", "= 1.4, 0.3", line=None,
         expect=["scene.prm:", '"Fluid body column"']),
    Case("body inside out", "= 0.4, 0.3", "= -0.4, 0.3", line=None,
         expect=["scene.prm:", '"Fluid body column"']),
    Case("no fluid", "subsection Fluid body column\n  set Lower corner = 0, 0\n"
         "  set Upper corner = 0.4, 0.3\nend\n", "",
         expect=["scene.prm", "Fluid body NAME"]),
    Case("unknown shape", "= 0.4, 0.3", "= 0.4, 0.3\n  set Shape = bal",
         line=18, expect=['"Shape" in "Fluid body column" = bal', '"ball"']),
    Case("ball without radius",
         **added("subsection Fluid body drop\n  set Shape = ball\n"
                 "  set Centre = 0.7, 0.3\nend\n"),
         line=LAST + 1, expect=['"Radius" in "Fluid body drop"']),
    Case("polygon with two vertices",
         **added("subsection Fluid body p\n  set Shape = polygon\n"
                 "  set Vertices = 0.5 0, 0.9 0.2\nend\n"),
         line=LAST + 3, expect=['"Vertices" in "Fluid body p"']),
    Case("span of a polygon in 2D",
         **added("subsection Fluid body p\n  set Shape = polygon\n"
                 "  set Span = 0.1, 0.2\nend\n"),
         line=LAST + 3, expect=['"Span" in "Fluid body p"', '"Vertices"']),
    Case("shape that is a part of its part",
         **added("subsection Shape a\n  set Shape = union\n  set Parts = b\nend\n"
                 "subsection Shape b\n  set Shape = union\n  set Parts = a\nend\n"),
         line=LAST + 3, expect=['"Parts" in "Shape a"', "part of itself"]),
    Case("part that is no shape",
         **added("subsection Fluid body p\n  set Shape = union\n  set Parts = a\nend\n"),
         line=LAST + 3, expect=['"Parts" in "Fluid body p"', '"Shape a"']),
    Case("body without a point", "= 0.4, 0.3",
         "= 0.4, 0.3\nend\nsubsection Fluid body again\n"
         "  set Lower corner = 0, 0\n  set Upper corner = 0.1, 0.1",
         line=None, expect=["scene.prm:", '"Fluid body again"']),
    Case("front above the domain",
         **added("subsection Front f\n  set Least height = 99\nend\n"),
         line=LAST + 2, expect=['"Least height" in "Front f"', "domain"]),
    Case("a name whose column there is already",
         **added("subsection Gauge a\n  set Position = 0.1, 0\nend\n"
                 "subsection Gauge a spray\n  set Position = 0.1, 0\nend\n"),
         line=None, expect=["scene.prm:", '"Gauge a spray"', "another name"]),
    Case("probe outside",
         **added("subsection Probe p\n  set Position = 5, 0\nend\n"),
         line=LAST + 2, expect=['"Position" in "Probe p"']),
    Case("filter above half of the sampling rate",
         **added("subsection Probe p\n  set Position = 0.1, 0\n"
                 "  set Sampling rate = 100\n  set Cut-off frequency = 60\nend\n"),
         line=LAST + 4, expect=['"Cut-off frequency" in "Probe p"', '"Sampling rate"']),
    Case("force on an unknown wall",
         **added("subsection Force f\n  set Walls = rigth\nend\n"),
         line=LAST + 2, expect=['"Walls" in "Force f"', '"right"']),
    Case("no such wall of a run-up",
         **added("subsection Run-up r\n  set Wall = rigth\nend\n"),
         line=LAST + 2, expect=['"Wall" in "Run-up r"', '"right"']),
    Case("run-up on the bottom",
         **added("subsection Run-up r\n  set Wall = bottom\nend\n"),
         line=LAST + 2, expect=['"Wall" in "Run-up r"', "upright"]),
    Case("force on a face that no water gets to",
         **added("subsection Obstacle block\n  set Lower corner = 0.6, 0\n"
                 "  set Upper corner = 0.7, 0.2\nend\n"
                 "subsection Force f\n  set Walls = block\n  set Face = bottom\nend\n"),
         line=LAST + 7, expect=['"Face" in "Force f" = bottom', "another face"]),
    Case("score of an unknown column",
         **added("subsection Score s\n  set Column = speed_mx [m/s]\nend\n"),
         line=LAST + 2, expect=['"Column" in "Score s"', "speed_max"]),
    Case("verdict on a score that there is not",
         **added("subsection Score speed\n  set Column = speed_max [m/s]\nend\n"
                 "subsection Verdict v\n  set Value = errors/sped\n"
                 "  set At most = 1\nend\n"),
         line=LAST + 5, expect=['"Value" in "Verdict v"',
                                'did you mean "errors/speed"']),
    Case("verdict on a number that there is not",
         **added("subsection Verdict v\n  set Value = ledger/lost_point\n"
                 "  set At most = 0\nend\n"),
         line=LAST + 2, expect=['did you mean "ledger/lost_points"',
                                '"largest/overfull"', '"rejected_steps"']),
    Case("verdict on a number of a tank that stands still",
         **added("subsection Verdict v\n  set Value = ledger/tank_work\n"
                 "  set At most = 0\nend\n"),
         line=LAST + 2, expect=["no such number"], unexpected=["momentum_imbalance"]),
    Case("verdict on a gauge",
         **added("subsection Gauge g\n  set Position = 0.1, 0\nend\n"
                 "subsection Verdict v\n  set Value = g [m]\n"
                 "  set At most = 0\nend\n"),
         line=LAST + 5, expect=["no such number", "Score: errors/NAME"]),
    Case("verdict without a bound",
         **added("subsection Verdict v\n  set Value = steps\nend\n"),
         line=LAST + 1, expect=['"At most" in "Verdict v"', "bound"]),
    Case("verdict that nothing passes",
         **added("subsection Verdict v\n  set Value = steps\n  set At least = 6\n"
                 "  set At most = 5\nend\n"),
         line=LAST + 4, expect=['"At most" in "Verdict v"', "no number can"]),
] + [
    Case(f"reference table: {name}",
         **added("subsection Score s\n  set Column = speed_max [m/s]\n"
                 f"  set Reference table = {name}\nend\n"),
         line=LAST + 3, expect=['"Reference table" in "Score s"', text],
         prepare=lambda folder: os.mkfifo(folder / "pipe"))
    for name, text in [("none.csv", "none.csv: there is no such file"),
                       ("/dev/zero", "regular file"), ("pipe", "regular file")]
]


SIGNAL = "t,a\n0,0\n0.01,0.001\n0.02,0.002\n0.03,0.003\n"
SHORT = "t,a\n0,0\n0.005,0.0005\n0.01,0.001\n"
TABLE = "subsection Table s\n  set File = s.csv\nend\n"
CALLED = TABLE + "subsection Walls\n  set Left displacement = s(t)\nend\n"


def with_table(name, rows=SIGNAL, text=CALLED, line=LAST + 2, **options):
    """A scene with a table that moves a wall."""
    return Case(f"table: {name}", text=SCENE + text, line=line,
                others={"s.csv": rows}, **options)


# A "Table NAME" is read with its scene, and must cover the run.
TABLES = [
    with_table("covers the run", code=0, line=None, silent=True),
    with_table("missing file", text=CALLED.replace("s.csv", "none.csv"),
               expect=['"File" in "Table s" = none.csv', "no such file"]),
    with_table("empty", rows="", expect=["s.csv", "empty"]),
    with_table("semicolons", rows=SIGNAL.replace(",", ";"),
               expect=["s.csv:1:", "separated by commas"]),
    with_table("tabs", rows=SIGNAL.replace(",", "\t"),
               expect=["s.csv:1:", "separated by commas"]),
    with_table("no header", rows=SIGNAL[4:], expect=["s.csv:1:", "header"]),
    with_table("column that there is not",
               text=CALLED.replace("s.csv", "s.csv\n  set Columns = 0, 2"),
               expect=["s.csv:2:", "2 columns", '"Columns"']),
    with_table("column of what it holds by name",
               text=CALLED.replace("s.csv", "s.csv\n  set Columns = t, a"),
               line=LAST + 3, expect=['"Columns" in "Table s"']),
    with_table("column that no number can be",
               text=CALLED.replace("s.csv", "s.csv\n  set Columns = 4294967296, 1"),
               line=LAST + 3, expect=['"Columns" in "Table s"', "between 0 and 9999"]),
    with_table("one factor",
               text=CALLED.replace("s.csv", "s.csv\n  set Factors = 0.001"),
               line=LAST + 3, expect=['"Factors" in "Table s"', "two"]),
    with_table("times that go back", rows=SIGNAL.replace("0.02,", "0.01,"),
               expect=["s.csv:4:", "increase"]),
    with_table("not a number", rows=SIGNAL.replace("0.002", "nan"),
               expect=["s.csv:4:", '"nan" in column 1']),
    with_table("a gap", rows=SIGNAL.replace("0.002", ""),
               expect=["s.csv:4:", "column 1"]),
    with_table("a number that is too large",
               text=CALLED.replace("s.csv", "s.csv\n  set Factors = 1, 1e300"),
               rows=SIGNAL.replace("0.002", "1e30"),
               expect=["s.csv:4:", "too large"]),
    Case("table: a pipe", text=SCENE + CALLED, line=LAST + 2, expect=["not a regular file"],
         prepare=lambda folder: os.mkfifo(folder / "s.csv")),
    with_table("two rows", rows="t,a\n0,0\n1,0.001\n", expect=["at least 3"]),
    with_table("ends before the run", rows=SHORT, line=LAST + 5,
               expect=['"Left displacement" in "Walls" = s(t)', "table s",
                       "asked for", "End time"]),
    with_table("begins after the run", rows=SIGNAL.replace("\n0,0", ""),
               line=LAST + 5, expect=['"Left displacement"', "0.01 s"]),
    with_table("ends before a body force",
               text=TABLE, rows=SHORT, line=None,
               arguments=["scene.prm", "--set",
                          "Body force/Acceleration = s(t); -9.81"],
               expect=["table s"]),
    with_table("corners in a wall's motion", line=LAST + 6,
               text=CALLED.replace("s.csv",
                                   "s.csv\n  set Interpolation = linear"),
               expect=['"Left displacement"', "cubic spline"]),
    with_table("not called", text=TABLE, code=0,
               expect=['"File" in "Table s" = s.csv has no effect', "s(t)"]),
    with_table("name of a function",
               text=CALLED.replace("Table s", "Table sin"),
               expect=['"File" in "Table sin"', "know already"]),
    with_table("name of two words",
               text=CALLED.replace("Table s", "Table s 1"),
               expect=['"File" in "Table s 1"', "one word"]),
    with_table("without a file", text=TABLE.replace("  set File = s.csv\n", ""),
               line=LAST + 1, expect=['"File" in "Table s"', "mandatory"]),
    with_table("misspelt call", text=TABLE, line=None,
               arguments=["scene.prm", "--set", "Walls/Left displacement = r(t)"],
               expect=['"Left displacement"', '"r"', "the tables of this file: s(t)"]),
    Case("table: a call without any", "0; -9.81", "0; w(t)",
         expect=['"Acceleration"', '"w"', 'subsection "Table NAME"']),
] + [
    Case(f"tank motion {entry} = {text}",
         arguments=["scene.prm", "--set", f"Tank motion/{entry} = {text}"],
         line=None, expect=[f'"{entry}" in "Tank motion"', *expect])
    for entry, text, expect in [
        ("Rotation", "t; 0", ["1 needed"]), ("Rotation", "x", ["t alone"]),
        ("Rotation", "t>0.01 ? 1 : 0", ["jumps"]), ("Rotation", "w(t)", ["w"]),
        ("Displacement", "t", ["2 needed"]),
        ("Displacement", "1/(t-0.01); 0", ["not finite"]),
        ("Centre", "0", ["2 needed"]), ("Free", "w", ["x, y, rotation"]),
        ("Free", "x, x", ["twice"])]
] + [
    Case(f"tank that is free to sway, {entry} = {text}",
         arguments=["scene.prm"] + [
             argument
             for name, value in {"Free": "x", "Inertia": "1", entry: text}.items()
             for argument in ("--set", f"Tank motion/{name} = {value}")],
         line=None, expect=[f'"{entry}" in "Tank motion"', *expect])
    for entry, text, expect in [
        ("Inertia", "1 - 200*t", ["greater than zero"]),
        ("Inertia", "1 + x", ["t alone"]), ("Inertia", "1; 2", ["1 needed"]),
        ("Load", "1; 2", ["1 needed"]), ("Load", "1/(t - 0.01)", ["not finite"]),
        ("Start", "0, 1", ["2 number(s)", "Free"])]
]


def gravity(expression):
    return f"Acceleration = {expression}"


EXPRESSIONS = [
    Case(f"expression {text}", "Acceleration = 0; -9.81", gravity(text),
         expect=['"Acceleration" in "Body force"'])
    for text in ["0; -9.81*", "0; (1", "0; foo(x)", "0; w", "0; 1/0",
                 "0; sqrt(-1)", "0; 0/0", "0; log(x-x)", "0; x, y", "0; y=3",
                 "0; rand()", "0", "0; 1; 2", "0; z", "0;", "0; -9,81", "0; $"]
] + [
    Case(f"velocity {text}", "  set Upper corner = 0.4, 0.3",
         f"  set Upper corner = 0.4, 0.3\n  set Velocity = {text}", line=18,
         expect=['"Velocity" in "Fluid body column"'])
    for text in ["1/x", "0; q", "0; sqrt(0.2-x)"]
]

COMMAND_LINE = [
    Case("no file", arguments=[], expect=["Usage", "FILE.prm"]),
    Case("two files", arguments=["scene.prm", "other.prm"],
         expect=["other.prm"]),
    Case("unknown option", arguments=["scene.prm", "--ouput", "x"],
         expect=["--ouput", "--output"]),
    Case("--set without text", arguments=["scene.prm", "--set"],
         expect=["--set"]),
    Case("--set without equals sign",
         arguments=["scene.prm", "--set", "Fluid/Density"],
         expect=['"Subsection/Entry = value"']),
    Case("--set without entry", arguments=["scene.prm", "--set", "Fluid/ = 1"],
         expect=['"Subsection/Entry = value"']),
    Case("--set twice", arguments=["scene.prm", "--set", "Fluid/Density = 1",
                                   "--set", "Fluid/Density = 2"],
         expect=['"Density"', "twice"]),
    Case("--set twice after one option",
         arguments=["scene.prm", "--set", "Fluid/Density = 1",
                    "Time/Step = 1"], expect=["Time/Step = 1"]),
    Case("--example with --validate", arguments=["--example", "dam_break"],
         expect=["--example prints a scene"]),
    Case("--output without folder", arguments=["scene.prm", "--output"],
         expect=["--output"], validate=False),
    Case("--output with an empty name", arguments=["scene.prm", "--output", ""],
         expect=["--output"], validate=False),
]

BAD_RUN = "scene.prm", "--output", "out"


def old_run(folder):
    (folder / "out").mkdir()
    for name in ("summary.json", "parameters.prm", "run.log", "statistics.csv"):
        (folder / "out" / name).write_text("of an earlier run\n")


def blocked(folder):
    (folder / "out").write_text("a file, no folder\n")


def locked(folder):
    (folder / "out").mkdir()
    lock = open(folder / "out" / ".lock", "w")
    fcntl.flock(lock, fcntl.LOCK_EX)
    return lock


def full(name):
    """The file is on a full disk: /dev/full refuses every byte."""
    def prepare(folder):
        old_run(folder)
        (folder / "out" / name).unlink(missing_ok=True)
        (folder / "out" / name).symlink_to("/dev/full")
    return prepare


OUTPUT = [
    # a run, not only --validate: nothing may be written over
    Case("bad value", "= 1000", "= -1", arguments=[*BAD_RUN], validate=False,
         prepare=old_run, expect=['"Density"']),
    Case("bad body", "= 0.4, 0.3", "= 1.4, 0.3", arguments=[*BAD_RUN],
         validate=False, prepare=old_run, line=None, expect=["Fluid body"]),
    Case("bad velocity", "  set Upper corner = 0.4, 0.3",
         "  set Upper corner = 0.4, 0.3\n  set Velocity = 0; sqrt(0.2-x)",
         arguments=[*BAD_RUN], validate=False, prepare=old_run, line=18,
         expect=['"Velocity"']),
    Case("bad probe",
         **added("subsection Probe p\n  set Position = 5, 0\nend\n"),
         arguments=[*BAD_RUN], validate=False, prepare=old_run,
         line=LAST + 2, expect=['"Position"']),
    Case("output is a file", arguments=[*BAD_RUN], validate=False,
         prepare=blocked, expect=["out", "--output"]),
    Case("output below a file",
         arguments=["scene.prm", "--output", "scene.prm/out"], validate=False,
         expect=["scene.prm/out", "--output"]),
    Case("output where nothing can be made",
         arguments=["scene.prm", "--output", "/proc/seiche"], validate=False,
         expect=["/proc/seiche", "--output"]),
    Case("--set of a subsection",
         arguments=["scene.prm", "--set", "Fluid = 3"],
         expect=['"Fluid"', "subsection"]),
    Case("locked by another run", arguments=[*BAD_RUN], validate=False,
         prepare=locked, code=FILES, expect=["out", "another run"]),
] + [
    Case(f"disk full, {name}", arguments=[*BAD_RUN], validate=False,
         full_disk=True, code=FILES, prepare=full(name),
         expect=[f"out/{file}", "No space left", "--output"])
    for name, file in [("parameters.prm.writing", "parameters.prm"),
                       ("run.log", "run.log"),
                       ("statistics.csv", "statistics.csv"),
                       ("summary.json.writing", "summary.json"),
                       ("timing.txt.writing", "timing.txt")]
]

def in_vain(entry, added_to=None, **options):
    """An entry that the scene does not read: a warning that names it."""
    section, name = entry.split("/")
    value = options.pop("value")
    return Case(f"without effect: {entry}",
                arguments=["scene.prm", "--set", f"{entry} = {value}",
                           *[part for change in options.pop("also", ())
                             for part in ("--set", change)]],
                code=0, line=None,
                expect=[f'entry "{name}" in "{section}" = {value} has no effect',
                        options.pop("reader")])


IRREDUCIBLE = ("Formulation/Name = displacement", "Fluid/Bulk modulus = 1e6")

# Entries that nothing in the scene reads: said once, nothing refused.
WITHOUT_EFFECT = [
    in_vain("Time/CFL number", value="0.3", reader="Time/Step control = CFL"),
    in_vain("Time/Error tolerance", value="0.1",
            reader="Time/Step control = error",
            also=["Time/Step control = CFL"]),
    in_vain("Time/Bossak alpha", value="-0.1", reader="Time/Scheme = bossak"),
    in_vain("Time/Rho infinity", value="0.5", also=["Time/Scheme = newmark"],
            reader="Time/Scheme = generalized midpoint"),
    in_vain("Time/Pressure order", value="first", reader="Rho infinity = 1",
            also=["Time/Rho infinity = 0.5"]),
    in_vain("Time/Velocity projection", value="at the start",
            reader="displacement-pressure", also=IRREDUCIBLE),
    in_vain("Transfer/FLIP fraction", value="0.9", reader="PIC/FLIP blend"),
    in_vain("Transfer/Order", value="3", reader="XPIC or FMPM"),
    in_vain("Points/Shifting strength", value="0.1", reader="Shifting sweeps"),
    in_vain("Points/Fewest per cell", value="3", reader="Reseeding"),
    in_vain("Points/Most per cell", value="30", reader="Reseeding"),
    in_vain("Points/Seed", value="3", reader="Points/Jitter"),
    in_vain("Points/Density rate", value="1", reader="cut cells",
            also=["Quadrature/Rule = material points"]),
    in_vain("Formulation/Projection updates", value="2", reader="OSGS"),
    in_vain("Formulation/Projection mass", value="consistent", reader="OSGS"),
    in_vain("Formulation/Tau speed floor", value="2", reader="Tau = paper"),
    in_vain("Formulation/Stabilization", value="OSGS",
            reader="displacement-pressure", also=IRREDUCIBLE),
    in_vain("Formulation/Tau continuity factor", value="0.5",
            reader="subscales", also=["Formulation/Stabilization = none"]),
    in_vain("Free surface/Ghost pressure", value="0.5",
            reader="displacement-pressure", also=IRREDUCIBLE),
    in_vain("Free surface/Ghost velocity time", value="0.1",
            reader="Ghost velocity", also=["Free surface/Ghost velocity = 0"]),
    in_vain("Tank motion/Centre", value="0.5, 0", reader="Tank motion/Rotation"),
    in_vain("Tank motion/Load", value="-10*x", reader="Tank motion/Free"),
    in_vain("Fluid/Volume law", value="logarithmic", reader="finite"),
    in_vain("Fluid/Flow index", value="0.5", reader="Viscosity law = power law"),
    Case("without effect: a material that no body has",
         **added("subsection Material oil\n  set Density = 800\n"
                 "  set Dynamic viscosity = 0.05\nend\n"),
         code=0, line=LAST + 2,
         expect=['entry "Density" in "Material oil" = 800 has no effect',
                 "Fluid body with Material = oil"]),
    in_vain("Fluid body column/Radius", value="0.1", reader="Shape = ball"),
    in_vain("Fluid body column/Centre", value="0.1, 0.1",
            reader="ball or ellipsoid"),
    in_vain("Solver/Linear tolerance", value="0.1", reader="iterative",
            also=["Solver/Linear solver = direct"]),
    in_vain("Solver/Projection tolerance", value="0.01",
            reader="displacement-pressure", also=IRREDUCIBLE),
    in_vain("Grid/Cell size", value="0.2", reader='without "Cells"',
            also=["Grid/Cells x = 10", "Grid/Cells y = 5"]),
    Case("without effect: in a refinement and a score",
         **added("subsection Refinement near\n  set Level = 1\n"
                 "  set Distance = 0.1\nend\n"
                 "subsection Score level\n  set Column = mass [kg]\n"
                 "  set Interpolation = spline\nend\n"),
         code=0, line=LAST + 3,
         expect=['"Distance"', "walls or probes", '"Interpolation"', "Reference table"]),
    Case("without effect: a score of times after the end",
         **added("subsection Score late\n  set Column = mass [kg]\n"
                 "  set From = 5\nend\n"
                 "subsection Score at\n  set Column = mass [kg]\n"
                 "  set Times = 0.01, 5\nend\n"),
         code=0, line=LAST + 3,
         expect=['"From" in "Score late" = 5', '"Times" in "Score at" = 0.01, 5',
                 "Time/End time after"]),
    Case("set, but to the default", arguments=["scene.prm", "--set",
         "Time/CFL number = 0.4"], code=0, silent=True),
]

GROUPS = {"syntax": SYNTAX, "names": NAMES, "values": VALUES,
          "geometry": GEOMETRY, "tables": TABLES, "expressions": EXPRESSIONS,
          "command_line": COMMAND_LINE, "without_effect": WITHOUT_EFFECT,
          "output": OUTPUT}


def snapshot(folder):
    """Names and contents of everything in the folder but locks."""
    return {str(path.relative_to(folder)):
            path.read_bytes() if path.is_file() else None
            for path in sorted(folder.rglob("*")) if path.name != ".lock"}


def run_case(program, case, folder):
    """Problems of the case, and what it printed."""
    (folder / "scene.prm").write_bytes(case.text.encode())
    for name, text in case.others.items():
        (folder / name).write_text(text)
    held = case.prepare(folder) if case.prepare else None
    before = snapshot(folder)
    command = [program, *case.arguments]
    if case.validate:
        command.append("--validate")

    result = subprocess.run(command, cwd=folder, capture_output=True,
                            text=True, timeout=120, stdin=subprocess.DEVNULL)
    if hasattr(held, "close"):
        held.close()

    problems = []
    if result.returncode != case.code:
        problems.append(f"exit code {result.returncode}, not {case.code}")
    for text in case.expect:
        if text not in result.stderr:
            problems.append(f"the message lacks {text!r}")
    for text in ("internal error", "Stacktrace", "terminate called",
                 *case.unexpected):
        if text in result.stderr:
            problems.append(f"the message has {text!r}")
    if case.silent and result.stderr:
        problems.append("something is printed on standard error")
    if case.code == INPUT and result.stdout:
        problems.append("something is printed on standard output")
    after = snapshot(folder)
    if case.validate and case.code == 0:
        after.pop("scene.svg", None)  # the picture
    if after != before:
        changed = [name for name in set(after) | set(before)
                   if after.get(name) != before.get(name)]
        # on a full disk the run may have begun (which takes away the summary of an
        # earlier one), but not ended
        if not case.full_disk or "out/summary.json" in set(after) & set(changed):
            problems.append(f"files changed: {', '.join(sorted(changed))}")
    return problems, result.stdout + result.stderr


def numbers_in(summary, path=""):
    """Paths of the numbers of a summary, and of those that are null."""
    for name, value in summary.items():
        if isinstance(value, dict):
            yield from numbers_in(value, path + name + "/")
        elif value is None or isinstance(value, (int, float)):
            yield path + name


# Known to the run alone, after its verdicts.
AFTERWARDS = {"cpu_seconds", "wall_seconds", "peak_memory_mib", "ranks"}

WITH_NUMBERS = {  # all that adds some, in 2D and 3D
    "flat": "subsection Time\n  set Failing steps = accepted\nend\nsubsection Points\n"
            "  set Shifting sweeps = 1\n  set Reseeding = true\nend\nsubsection Tank motion\n"
            "  set Rotation = 0.1*t\nend\nsubsection Score s\n"
            "  set Column = speed_max [m/s]\nend\n",
    "deep": "subsection Time\n  set Step control = error\nend\n"}


def check_numbers(program):
    """A verdict may name just the numbers that the summary of a run has."""
    failures = 0
    for name, text in WITH_NUMBERS.items():
        scene = SCENE + text
        if name == "deep":
            for old, new in (("Dimension = 2", "Dimension = 3"), ("= 0, 0", "= 0, 0, 0"),
                             ("1.0, 0.5", "1.0, 0.5, 0.2"), ("0; -9.81", "0; 0; -9.81"),
                             ("0.4, 0.3", "0.4, 0.3, 0.2")):
                scene = scene.replace(old, new)
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "scene.prm").write_text(scene)
            command = [program, "scene.prm", "--output", "out"]
            run = subprocess.run(command, cwd=folder, capture_output=True, text=True,
                                 timeout=120)
            if run.returncode != 0:
                print(f"FAILED: {name}: {run.stderr}")
                return 1
            has = json.loads((folder / "out/summary.json").read_text())
            (folder / "scene.prm").write_text(
                scene + "subsection Verdict v\n  set Value = none\n  set At most = 0\nend\n")
            asked = subprocess.run([*command, "--validate"], cwd=folder,
                                   capture_output=True, text=True, timeout=120)
        has.pop("phase_seconds")
        has.pop("alarms", None)  # what they say is below "largest"
        names = asked.stderr.split("Numbers are ")[1].rsplit('". A column', 1)[0]
        difference = (set(numbers_in(has)) - AFTERWARDS) ^ set(names.strip('"').split('", "'))
        if difference:
            failures += 1
            print(f"FAILED: {name}: on one side only: {', '.join(sorted(difference))}")
    print(f"{len(WITH_NUMBERS)} scenes, {failures} failed")
    return 1 if failures else 0


def check_shipped(program, folder_of_files):
    """Every parameter file of the project is valid and has no entry in vain."""
    root = pathlib.Path(__file__).resolve().parents[2]
    files = sorted((root / folder_of_files).rglob("*.prm"))
    failures = 0
    for file in files:
        with tempfile.TemporaryDirectory() as folder:
            result = subprocess.run([program, str(file), "--validate",
                                     "--output", folder + "/scene"],
                                    capture_output=True, text=True, timeout=120)
        # scenes of alarms are to be warned of
        warned = result.stderr and file.parent.name != "alarms"
        if result.returncode != 0 or warned:
            failures += 1
            print(f"FAILED: {file.relative_to(root)}\n    {result.stderr.strip()}")
    print(f"{len(files)} files, {failures} failed")
    return 1 if failures else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("group", choices=[*GROUPS, "numbers", "shipped_prm", "shipped_tests", "all"])
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    program = str(options.program.resolve())
    if options.group == "numbers":
        return check_numbers(program)
    if options.group.startswith("shipped_"):
        return check_shipped(program, options.group.removeprefix("shipped_"))
    cases = [case for name, group in GROUPS.items() for case in group
             if options.group in (name, "all")]
    if options.group == "all" or options.group == "values":
        cases.insert(0, None)

    failures = 0
    for case in cases:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            if case is None:
                # the scene itself must be fine, or the cases prove nothing
                case = Case("unbroken scene", code=0, expect=[])
            problems, printed = run_case(program, case, folder)
        failures += bool(problems)
        if problems or options.verbose:
            print(f"{'FAILED' if problems else 'passed'}: {case.name}")
            for problem in problems:
                print(f"    {problem}")
            for line in printed.strip().split("\n")[:20]:
                print("    | " + line)
    print(f"{len(cases)} cases, {failures} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    os.environ["LC_ALL"] = "C"
    sys.exit(main())
