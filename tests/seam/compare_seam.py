#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A flow in a periodic domain does not depend on where the seam is.

compare_seam.py SEICHE MPIRUN CASE [--ranks N]

The scene of the case runs twice, the second time with the grid's corners (and
the bodies that it takes along) moved by some cells, so that the seam is
elsewhere in the fluid; on N ranks the second time. All columns of
statistics.csv agree to 1e-9 of the column's largest value (momenta: of
that at 1 m/s; 1e-8 where points carry an acceleration, whose round-off grows), but
for iteration counts and moments, which depend on the origin.
"""
import pathlib
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "ranks"))
from compare_ranks import SCALES, difference, run  # noqa: E402

# fills are rounded to 1e-10 (doc/theory.md, section 5), and round-off may flip the
# last digit of one
TOLERANCE = 1e-9
WITH_ACCELERATION = 1e-8
# orthogonal subscales keep what the solves of the first iterations have left, 1e-6
# of an update, in their projection, which the later ones do not change any more
WITH_PROJECTION = 1e-7
NOT_COMPARED = ("iterations", "angular momentum", "moment ")
TIGHT = ["Output/Interval = 0",
         "Solver/Newton tolerance = 1e-13",
         "Solver/Newton absolute tolerance = 1e-14",
         "Solver/Linear tolerance = 1e-13",
         "Solver/Projection tolerance = 1e-14"]


def moved(lower, upper):
    return [f"Grid/Lower corner = {lower}", f"Grid/Upper corner = {upper}"]


BLOCK_MOVED = moved("0.6, 0", "2.2, 1") + [
    "Fluid body west/Lower corner = 1.9, 0.1",
    "Fluid body west/Upper corner = 2.2, 0.6"]
VORTICES_MOVED = moved("1.6, 0.8", "8, 7.2") + [
    "Fluid body vortices/Lower corner = 1.6, 0.8",
    "Fluid body vortices/Upper corner = 8, 7.2"]
BLOCK_3D_MOVED = moved("0.4, 0.4, 0", "1.6, 1.6, 0.8") + [
    "Fluid body pool/Lower corner = 0.4, 0.4, 0",
    "Fluid body pool/Upper corner = 1.6, 1.6, 0.2"]

# scene, settings of both runs, settings of the second one
CASES = {
    "vortices": ("vortices_2d", [], VORTICES_MOVED),
    "vortices_quadratic": ("vortices_2d", ["Formulation/Element degree = 2"],
                           VORTICES_MOVED),
    "vortices_controlled": ("vortices_2d",
                            ["Points/Shifting sweeps = 1",
                             "Points/Reseeding = true"], VORTICES_MOVED),
    "block": ("block_2d", [], BLOCK_MOVED),
    "block_contact": ("block_2d", ["Walls/Contact = unilateral"], BLOCK_MOVED),
    "block_material_points": ("block_2d",
                              ["Quadrature/Rule = material points"],
                              BLOCK_MOVED),
    "block_osgs": ("block_2d", ["Formulation/Stabilization = OSGS"],
                   BLOCK_MOVED),
    "block_apic": ("block_2d", ["Transfer/Method = APIC"], BLOCK_MOVED),
    # schemes whose points carry an acceleration, other walls that hold the water
    "block_newmark": ("block_2d", ["Time/Scheme = newmark",
                                   "Walls/Bottom = no-slip"], BLOCK_MOVED),
    "block_bossak": ("block_2d", ["Time/Scheme = bossak",
                                  "Walls/Bottom = no-slip",
                                  "Fluid/Dynamic viscosity = 10"], BLOCK_MOVED),
    "block_3d_bossak": ("block_3d", ["Time/Scheme = bossak",
                                     "Walls/Bottom = no-slip",
                                     "Time/End time = 0.04"], BLOCK_3D_MOVED),
    "block_adaptive": ("block_adaptive_2d", [], BLOCK_MOVED),
    "block_adaptive_quadratic": ("block_adaptive_2d",
                                 ["Formulation/Element degree = 2",
                                  "Points/Per cell and direction = 4"],
                                 BLOCK_MOVED),
    "block_3d": ("block_3d", [], BLOCK_3D_MOVED),
    "block_3d_quadratic": ("block_3d", ["Formulation/Element degree = 2",
                                        "Points/Per cell and direction = 3",
                                        "Time/End time = 0.02"],
                           BLOCK_3D_MOVED),
}


def options(settings):
    return [text for setting in settings for text in ("--set", setting)]


def main():
    seiche, mpirun, case = sys.argv[1:4]
    ranks = sys.argv[5] if sys.argv[4:5] == ["--ranks"] else "1"
    scene, both, second = CASES[case]
    scene = str(HERE / f"{scene}.prm")
    with tempfile.TemporaryDirectory() as folder:
        one = run(seiche, [], scene, options(TIGHT + both), f"{folder}/1")
        launcher = [mpirun, "-n", ranks] if ranks != "1" else []
        two = run(seiche, launcher, scene, options(TIGHT + both + second),
                  f"{folder}/2")
    SCALES.update({"overfull_fraction": None, "splitting momentum": "mass [kg]",
                   "merging momentum": "mass [kg]",
                   "shifting momentum": "mass [kg]"})
    errors = {name: difference(name, one, two) for name in one
              if not any(part in name for part in NOT_COMPARED)}
    carries = any("Time/Scheme" in setting for setting in both)
    projects = any("OSGS" in setting for setting in both)
    tolerance = WITH_ACCELERATION if carries else WITH_PROJECTION if projects else TOLERANCE
    failed = {name: error for name, error in errors.items()
              if not error <= tolerance}
    print(f"{len(errors)} columns, {len(one['time [s]'])} rows, largest "
          f"difference {max(errors.values()):.1e}")
    for name, error in failed.items():
        print(f"FAILED {name}: {error:.1e} > {tolerance:g}")
    return 1 if failed or not errors else 0


if __name__ == "__main__":
    sys.exit(main())
