#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same numbers on 1, 2, 3 and 4 ranks, with tight solves (ranks/compare_ranks.py).

ranks.py SEICHE MPIRUN
"""
import sys

from harness import ROOT, Account, amount, arguments, run, scratch

sys.path.insert(0, str(ROOT / "tests/ranks"))
from compare_ranks import TOLERANCE, difference, read_columns  # noqa: E402

TIGHT = ["Output/Interval = 0", "Solver/Linear solver = iterative",
         "Solver/Newton tolerance = 1e-12", "Solver/Newton absolute tolerance = 1e-13",
         "Solver/Linear tolerance = 1e-12", "Solver/Projection tolerance = 1e-13",
         "Solver/Linear maximum iterations = 400"]
SCENES = {  # end times: of the sample, of night and release; several adaptations each
    "tests/scene/dam_break_adaptive.prm": (0.06, 0.2),
    "tests/scene/box_3d_adaptive.prm": (None, None)}


def worst_difference(one, other):
    return max((difference(name, one, other), name) for name in one
               if "iterations" not in name)


def main():
    options = arguments(__doc__)
    account = Account("ranks")
    n_scenes = amount("rank_scenes")
    with scratch() as folder:
        for scene, end_times in list(SCENES.items())[:n_scenes]:
            end_time = end_times[n_scenes > 1]
            settings = TIGHT + ([] if end_time is None else [f"Time/End time = {end_time}"])
            one = None
            for ranks in (1, 2, 3, 4):
                out = f"{folder}/{ranks}"
                command = [options.mpirun, "-n", ranks] if ranks > 1 else []
                command += [options.seiche, ROOT / scene, "--output", out]
                for setting in settings:
                    command += ["--set", setting]
                outcome = run(command, seconds=600)
                problem = ""
                if outcome.code == 0:
                    columns = read_columns(out)
                    one = one or columns
                    error, name = worst_difference(one, columns)
                    if not error <= TOLERANCE:
                        problem = f"{name}: {error:.1e} > {TOLERANCE:g}"
                    print(f"    {scene}, {ranks} ranks: {len(columns['time [s]'])} rows, "
                          f"differences {error:.1e}")
                account.add(f"{scene}, {ranks} ranks", outcome, {0}, problem)
    return account.verdict("runs on 1 to 4 ranks")


if __name__ == "__main__":
    raise SystemExit(main())
