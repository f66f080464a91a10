# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kratos' material point application (irreducible form, Newmark) on our dam break
or, with --dim 3, our collapsing column: writes the input, takes some steps and
times them. Runs in Kratos' own Python environment (peers/install).

Release 10.4.4 has no mixed form for Newtonian fluids; only the irreducible one
can be compared.
"""

import argparse
import json
import os
import time

import KratosMultiphysics as KM
import KratosMultiphysics.LinearSolversApplication  # noqa: F401, registers solvers
import KratosMultiphysics.MPMApplication  # noqa: F401, registers elements
import numpy as np
from KratosMultiphysics.MPMApplication.mpm_analysis import MpmAnalysis

PROCESS = {"python_module": "assign_vector_variable_process", "kratos_module": "KratosMultiphysics",
           "process_name": "AssignVectorVariableProcess"}


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--dim", type=int, default=2, choices=(2, 3))
    parser.add_argument("--h", type=float, required=True, help="cell size [m]")
    parser.add_argument("--points", type=int, required=True, help="a cell")
    parser.add_argument("--steps", type=int, required=True)
    parser.add_argument("--dt", type=float, default=0.001, help="[s]")
    parser.add_argument("--kappa", type=float, default=1e5, help="bulk modulus [Pa]")
    parser.add_argument("--amgcl", action="store_true", help="iterative instead of sparse direct")
    parser.add_argument("--output", required=True)
    return parser.parse_args()


def box_mesh(size, h):
    """Nodes (n x 3) and cells (m x 2^dim) of a box from the origin, cells near to h."""
    dim = len(size)
    n = np.rint(np.asarray(size) / h).astype(int)
    axes = [np.linspace(0, size[d], n[d] + 1) for d in range(dim)]
    nodes = np.column_stack([g.ravel() for g in np.meshgrid(*axes, indexing="ij")])
    number = np.arange(len(nodes)).reshape(n + 1)
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    if dim == 3:
        corners = [c + (z,) for z in (0, 1) for c in corners]
    cells = [number[tuple(slice(c[d], n[d] + c[d]) for d in range(dim))] for c in corners]
    if dim == 2:
        nodes = np.column_stack([nodes, np.zeros(len(nodes))])
    return nodes, np.stack(cells, -1).reshape(-1, len(corners))


def write_mesh(path, mesh, element, part, first, sets):
    """An .mdpa file; `first`: numbers of the first node and element."""
    nodes, cells = mesh
    node, cell = first
    lines = ["Begin ModelPartData", "End ModelPartData", "Begin Properties 0", "End Properties",
             "Begin Nodes"]
    lines += ["%d %.12g %.12g %.12g" % (i + node, *x) for i, x in enumerate(nodes)]
    lines += ["End Nodes", "Begin Elements " + element]
    lines += ["%d 0 %s" % (i + cell, " ".join(str(v + node) for v in c)) for i, c in enumerate(cells)]
    lines += ["End Elements"]
    parts = {part: (range(len(nodes)), range(len(cells))), **{k: (v, []) for k, v in sets.items()}}
    for name, (of_nodes, of_cells) in parts.items():
        lines += ["Begin SubModelPart " + name, "Begin SubModelPartNodes",
                  *(str(i + node) for i in of_nodes), "End SubModelPartNodes",
                  "Begin SubModelPartElements", *(str(i + cell) for i in of_cells),
                  "End SubModelPartElements", "End SubModelPart"]
    with open(path + ".mdpa", "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def walls_of(grid, dim):
    """The nodes on the sides of a grid, by axis."""
    low, high = grid[0].min(0), grid[0].max(0)
    return {"WALL_" + "XYZ"[d]: np.where(np.minimum(grid[0][:, d] - low[d], high[d] - grid[0][:, d]) < 1e-9)[0]
            for d in range(dim)}


def write_case(options, body, grid, down):
    """The input files of the mesh `body`, which gets the points, in the mesh `grid`
    with walls at its sides and gravity along `down`; the project parameters."""
    dim = options.dim
    base = os.path.join(options.output, "case")
    walls = walls_of(grid, dim)
    kind = "2D4N" if dim == 2 else "3D8N"
    write_mesh(base + "_Grid", grid, "Element" + kind, "Grid", (1, 1), walls)
    write_mesh(base + "_Body", body, "MPMUpdatedLagrangian" + kind, "Parts",
               (len(grid[0]) + 1, len(grid[1]) + 1), {})
    law = "DispNewtonianFluidPlaneStrain2DLaw" if dim == 2 else "DispNewtonianFluid3DLaw"
    variables = {"THICKNESS": 1.0, "MATERIAL_POINTS_PER_ELEMENT": options.points, "DENSITY": 1000.0,
                 "BULK_MODULUS": options.kappa, "DYNAMIC_VISCOSITY": 0.00101}
    with open(base + "_Materials.json", "w", encoding="utf-8") as file:
        json.dump({"properties": [{"model_part_name": "Initial_MPM_Material.Parts", "properties_id": 1,
                                   "Material": {"constitutive_law": {"name": law},
                                                "Variables": variables, "Tables": {}}}]}, file)
    constraints = [{**PROCESS, "Parameters": {
        "model_part_name": "Background_Grid." + name, "variable_name": "DISPLACEMENT",
        "interval": [0.0, "End"], "constrained": [i == d for i in range(3)],
        "value": [0.0 if i == d else None for i in range(3)]}}
        for name, d in [*((n, "XYZ".index(n[-1])) for n in walls), *([("Grid", 2)] if dim == 2 else [])]]
    amgcl = {"solver_type": "amgcl", "smoother_type": "damped_jacobi", "krylov_type": "cg",
             "coarsening_type": "aggregation", "max_iteration": 200, "tolerance": 1e-7,
             "gmres_krylov_space_dimension": 100, "coarse_enough": 50}
    return {
        "problem_data": {"problem_name": "case", "parallel_type": "OpenMP", "echo_level": 0,
                         "start_time": 0.0, "end_time": (options.steps - 0.5) * options.dt},
        "solver_settings": {
            "solver_type": "Dynamic", "model_part_name": "MPM_Material", "domain_size": dim,
            "echo_level": 0, "analysis_type": "non_linear", "time_integration_method": "implicit",
            "scheme_type": "newmark",
            "model_import_settings": {"input_type": "mdpa", "input_filename": base + "_Body"},
            "grid_model_import_settings": {"input_type": "mdpa", "input_filename": base + "_Grid"},
            "material_import_settings": {"materials_filename": base + "_Materials.json"},
            "time_stepping": {"time_step": options.dt}, "convergence_criterion": "residual_criterion",
            "displacement_relative_tolerance": 1e-4, "displacement_absolute_tolerance": 1e-9,
            "residual_relative_tolerance": 1e-4, "residual_absolute_tolerance": 1e-9,
            "max_iteration": 10, "pressure_dofs": False, "consistent_mass_matrix": False,
            "linear_solver_settings": amgcl if options.amgcl
            else {"solver_type": "LinearSolversApplication.sparse_lu"},
            "auxiliary_variables_list": ["NORMAL", "IS_STRUCTURE"]},
        "processes": {
            "constraints_process_list": constraints, "loads_process_list": [],
            "list_other_processes": [], "gravity": [{
                "python_module": "assign_gravity_to_material_point_process",
                "kratos_module": "KratosMultiphysics.MPMApplication",
                "process_name": "AssignGravityToMaterialPointProcess",
                "Parameters": {"model_part_name": "MPM_Material", "modulus": 9.81,
                               "direction": list(down)}}]},
        "output_processes": {}, "analysis_stage": "KratosMultiphysics.MPMApplication.mpm_analysis"}


class Timed(MpmAnalysis):
    """Their analysis; processor time and Newton iterations of each step."""

    def __init__(self, parameters):
        KM.Logger.GetDefaultOutput().SetSeverity(KM.Logger.Severity.WARNING)
        self.seconds, self.iterations = [], []
        super().__init__(KM.Model(), KM.Parameters(json.dumps(parameters)))

    def RunSolutionLoop(self):
        self.start = time.process_time()
        solver, info = self._GetSolver(), self.model["MPM_Material"].ProcessInfo
        while self.KeepAdvancingSolutionLoop():
            begin = time.process_time()
            self.time = solver.AdvanceInTime(self.time)
            self.InitializeSolutionStep()
            solver.Predict()
            if not solver.SolveSolutionStep():
                self.not_converged()
            self.FinalizeSolutionStep()
            self.seconds.append(time.process_time() - begin)
            self.iterations.append(int(info[KM.NL_ITERATION_NUMBER]))
            self.after_step()

    def not_converged(self):
        raise SystemExit("a step did not converge")

    def after_step(self):
        """For what is recorded; not timed."""

    def write_result(self, folder):
        steps = len(self.seconds)
        version = KM.KratosGlobals.Kernel.Version().split("-")[0].replace('"', "")
        with open(os.path.join(folder, "kratos.json"), "w", encoding="utf-8") as file:
            json.dump({"version": "Kratos " + version, "steps": steps,
                       "seconds_a_step": sum(self.seconds) / steps, "start_seconds": self.start,
                       "newton": sum(self.iterations) / steps,
                       "points": self.model["MPM_Material"].NumberOfElements()}, file, indent=1)


def main():
    options = parse()
    dim = options.dim
    tank, column = ([3.22, 2.0], [1.2, 0.6]) if dim == 2 else ([1.6, 0.4, 0.8], [0.4, 0.4, 0.4])
    run = Timed(write_case(options, box_mesh(column, options.h), box_mesh(tank, options.h),
                           [-float(i == dim - 1) for i in range(3)]))
    run.Run()
    run.write_result(options.output)


if __name__ == "__main__":
    main()
