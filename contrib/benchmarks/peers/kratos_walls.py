# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kratos' material point application on the dam break of
prm/verification/aligned_dam_break.prm, or with --walls on that of
turned_dam_break.prm: the tank, its water and gravity turned by 30 degrees
against the grid, and slip walls imposed at points (its non-conforming
conditions). Records energies in the frame of the tank, and what has left it.
"""

import argparse
import os

import KratosMultiphysics.MPMApplication as KMPM
import numpy as np
from kratos_mpm import Timed, box_mesh, write_case

TANK, HEIGHT, GRAVITY = np.array([1.6, 1.8]), 0.6, 9.81
GRID = np.array([-1.0, -0.1]), [2.5, 2.55]  # around the turned tank: lower corner, size
ANGLE = np.radians(30)
TURN = np.array([[np.cos(ANGLE), -np.sin(ANGLE)], [np.sin(ANGLE), np.cos(ANGLE)]])
LARGEST_ENERGY = 2000  # [J], about twice what the column has above the floor
RECORDED = 0.01  # [s] between two records


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--h", type=float, default=0.05, help="cell size [m]")
    parser.add_argument("--points", type=int, default=16, help="a cell")
    parser.add_argument("--dt", type=float, default=0.001, help="[s]")
    parser.add_argument("--end", type=float, default=0.9, help="[s]")
    parser.add_argument("--kappa", type=float, default=1e5, help="bulk modulus [Pa]")
    parser.add_argument("--column", type=float, default=0.6, help="width of the water [m]; 1.6: at rest")
    parser.add_argument("--walls", choices=("penalty", "lagrange", "perturbed_lagrange"),
                        help="how walls are imposed in the turned tank; default: tank along the grid")
    parser.add_argument("--penalty", type=float, default=1e10, help="factor of penalty and perturbation")
    parser.add_argument("--contact", action="store_true", help="walls that push and do not pull")
    parser.add_argument("--wall-points", type=int, default=1, help="of the wall, on each of its pieces")
    parser.add_argument("--pieces", type=float, default=4, help="of the wall, on a cell size")
    parser.add_argument("--scheme", choices=("newmark", "bossak"), default="newmark")
    parser.add_argument("--output", required=True)
    options = parser.parse_args()
    options.dim, options.amgcl = 2, False
    options.steps = round(options.end / options.dt)
    return options


def turned(mesh):
    nodes, cells = mesh
    return np.column_stack([nodes[:, :2] @ TURN.T, nodes[:, 2]]), cells


def append_walls(path, first, size):
    """The tank's sides as a closed line of pieces, clockwise, so that normals point
    into the water: nodes from number `first` on and conditions, added to the file
    of the grid."""
    corners = np.array([[0, 0], [0, 1], [1, 1], [1, 0]]) * TANK
    pieces = np.rint(np.array([TANK[1], TANK[0]] * 2) / size).astype(int)
    nodes = np.concatenate([a + (b - a) * np.linspace(0, 1, n, endpoint=False)[:, None]
                            for a, b, n in zip(corners, np.roll(corners, -1, 0), pieces)]) @ TURN.T
    count = range(len(nodes))
    lines = ["Begin Nodes", *("%d %.12g %.12g 0" % (first + i, *nodes[i]) for i in count), "End Nodes",
             "Begin Conditions LineCondition2D2N",
             *("%d 0 %d %d" % (i + 1, first + i, first + (i + 1) % len(nodes)) for i in count),
             "End Conditions", "Begin SubModelPart Tank", "Begin SubModelPartNodes",
             *(str(first + i) for i in count), "End SubModelPartNodes", "Begin SubModelPartConditions",
             *(str(i + 1) for i in count), "End SubModelPartConditions", "End SubModelPart"]
    with open(path, "a", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def walls_process(options):
    return {"python_module": "apply_mpm_particle_dirichlet_condition_process",
            "kratos_module": "KratosMultiphysics.MPMApplication",
            "process_name": "ApplyMPMParticleDirichletConditionProcess",
            "Parameters": {"model_part_name": "Background_Grid.Tank", "imposition_type": options.walls,
                           "material_points_per_condition": options.wall_points,
                           "penalty_coefficient": 0.0 if options.walls == "lagrange" else options.penalty,
                           "constrained": "contact_slip" if options.contact else "slip",
                           "value": [0.0, 0.0, 0.0]}}


def write_scene(options):
    body = box_mesh([options.column, HEIGHT], options.h)
    if not options.walls:
        return write_case(options, body, box_mesh(TANK, options.h), [0.0, -1.0, 0.0])
    nodes, cells = box_mesh(GRID[1], options.h)
    grid = nodes + np.append(GRID[0], 0), cells
    parameters = write_case(options, turned(body), grid, [*(TURN @ [0.0, -1.0]), 0.0])
    append_walls(os.path.join(options.output, "case_Grid.mdpa"), len(nodes) + len(body[0]) + 1,
                 options.h / options.pieces)
    parameters["processes"]["list_other_processes"].append(walls_process(options))
    parameters["solver_settings"]["auxiliary_variables_list"].append("NODAL_AREA")
    return parameters


class Recorded(Timed):
    """Every RECORDED seconds: energies, and how far points are beyond the walls."""

    def __init__(self, options):
        self.options, self.rows, self.unconverged = options, [], 0
        self.frame = TURN if options.walls else np.eye(2)
        parameters = write_scene(options)
        parameters["solver_settings"].update(max_iteration=20, scheme_type=options.scheme)
        super().__init__(parameters)

    def not_converged(self):
        """Goes on, as their own analysis does."""
        self.unconverged += 1

    def RunSolutionLoop(self):
        self.record()
        super().RunSolutionLoop()

    def after_step(self):
        if len(self.seconds) % round(RECORDED / self.options.dt) == 0:
            self.record()

    def record(self):
        part = self.model["MPM_Material"]
        place, speed, mass = (
            np.array([np.ravel(p.CalculateOnIntegrationPoints(variable, part.ProcessInfo)[0])
                      for p in part.Elements])
            for variable in (KMPM.MP_COORD, KMPM.MP_VELOCITY, KMPM.MP_MASS))
        place, speed = place[:, :2] @ self.frame, speed[:, :2]
        beyond = np.max(np.maximum(-place, place - TANK), 1)
        self.rows.append([self.time, 0.5 * float(mass[:, 0] @ (speed**2).sum(1)),
                          GRAVITY * float(mass[:, 0] @ place[:, 1]), len(place),
                          int((beyond > 0.1 * self.options.h).sum()), beyond.max(), self.unconverged])
        if not self.rows[-1][1] < LARGEST_ENERGY:
            raise SystemExit(f"more energy than there is, at {self.time:.2f} s")

    def write_curves(self, folder):
        with open(os.path.join(folder, "curves.csv"), "w", encoding="utf-8") as file:
            file.write("t,kinetic,potential,points,outside,beyond,unconverged\n")
            file.writelines(",".join("%.9g" % value for value in row) + "\n" for row in self.rows)


def main():
    options = parse()
    run = Recorded(options)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # four warnings a step for each dry point of the walls
    try:
        run.Run()
    finally:
        run.write_curves(options.output)
    run.write_result(options.output)


if __name__ == "__main__":
    main()
