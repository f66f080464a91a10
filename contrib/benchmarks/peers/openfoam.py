# SPDX-License-Identifier: LGPL-2.1-or-later
"""OpenFOAM (interFoam, interIsoFoam) on our scenes: writes a
case with the settings of its dam-break tutorial, runs it on one core and reads
front, height or centre pressure.

Dam break (two dimensions): the same tank, but 1.8 m high and open at the top, slip walls, air of
1 kg/m^3, no surface tension. Patch: in a box of 3.6 m of air of density 1e-3.
Tank with a box: openfoam_marin.py, waves: openfoam_waves.py. Front: last crossing of the volume fraction 0.5 at y = 0.025 m, the middle of
the lowest cell of the coarsest grid; height: first crossing along the left column.
"""

import argparse
import os
import re
import shutil
import subprocess
import tempfile

LENGTH, COLUMN_WIDTH, COLUMN_HEIGHT, HEIGHT, GRAVITY = 3.22, 1.2, 0.6, 1.8, 9.81
FRONT_HEIGHT = 0.025 - 1e-6  # within a cell, not between two [m]
THICKNESS = 0.1  # of the one layer of cells [m]
HALF_BOX = 1.8  # of the patch's box [m]
AIR = 1e-3  # density of its air


def parse(arguments):
    parser = argparse.ArgumentParser(prog="openfoam")
    parser.add_argument("scene", choices=("dam_break", "patch", "marin", "wave"))
    parser.add_argument("--h", type=float, required=True, help="cell size [m]")
    parser.add_argument("--co", type=float, required=True, help="largest Courant number")
    parser.add_argument("--end", type=float, default=2.5, help="[s]")
    parser.add_argument("--amplitude", type=float, default=0.01, help="of the wave [m]")
    parser.add_argument("--tight", action="store_true", help="tight pressure tolerances")
    parser.add_argument("--solver", default="interFoam", choices=("interFoam", "interIsoFoam"))
    return parser.parse_args(arguments)


def write(folder, path, kind, body):
    path = os.path.join(folder, path)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write("FoamFile\n{ version 2.0; format ascii; class %s; object %s; }\n%s\n"
                   % (kind, os.path.basename(path), body))


def middles(begin, end, count):
    return [begin + (end - begin) * (i + 0.5) / count for i in range(count)]


def write_numerics(folder, options):
    """Solvers and schemes of the tutorial damBreak; multigrid for the pressure."""
    iso = "isoFaceTol 1e-6; surfCellTol 1e-6; nAlphaBounds 3; snapTol 1e-12; clip true;"
    tolerance, relative, final = ("1e-9", "0.01", "1e-9") if options.tight else ("1e-7", "0.05", "1e-7")
    linear = "solver GAMG; smoother DIC;"
    write(folder, "system/fvSolution", "dictionary", f"""
solvers {{
 "alpha.water.*" {{ nAlphaCorr 2; nAlphaSubCycles 1; cAlpha 1; MULESCorr yes; nLimiterIter 5;
   {iso if options.solver == "interIsoFoam" else ""}
   solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0; }}
 "pcorr.*" {{ solver PCG; preconditioner DIC; tolerance 1e-5; relTol 0; }}
 p_rgh {{ {linear} tolerance {tolerance}; relTol {relative}; }}
 p_rghFinal {{ {linear} tolerance {final}; relTol 0; }}
 "U.*" {{ solver smoothSolver; smoother symGaussSeidel; tolerance 1e-6; relTol 0; }} }}
PIMPLE {{ momentumPredictor no; nOuterCorrectors 1; nCorrectors 3; nNonOrthogonalCorrectors 0; }}
relaxationFactors {{ equations {{ ".*" 1; }} }}""")
    write(folder, "system/fvSchemes", "dictionary", """
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes { div(rhoPhi,U) Gauss linearUpwind grad(U); div(phi,alpha) Gauss vanLeer;
  div(phirb,alpha) Gauss linear; div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }""")
    write(folder, "constant/turbulenceProperties", "dictionary", "simulationType laminar;")


def write_control(folder, options, functions, step):
    write(folder, "system/controlDict", "dictionary", f"""
application {options.solver}; startFrom startTime; startTime 0; stopAt endTime; endTime {options.end};
deltaT 0.0005; writeControl adjustableRunTime; writeInterval {options.end}; purgeWrite 1;
writeFormat ascii; writePrecision 8; timePrecision 8; runTimeModifiable no; adjustTimeStep yes;
maxCo {options.co}; maxAlphaCo {options.co}; maxDeltaT {step};
functions {{ {functions} }}""")


