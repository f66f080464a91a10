# SPDX-License-Identifier: LGPL-2.1-or-later
"""First mode of a closed tank in OpenFOAM: 1 m long, water 0.5 m deep under 0.2 m of
air, slip walls, started at rest by its elevation, A cos(pi x). Read: the height of
water in the columns of cells at both ends."""

import math

import openfoam

LENGTH, HEIGHT, DEPTH = 1.0, 0.7, 0.5


def make(folder, options):
    nx, ny = round(LENGTH / options.h), round(HEIGHT / options.h)
    vertices = "".join(f"({x} {y} {z})\n" for z in (0, openfoam.THICKNESS)
                       for y in (0, HEIGHT) for x in (0, LENGTH))
    openfoam.write(folder, "system/blockMeshDict", "dictionary", f"""
vertices ( {vertices} ); blocks ( hex (0 1 3 2 4 5 7 6) ({nx} {ny} 1) simpleGrading (1 1 1) ); edges ();
boundary ( left {{ type wall; faces ((0 4 6 2)); }} right {{ type wall; faces ((1 3 7 5)); }}
 bottom {{ type wall; faces ((0 1 5 4)); }} top {{ type patch; faces ((2 6 7 3)); }}
 frontAndBack {{ type empty; faces ((0 2 3 1) (4 5 7 6)); }} );""")
    xs, ys = openfoam.middles(0, LENGTH, nx), openfoam.middles(0, HEIGHT, ny)
    each_step = "writeControl timeStep; writeInterval 1;"
    openfoam.write_control(
        folder, options,
        "".join(openfoam.probes(name, "alpha.water", [(x, y) for y in ys], each_step)
                for name, x in (("left", xs[0]), ("right", xs[-1]))), 0.01)
    openfoam.write_water_and_air(folder, f"(0 {-openfoam.GRAVITY} 0)")

    def walls(text, top):
        return {"left": text, "right": text, "bottom": text, "top": top, "frontAndBack": "empty;"}

    openfoam.write_dam_break_fields(folder, walls)

    def share(x, y):  # of a cell below the surface, its mean over the cell
        k, half = math.pi / LENGTH, options.h / 2
        mean = options.amplitude * math.cos(k * x) * math.sin(k * half) / (k * half)
        return max(0.0, min(1.0, (DEPTH + mean - y) / options.h + 0.5))

    alpha = "\n".join("%.10g" % share(x, y) for y in ys for x in xs)
    openfoam.write_field(folder, "alpha.water", "volScalarField", "[0 0 0 0 0 0 0]",
                         f"nonuniform List<scalar> {nx * ny} (\n{alpha}\n)",
                         walls("zeroGradient;", "inletOutlet; inletValue uniform 0; value uniform 0;"))


def curves(folder, options):
    left, right = (openfoam.table(folder, name, "alpha.water") for name in ("left", "right"))
    return {"t": [row[0] for row in left],
            "left": [options.h * sum(row[1:]) for row in left],
            "right": [options.h * sum(row[1:]) for row in right]}
