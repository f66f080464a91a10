#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same numbers on 1, 2, 3 and 4 ranks: ranks/compare_ranks.py with tight solves.

ranks.py SEICHE MPIRUN
"""
import subprocess
import sys

from harness import ROOT, amount, arguments

TIGHT = ["Output/Interval = 0", "Solver/Linear solver = iterative",
         "Solver/Newton tolerance = 1e-12", "Solver/Newton absolute tolerance = 1e-13",
         "Solver/Linear tolerance = 1e-12", "Solver/Projection tolerance = 1e-13",
         "Solver/Linear maximum iterations = 400"]
SCENES = {"tests/scene/dam_break_adaptive.prm": ["Time/End time = 0.2"],
          "tests/scene/box_3d_adaptive.prm": []}


def main():
    options = arguments(__doc__)
    failed = pairs = 0
    for scene, settings in list(SCENES.items())[:amount("rank_scenes")]:
        for ranks in (2, 3, 4):
            command = [sys.executable, ROOT / "tests/ranks/compare_ranks.py", options.seiche,
                       options.mpirun, ROOT / scene, "--ranks", str(ranks)]
            for setting in TIGHT + settings:
                command += ["--set", setting]
            print(f"{scene}, 1 and {ranks} ranks: ", end="", flush=True)
            failed += subprocess.run(command, check=False).returncode != 0
            pairs += 1
    print(f"ranks: {pairs} pairs of runs; {failed} not as they should be")
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