def probes(name, field, points, control, kind="probes", extra=""):
    """`points`: (x, y) in the middle of a layer of cells, or (x, y, z)."""
    places = " ".join("(%.9g %.9g %.9g)" % (*place, THICKNESS / 2)[:3] for place in points)
    return (f"{name} {{ type {kind}; libs (sampling); fields ({field}); {extra} {control} "
            f"probeLocations ( {places} ); }}\n")


def write_field(folder, name, kind, dimensions, inside, patches):
    write(folder, "0/" + name, kind, f"dimensions {dimensions}; internalField {inside}; boundaryField {{ "
          + " ".join(f"{patch} {{ type {text} }}" for patch, text in patches.items()) + " }")


def write_water_and_air(folder, gravity):
    write(folder, "constant/transportProperties", "dictionary", """
phases (water air); water { transportModel Newtonian; nu 1.01e-06; rho 1000; }
air { transportModel Newtonian; nu 1.48e-05; rho 1; } sigma 0;""")
    write(folder, "constant/g", "uniformDimensionedVectorField",
          f"dimensions [0 1 -2 0 0 0 0]; value {gravity};")


def write_dam_break_fields(folder, walls):
    """`walls(text, top)`: {patch: text} for slip walls and the open top."""
    write_field(folder, "alpha.water", "volScalarField", "[0 0 0 0 0 0 0]", "uniform 0",
                walls("zeroGradient;", "inletOutlet; inletValue uniform 0; value uniform 0;"))
    write_field(folder, "U", "volVectorField", "[0 1 -1 0 0 0 0]", "uniform (0 0 0)",
                walls("slip;", "pressureInletOutletVelocity; value uniform (0 0 0);"))
    write_field(folder, "p_rgh", "volScalarField", "[1 -1 -2 0 0 0 0]", "uniform 0",
                walls("fixedFluxPressure; value uniform 0;", "totalPressure; p0 uniform 0;"))


def make_dam_break(folder, options):
    left, right = round(COLUMN_WIDTH / options.h), round((LENGTH - COLUMN_WIDTH) / options.h)
    up = round(HEIGHT / options.h)
    xs = middles(0, COLUMN_WIDTH, left) + middles(COLUMN_WIDTH, LENGTH, right)
    ys = middles(0, HEIGHT, up)
    vertices = "".join(f"({x} {y} {z})\n" for z in (0, THICKNESS) for y in (0, HEIGHT)
                       for x in (0, COLUMN_WIDTH, LENGTH))
    write(folder, "system/blockMeshDict", "dictionary", f"""
vertices ( {vertices} );
blocks ( hex (0 1 4 3 6 7 10 9) ({left} {up} 1) simpleGrading (1 1 1)
         hex (1 2 5 4 7 8 11 10) ({right} {up} 1) simpleGrading (1 1 1) );
edges ();
boundary (
 left {{ type wall; faces ((0 6 9 3)); }} right {{ type wall; faces ((2 5 11 8)); }}
 bottom {{ type wall; faces ((0 1 7 6) (1 2 8 7)); }} top {{ type patch; faces ((3 9 10 4) (4 10 11 5)); }}
 frontAndBack {{ type empty; faces ((0 3 4 1) (1 4 5 2) (6 7 10 9) (7 8 11 10)); }} );""")
    each_step = "writeControl timeStep; writeInterval 1;"
    write_control(folder, options, probes("bottom", "alpha.water", [(x, FRONT_HEIGHT) for x in xs], each_step,
                                          extra="interpolationScheme cellPoint;")
                  + probes("column", "alpha.water", [(xs[0], y) for y in ys], each_step), 0.01)
    write(folder, "system/setFieldsDict", "dictionary", f"""
defaultFieldValues ( volScalarFieldValue alpha.water 0 );
regions ( boxToCell {{ box (-1 -1 -1) ({COLUMN_WIDTH} {COLUMN_HEIGHT} 1);
  fieldValues ( volScalarFieldValue alpha.water 1 ); }} );""")
    write_water_and_air(folder, f"(0 {-GRAVITY} 0)")

    def walls(text, top):
        return {"left": text, "right": text, "bottom": text, "top": top, "frontAndBack": "empty;"}

    write_dam_break_fields(folder, walls)
    return xs, ys


