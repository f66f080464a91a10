#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a small scene with each multigrid for the Schur complement.

    compare_multigrids.py PROGRAM MPIEXEC SCENE N_DIFFERENT

The scene asks for tight tolerances. The scores and the energy at the end must
be those of the default to 1e-6, on 1 and on 2 ranks. On one rank there must be
at least N_DIFFERENT numbers of Krylov iterations: a choice that is not used, because the
system is small or because another is taken, gives the same one as another.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

NAMES = ["automatic", "BoomerAMG", "ML"]
TOLERANCE = 1e-6


def run(command, scene, name, ranks, folder):
    subprocess.run(
        command + [scene, "--output", folder,
                   "--set", "Solver/Linear solver = iterative",
                   "--set", f"Solver/Multigrid = {name}",
                   "--set", "Output/Test log = false",
                   "--set", "Output/Interval = 0"],
        check=True, stdout=subprocess.DEVNULL)
    summary = json.loads(pathlib.Path(folder, "summary.json").read_text())
    assert summary["ranks"] == ranks, summary["ranks"]
    values = dict(summary["errors"],
                  energy=summary["ledger"]["energy_final"])
    return values, summary["krylov_iterations"]


def main():
    program, mpiexec, scene, n_different = sys.argv[1:]
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        reference, iterations = None, {}
        for ranks in (1, 2):
            command = [program] if ranks == 1 else \
                [mpiexec, "-n", str(ranks), program]
            for name in NAMES:
                values, krylov = run(command, scene, name, ranks,
                                     f"{folder}/{name}{ranks}")
                reference = reference or values
                print(f"{name}, {ranks} ranks: {krylov} Krylov iterations")
                for key, value in values.items():
                    if abs(value - reference[key]) > \
                            TOLERANCE * max(1., abs(reference[key])):
                        failures.append(f"{name}, {ranks} ranks: {key} is "
                                        f"{value}, not {reference[key]}")
                iterations[name, ranks] = krylov
        found = len({iterations[name, 1] for name in NAMES})
        if found < int(n_different):
            failures.append(f"{found} different numbers of iterations, not at least "
                            f"{n_different}")
    for failure in failures:
        print("FAILED:", failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
