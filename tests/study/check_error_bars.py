#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error bars of contrib/study: companion runs, estimators, tables.

check_error_bars.py SEICHE CASE
"""
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "contrib"))
from seiche_study import Study, StudyError  # noqa: E402
from seiche_study_bands import grid_uncertainty, observed_order, spread  # noqa: E402
from seiche_study_companions import ErrorBars, scaled  # noqa: E402

TINY = HERE / "error_bars.toml"


def run(seiche, folder, *arguments, file=TINY, code=0):
    process = subprocess.run(
        [sys.executable, str(ROOT / "contrib/study"), str(file), "--program", seiche,
         "--output", folder, "--jobs", "1", *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=100)
    assert process.returncode == code, f"exit code {process.returncode}:\n{process.stdout}"
    return process.stdout


def read_table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def close(a, b, tolerance=1e-9):
    return abs(a - b) <= tolerance * max(abs(a), abs(b), 1e-300)


def estimators(_, __):
    """Sequences whose limit is known."""
    for sizes in ([1, 2, 4], [1, 1.5, 3.3]):
        for order in (0.6, 1.0):
            values = [3 - 0.2 * h ** order for h in sizes]
            found, method, width = grid_uncertainty(values, sizes)
            assert close(found, order, 1e-6) and method == "GCI 1.25", (found, method)
            assert close(width, 1.25 * 0.2, 1e-6), width  # 1.25 times the error at h = 1
    # an error norm tends to zero: the band holds it
    assert grid_uncertainty([0.1, 0.2, 0.4], [1, 2, 4])[2] > 0.1
    # a higher order counts as one: of two pairs the one that gives more
    order, method, width = grid_uncertainty([1.0, 2.0, 10.0], [1, 2, 4])
    assert close(order, 3, 1e-6) and method == "GCI 1.25" and close(width, 1.25 * 4), width
    assert close(grid_uncertainty([1.0, 2.0, 10.0], [1, 2, 4], 2)[2], 1.25 * 8 / 12)
    # differences that hardly fall, or grow: safety 3 and an order of 0.5
    order, method, width = grid_uncertainty([1.0, 2.0, 2.5], [1, 2, 4])
    assert order is None and method == "GCI 3" and close(width, 3 / (math.sqrt(2) - 1)), width
    assert observed_order(1.0, 0.5, 2, 2) is None
    assert grid_uncertainty([0.0, 1.0, 2.2], [1, 2, 4])[1] == "GCI 3"
    # up and down; nothing changes
    found = grid_uncertainty([1.0, 1.2, 0.4], [1, 2, 4])
    assert found[:2] == (None, "GCI 1.25 up and down") and close(found[2], 1.25 * 0.4), found
    assert grid_uncertainty([5.0, 5.0, 5.0], [1, 2, 4]) == (None, "same on all grids", 0.0)
    # Student's t: two values, 1 degree of freedom
    deviation, width = spread([1.0, 3.0])
    assert close(deviation, math.sqrt(2)) and close(width, 12.706 * math.sqrt(2))
    assert spread([1.0]) == (None, 0.0)


def companions(_, folder):
    """What the companion runs set; what cannot be scaled is refused."""
    study = Study(str(TINY))
    coarse, fine = study.variants
    runs = ErrorBars(study).companions(fine)
    assert sorted(runs) == [(1, 0), (1, 1), (1, 2), (2, 0), (4, 0)]
    assert runs[1, 0] is fine and runs[2, 0].name == coarse.name, "one run for both"
    assert runs[4, 0].entries["Grid/Cell size"] == "0.2"
    assert runs[4, 0].entries["Time/Step"] == "0.02"
    assert [runs[1, i].entries.get("Points/Seed") for i in (0, 1, 2)] == [None, "1", "2"]
    assert runs[1, 1].entries["Points/Jitter"] == "0.2"

    # without "scale": what the parameter file says about cells and step; a scene
    # with disordered points keeps its jitter and gets other seeds
    def study_of(text):
        file = pathlib.Path(folder, "a.toml")
        file.write_text(f'base = "{ROOT}/prm/studies/column_2d.prm"\n' + text)
        study = Study(str(file))
        return ErrorBars(study).companions(study.variants[0])

    runs = study_of('[vary]\n"Points/Jitter" = [0.4]\n')
    assert runs[4, 0].entries == {"Points/Jitter": "0.4", "Grid/Cell size": "0.2",
                                  "Time/Step": "0.04"}, runs[4, 0].entries
    assert [runs[1, i].entries["Points/Seed"] for i in (1, 2, 3, 4)] == ["2", "3", "4", "5"]
    assert runs[1, 1].entries["Points/Jitter"] == "0.4"
    runs = study_of('[vary]\n"Grid/Cells x" = ["16, 8"]\n')
    assert runs[4, 0].entries["Grid/Cells x"] == "4, 2"
    assert scaled(3, 2, "") == 6 and scaled("4, 12", 0.25, "") == "1, 3"
    for text, message in (
            ('[vary]\n"Grid/Cells x" = [18]\n', "multiples of 4"),
            ('[vary]\nn = [1]\n[error_bars]\nscale = {m = 1}\n', "no setting 'm'"),
            ('[vary]\nn = [1]\n[error_bars]\nreplica = 1\n', "no key 'replica'"),
            ('[vary]\nn = [1]\n[error_bars]\nreplicas = 99\n', "from 0 to 10"),
            ('[vary]\nn = [1]\n[error_bars]\njitter = 0\n', "'jitter'"),
            ('[vary]\nn = [1]\n[error_bars]\norder = 0\n', "'order'"),
            ('[vary]\nn = ["a"]\n[error_bars]\nscale = {n = 1}\n', "no number")):
        try:
            study_of(text)
        except StudyError as error:
            assert message in str(error), error
        else:
            raise AssertionError(f"accepted: {text}")


def tables(seiche, folder):
    """A study with bands from its runs to its tables; a companion that fails."""
    text = run(seiche, folder)
    assert "8 variants, 8 to be run" in text, text  # four sizes, two with two replicas
    results = read_table(f"{folder}/results.csv")
    assert [row["h"] for row in results] == ["0.1", "0.05"], "companions are no rows"
    rows = {(row["h"], row["quantity"]): row for row in read_table(f"{folder}/error_bars.csv")}
    assert {"front", "max gauge left [m]", "max depth left [m]"} <= {name for _, name in rows}
    assert not any("front surge" in name for _, name in rows), "collected already"
    fine, coarse = rows["0.05", "front"], rows["0.1", "front"]
    assert float(fine["value"]) == float(results[1]["front"])
    assert fine["replicas"] == "2" and float(fine["standard deviation"]) > 0
    low, high = float(fine["low"]), float(fine["high"])
    assert low < float(fine["value"]) < high
    assert close(float(fine["uncertainty"]), math.hypot(float(fine["grid uncertainty"]),
                                                        float(fine["replica uncertainty"])), 1e-6)
    assert close(float(fine["replica uncertainty"]), 4.303 * float(fine["standard deviation"]), 1e-6)
    # the truth of the coarse one is the mean of the fine ones; the fine one has none
    assert fine["truth"] == "" and coarse["truth"] != "" and coarse["inside"] in ("yes", "no")
    assert "bands hold the truth" in text and "bands hold the truth" in pathlib.Path(
        folder, "error_bars.txt").read_text()

    # without the fourfold cells there is no grid uncertainty, and the row says why
    outcome = next(pathlib.Path(folder, "runs").glob("h=0.2_[!S]*/outcome.json"))
    record = json.loads(outcome.read_text())
    outcome.write_text(json.dumps({**record, "exit_code": 3, "message": "linear solver"}))
    run(seiche, folder, "--no-plots")
    row = next(row for row in read_table(f"{folder}/error_bars.csv")
               if row["h"] == "0.05" and row["quantity"] == "front")
    assert row["uncertainty"] == "" and "run with 4h: linear solver" in row["remark"], row

    # not asked for: no table that nobody has renewed
    other = pathlib.Path(folder, "none.toml")
    head = TINY.read_text().replace('"../../', f'"{ROOT}/')
    other.write_text(head[:head.index("[error_bars]")])
    text = run(seiche, folder, "--no-plots", file=other)
    assert not pathlib.Path(folder, "error_bars.csv").exists()
    text = run(seiche, f"{folder}/new", "--error-bars", "--dry-run", "--only", "h=0.1", file=other)
    assert "7 variants, 7 to be run" in text, text  # three sizes, four replicas
    scene = ROOT / "prm/studies/column_2d.prm"  # a parameter file is one variant
    text = run(seiche, f"{folder}/one", "--error-bars", "--dry-run", file=scene)
    assert "7 variants, 7 to be run" in text, text


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as scratch:
        cases = (estimators, companions, tables)
        {case.__name__: case for case in cases}[sys.argv[2]](sys.argv[1], scratch)
    print("passed")
