# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tank with a box for OpenFOAM: one block of cells between each pair of
neighbouring grid lines of the scene, air above, open top. The numbers below are
those of prm/benchmarks/marin_box/marin_box.prm."""

import openfoam
from curves import interpolate

LINES = ((0, 0.6635, 0.8245, 1.992, 3.22), (0, 0.295, 0.698, 1), (0, 0.161, 0.55, 1))
COLUMN = "(1.992 -1 -1) (4 2 0.55)"
BOX = (1, 1, 0)  # block that is left out
GAUGES = (1.488, 0.992, 0.496, 2.638)  # H1 to H4: x [m], y = 0.5
SENSORS = [("front", (0.8245, 0.471, z)) for z in (0.021, 0.061, 0.101, 0.141)] \
    + [("roof", (x, 0.471, 0.161)) for x in (0.8035, 0.7635, 0.7235, 0.6835)]  # P1 to P8


def counts(h):
    """Cells of about h between the lines of each direction."""
    return [[max(1, round((b - a) / h)) for a, b in zip(x, x[1:])] for x in LINES]


def write_mesh(folder, h):
    nx, ny, nz = (len(x) for x in LINES)

    def vertex(i, j, k):
        return i + nx * (j + ny * k)

    def quad(i, j, k, normal):
        """The lower face of block (i, j, k) normal to a direction."""
        corners = [[(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)], [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)],
                   [(0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)]][normal]
        return "(%s)" % " ".join(str(vertex(i + a, j + b, k + c)) for a, b, c in corners)

    blocks, n = [], counts(h)
    hexahedron = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    every = [(i, j, k) for k in range(nz - 1) for j in range(ny - 1) for i in range(nx - 1)]
    for i, j, k in every:
        if (i, j, k) != BOX:
            corners = " ".join(str(vertex(i + a, j + b, k + c)) for a, b, c in hexahedron)
            blocks.append(f"hex ({corners}) ({n[0][i]} {n[1][j]} {n[2][k]}) simpleGrading (1 1 1)")
    i, j, k = BOX
    top = [quad(a, b, nz - 1, 2) for a, b, c in every if c == 0]
    openfoam.write(folder, "system/blockMeshDict", "dictionary", "vertices ( %s );\nblocks (\n%s\n);\nedges ();\n" % (
        " ".join("(%g %g %g)" % (x, y, z) for z in LINES[2] for y in LINES[1] for x in LINES[0]),
        "\n".join(blocks)) + f"""
defaultPatch {{ name sides; type wall; }}
boundary ( top {{ type patch; faces ( {" ".join(top)} ); }}
 front {{ type wall; faces ( {quad(i + 1, j, k, 0)} ); }}
 roof {{ type wall; faces ( {quad(i, j, k + 1, 2)} ); }} );""")


def columns(h):
    """Heights of the middles and sizes of the cells above the bed [m]."""
    middles, sizes = [], []
    for low, high, count in zip(LINES[2], LINES[2][1:], counts(h)[2]):
        middles += openfoam.middles(low, high, count)
        sizes += [(high - low) / count] * count
    return middles, sizes


def make(folder, options):
    write_mesh(folder, options.h)
    heights, _ = columns(options.h)
    functions = "".join(openfoam.probes("H%d" % (i + 1), "alpha.water", [(x, 0.5001, z) for z in heights],
                        "writeControl timeStep; writeInterval 1;")
                        for i, x in enumerate(GAUGES))
    functions += "".join(
        openfoam.probes("P%d" % (i + 1), "p", [place], "writeControl timeStep; writeInterval 1;",
                        kind="patchProbes", extra=f"patches ({patch});")
        for i, (patch, place) in enumerate(SENSORS))
    openfoam.write_control(folder, options, functions, 0.02)
    openfoam.write(folder, "system/setFieldsDict", "dictionary", f"""
defaultFieldValues ( volScalarFieldValue alpha.water 0 );
regions ( boxToCell {{ box {COLUMN}; fieldValues ( volScalarFieldValue alpha.water 1 ); }} );""")
    openfoam.write_water_and_air(folder, "(0 0 -9.81)")

    def walls(text, top):
        return {"sides": text, "front": text, "roof": text, "top": top}

    openfoam.write_dam_break_fields(folder, walls)


def curves(folder, options):
    """{name: values} as in curves.csv: depths at their times, pressures there, too."""
    _, sizes = columns(options.h)
    result = {}
    for i in range(len(GAUGES)):
        rows = openfoam.table(folder, "H%d" % (i + 1), "alpha.water")
        result.setdefault("t", [row[0] for row in rows])
        result["H%d" % (i + 1)] = [sum(a * s for a, s in zip(row[1:], sizes)) for row in rows]
    for i in range(len(SENSORS)):
        rows = openfoam.table(folder, "P%d" % (i + 1), "p")
        times, values = [row[0] for row in rows], [row[1] for row in rows]
        result["P%d" % (i + 1)] = [interpolate(t, times, values) for t in result["t"]]
    return result