def make_patch(folder, options):
    n = 2 * round(HALF_BOX / options.h)
    h = 2 * HALF_BOX / n
    vertices = "".join(f"({x} {y} {z})\n" for z in (0, THICKNESS) for y in (-HALF_BOX, HALF_BOX)
                       for x in (-HALF_BOX, HALF_BOX))
    write(folder, "system/blockMeshDict", "dictionary", f"""
vertices ( {vertices} ); blocks ( hex (0 1 3 2 4 5 7 6) ({n} {n} 1) simpleGrading (1 1 1) ); edges ();
boundary ( outer {{ type patch; faces ((0 4 6 2) (1 3 7 5) (0 1 5 4) (2 6 7 3)); }}
 frontAndBack {{ type empty; faces ((0 2 3 1) (4 5 7 6)); }} );""")
    write_control(folder, options, probes("centre", "p", [(0, 0)], "writeControl timeStep; writeInterval 1;",
                                          extra="interpolationScheme cellPoint;"), 0.02)
    write(folder, "constant/transportProperties", "dictionary", f"""
phases (water air); water {{ transportModel Newtonian; nu 0; rho 1; }}
air {{ transportModel Newtonian; nu 1e-5; rho {AIR}; }} sigma 0;""")
    write(folder, "constant/g", "uniformDimensionedVectorField",
          "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);")
    c = middles(-HALF_BOX, HALF_BOX, n)

    def share(s):  # of the cell around s that the patch covers
        return max(0.0, min(1.0, (min(s + h / 2, 0.5) - max(s - h / 2, -0.5)) / h))

    cells = [(x, y, share(x) * share(y)) for y in c for x in c]
    alpha = "\n".join("%.8g" % a for _, _, a in cells)
    velocity = "\n".join("(%.8g %.8g 0)" % ((y, -x) if a > 0 else (0, 0)) for x, y, a in cells)
    write_field(folder, "alpha.water", "volScalarField", "[0 0 0 0 0 0 0]",
                f"nonuniform List<scalar> {n * n} (\n{alpha}\n)",
                {"outer": "inletOutlet; inletValue uniform 0; value uniform 0;", "frontAndBack": "empty;"})
    write_field(folder, "U", "volVectorField", "[0 1 -1 0 0 0 0]",
                f"nonuniform List<vector> {n * n} (\n{velocity}\n)",
                {"outer": "pressureInletOutletVelocity; value uniform (0 0 0);", "frontAndBack": "empty;"})
    write_field(folder, "p_rgh", "volScalarField", "[1 -1 -2 0 0 0 0]", "uniform 0",
                {"outer": "totalPressure; p0 uniform 0;", "frontAndBack": "empty;"})


def table(folder, name, field):
    """Rows of numbers that a function object wrote."""
    base = os.path.join(folder, "postProcessing", name)
    path = os.path.join(base, sorted(os.listdir(base))[0], field)
    with open(path, encoding="utf-8") as file:
        return [[float(word) for word in line.split()] for line in file if not line.startswith("#")]


def crossing(x, values, last):
    """Where the volume fraction falls through 0.5, first or last time."""
    places = [i for i in range(len(x) - 1) if values[i] >= 0.5 > values[i + 1]]
    if last and values[-1] >= 0.5:
        return x[-1] + (x[-1] - x[-2]) / 2
    if not places:
        return 0.0
    i = places[-1 if last else 0]
    return x[i] + (values[i] - 0.5) / (values[i] - values[i + 1]) * (x[i + 1] - x[i])


def version():
    package = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", "openfoam"],
                             capture_output=True, text=True).stdout
    return "OpenFOAM " + (re.match(r"[\d.]*", package).group(0) or "?")


def run(arguments, folder, measured, write_curves):
    import openfoam_marin
    import openfoam_waves

    options = parse(arguments)
    case = tempfile.mkdtemp(prefix="openfoam-")  # it takes no spaces in paths
    write_numerics(case, options)
    environment = "export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}; "
    prepare = "blockMesh"
    if options.scene == "dam_break":
        xs, ys = make_dam_break(case, options)
        prepare += " && setFields"
    elif options.scene == "marin":
        openfoam_marin.make(case, options)
        prepare += " && setFields"
    elif options.scene == "wave":
        openfoam_waves.make(case, options)
    else:
        make_patch(case, options)
    measured(["sh", "-c", environment + prepare], case)
    wall, cpu = measured(["sh", "-c", environment + "exec " + options.solver], case)
    with open(os.path.join(case, "output.txt"), encoding="utf-8") as file:
        steps = sum(line.startswith("Time = ") for line in file)
    if options.scene == "dam_break":
        bottom, column = table(case, "bottom", "alpha.water"), table(case, "column", "alpha.water")
        write_curves(folder, {"t": [row[0] for row in bottom],
                              "front": [crossing(xs, row[1:], True) for row in bottom],
                              "height": [crossing(ys, row[1:], False) for row in column]})
    elif options.scene == "marin":
        write_curves(folder, openfoam_marin.curves(case, options))
    elif options.scene == "wave":
        write_curves(folder, openfoam_waves.curves(case, options))
    else:
        rows = table(case, "centre", "p")
        time = [row[0] for row in rows]
        write_curves(folder, {"t": time, "t_pressure": time, "p_centre": [row[1] for row in rows]})
    shutil.rmtree(case)
    return {"version": version(), "wall_seconds": wall, "cpu_seconds": cpu, "steps": steps,
            "seconds_a_step": cpu / steps, "start_seconds": None}
