#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameter studies of contrib/study, and the figures of contrib/paper.

check_study.py SEICHE CASE
"""
import csv
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
CONTRIB = HERE.parents[1] / "contrib"
sys.path.insert(0, str(CONTRIB))
import seiche_study  # noqa: E402
import seiche_study_results as results  # noqa: E402

TINY = HERE / "tiny.toml"


def start(seiche, folder, *arguments, file=TINY):
    return subprocess.Popen(
        [sys.executable, str(CONTRIB / "study"), str(file), "--program", seiche,
         "--output", folder, "--jobs", "1", *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def run(seiche, folder, *arguments, code=0, file=TINY):
    process = start(seiche, folder, *arguments, file=file)
    text = process.communicate(timeout=60)[0]
    assert process.returncode == code, f"exit code {process.returncode}:\n{text}"
    return text


def read_table(folder):
    with open(f"{folder}/results.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def wait_until_long_runs(process, folder):
    """Until the second variant has done some steps."""
    end = time.monotonic() + 30
    while time.monotonic() < end:
        for path in pathlib.Path(folder, "runs").glob("variant=long*/run/statistics.csv"):
            if path.read_bytes().count(b"\n") > 10:
                return
        assert process.poll() is None, process.communicate()[0]
        time.sleep(0.005)
    raise AssertionError("the second variant does not run")


def outcomes(folder):
    return {path.parent.name.split("=")[1].split("_")[0]: path.stat().st_mtime_ns
            for path in pathlib.Path(folder, "runs").glob("*/outcome.json")}


def remove(folder):
    """The folder of a run that may outlive the killed runner for a moment."""
    for _ in range(100):
        shutil.rmtree(folder, ignore_errors=True)
        if not folder.exists():
            return
        time.sleep(0.1)
    raise AssertionError(f"{folder} does not go away")


def resume(seiche, folder):
    """Killed, then stopped, then finished; each variant runs to its end once."""
    text = run(seiche, folder, "--dry-run")
    assert "3 variants, 3 to be run" in text and not os.listdir(folder), text
    for sign, code in ((signal.SIGKILL, -signal.SIGKILL), (signal.SIGTERM, 5)):
        process = start(seiche, folder)
        wait_until_long_runs(process, folder)
        if code == 5:
            assert "another contrib/study" in run(seiche, folder, code=2)
        process.send_signal(sign)
        process.communicate(timeout=30)
        assert process.returncode == code, process.returncode
        assert list(outcomes(folder)) == ["short"], outcomes(folder)
        remove(next(pathlib.Path(folder, "runs").glob("variant=long*/run")))
    first = outcomes(folder)["short"]
    text = run(seiche, folder, "--no-plots")
    assert "3 variants, 2 to be run" in text and "[2/2]" in text, text
    assert outcomes(folder)["short"] == first, "a finished variant was run again"
    assert "3 variants, 0 to be run" in run(seiche, folder, "--no-plots")

    # another build runs them again, if it is not told otherwise
    other = pathlib.Path(folder, "seiche")
    other.write_bytes(pathlib.Path(seiche).read_bytes() + b"\0")
    other.chmod(0o755)
    assert "3 to be run" in run(str(other), folder, "--dry-run")
    assert "0 to be run" in run(str(other), folder, "--dry-run", "--any-program")
    run(str(other), folder, "--no-plots", "--only", "short")
    assert [row["program"] == read_table(folder)[1]["program"]
            for row in read_table(folder)] == [False, True, True]

    rows = read_table(folder)
    assert [row["variant"] for row in rows] == ["short", "long", "failing"]
    header = list(rows[0])
    assert header.index("Time/Step") < header.index("exit_code") < header.index("front")
    short, long, failing = rows
    assert short["exit_code"] == "0" and short["cause"] == "" and short["steps"] == "4", short
    assert short["Time/Step"] == "0.005" and short["n"] == "20", short
    assert 0.3 < float(short["front"]) < 0.4, short
    assert abs(float(short["twice"]) - 2 * float(short["front"])) < 1e-9
    assert float(short["cpu_seconds"]) > 0
    assert long["exit_code"] == "0" and long["cause"] == "too fast", long
    assert failing["exit_code"] == "3" and failing["cause"] == "Newton", failing
    assert "Newton stopped after 1 iterations" in failing["message"], failing
    slow = {"exit_code": 3, "message": "step 1: Newton hardly converged after 4 iterations"}
    assert results.cause(slow) == "Newton"
    assert failing["volume"] == ""

    # a longer run than the time allowed is a row too; so are other settings
    file = pathlib.Path(folder, "late.toml")
    file.write_text(TINY.read_text().replace('"../../', f'"{HERE.parents[1]}/'))
    run(seiche, f"{folder}/late", "--only", "*long*", "--timeout", "0.1", "--no-plots", file=file)
    assert [row["cause"] for row in read_table(f"{folder}/late")] == ["timeout"]


def mistakes(seiche, folder):
    """One message and exit code 2."""
    good = TINY.read_text().replace('"../../', f'"{HERE.parents[1]}/')
    cases = {
        "syntax": ("[set]", "[set", "line"),
        "table": ("[fail]", "[fial]", "'fial'"),
        "base": ("column_2d.prm", "nothing.prm", "no file"),
        "variable": ("{0.1/n}", "{0.1/m}", "no variable 'm'; known: "),
        "logarithm": ("[collect]", "[sample]\ncount = 2\nodd = {from = 0, to = 1, "
                      "scale = 'log'}\n[collect]", "positive"),
        "circle": ("points = 2", 'points = "{points+1}"', "circle"),
        "code": ("{0.1/n}", "{open('x')}", "'open'"),
        "attribute": ("{0.1/n}", "{n.real}", "only numbers"),
        "plot": ('x    = "n"', 'x    = "m"', "'m'"),
        "kind": ('"map"', '"mop"', "work"),
        "nothing varies": ("[[variants]]", "[[plot]]", "nothing varies"),
        "endless power": ("{0.1/n}", "{9**9**9**9}", "out of range"),
        "condition": ("[fail]", "[fail]\n\"odd\" = \"nothing > 1\"", "'nothing'"),
        "function": ("[collect]", "[collect]\nodd = \"median(front)\"", "median"),
        "timeout": ("timeout = 60", "timeout = -1", "timeout"),
    }
    for name, (old, new, message) in cases.items():
        assert old in good
        file = pathlib.Path(folder, "bad.toml")
        file.write_text(good.replace(old, new))
        text = run(seiche, f"{folder}/out", "--dry-run", code=2, file=file)
        assert message in text and text.count("\n") == 1, f"{name}: {text}"
    run(seiche, folder, "--dry-run", code=2, file=f"{folder}/missing.toml")
    assert "no variant" in run(seiche, folder, "--only", "x*x", "--dry-run", code=2)
    assert not os.path.exists(f"{folder}/out")

    # of an entry: the program finds it, and the study says so at its end
    file = pathlib.Path(folder, "entry.toml")
    file.write_text(good.replace('"Time/Minimum step" ', '"Time/Minimum stpe" '))
    text = run(seiche, f"{folder}/entry", "--only", "failing", "--no-plots", code=2, file=file)
    assert 'did you mean "Minimum step"' in text.splitlines()[-1], text

    # of a column: no run has a value, which is said beside the others
    file = pathlib.Path(folder, "column.toml")
    file.write_text(good.replace("[collect]", "[collect]\nodd = \"last(no such [m])\""))
    text = run(seiche, f"{folder}/column", "--no-plots", file=file)
    assert 'no run has a value of odd = "last(no such [m])"' in text, text
    assert text.count("no run has a value") == 1, text


def expansion(_, folder):
    """Products, tied entries, samples, names."""
    file = pathlib.Path(folder, "a.toml")
    base = f'base = "{HERE.parents[1]}/prm/studies/column_2d.prm"\n'
    file.write_text(base + '''
skip = ["n == 20 and scheme == 'b'"]
[set]
"Time/Step" = "{1.6/n}"
"Fluid/Bulk modulus" = "{inf if n > 30 else kappa}"
kappa = "{10**3*n}"
[vary]
n = [10, 20, 40]
[[vary.scheme]]
name = "a"
[[vary.scheme]]
name = "b"
"Time/Step" = 1
[sample]
count = 10
seed = 3
"Points/Jitter" = {from = 0, to = 0.5}
mu = {from = 1e-4, to = 1e4, scale = "log"}
k = [1, 2]
''')
    variants = seiche_study.Study(str(file)).variants
    assert len(variants) == (3 * 2 - 1) * 10 == len({v.name for v in variants})
    assert {v.entries["Time/Step"] for v in variants} == {"0.16", "0.08", "0.04", "1"}
    assert {v.entries["Fluid/Bulk modulus"] for v in variants} == {"10000", "20000", "infinite"}
    jitter = sorted(v.settings["Points/Jitter"] for v in variants[:10])
    assert all(0.05 * i <= x <= 0.05 * (i + 1) for i, x in enumerate(jitter)), jitter
    assert sorted(v.settings["k"] for v in variants[:10]) == [1] * 5 + [2] * 5
    again = seiche_study.Study(str(file)).variants
    assert [v.name for v in again] == [v.name for v in variants], "the seed does not fix the sample"


def orders(_, __):
    fitted = results.fitted_order
    h = [0.4, 0.2, 0.1]
    slope, between = fitted(h, [3 * v**2 for v in h])
    assert abs(slope - 2) < 1e-12 and len(between) == 2
    assert all(abs(v - 2) < 1e-12 for v in between)
    # least squares, any order of the points, holes left out
    slope, between = fitted([0.1, 0.4, 0.2, 0.05], [1.0, 16.0, 2.0, None])
    assert abs(slope - 2) < 1e-12 and [round(v, 12) for v in between] == [3, 1]
    assert fitted([0.1, 0.1], [1, 2]) == (None, [])
    assert fitted([0.1, 0.2], [0, 1]) == (None, [])

    statistics = {"time [s]": [0.0, 1.0, 3.0], "a [m]": [None, 4.0, 8.0]}
    collect = results.collect
    assert collect("last(a [m])", statistics, {}) == 8
    assert collect("min(a [m])", statistics, {}) == 4
    assert collect("at(a [m], 2)", statistics, {}) == 6
    assert collect("last(b [m])", statistics, {}) is None
    assert collect("errors/x", {}, {"errors": {"x": 0.5}}) == 0.5

    # a triangle of height 4: half of it 0.5 s before the peak
    statistics = {"time [s]": [0.0, 1.0, 2.0, 4.0], "p [Pa]": [None, 0.0, 4.0, 0.0]}
    assert collect("integral(p [Pa])", statistics, {}) == 0.5 * 4 * 3
    assert collect("rise(p [Pa])", statistics, {}) == 1
    assert collect("rise(a [m])", {"time [s]": [0.0, 1.0], "a [m]": [3.0, 4.0]}, {}) is None


def plots(_, folder):
    """The three kinds of pictures, from a table; failed runs among them."""
    base = f'base = "{HERE.parents[1]}/prm/studies/column_2d.prm"\n'
    file = pathlib.Path(folder, "a.toml")
    file.write_text(base + """
[vary]
h = [0.4, 0.2, 0.1]
method = ["a", "b"]
[collect]
error = "errors/x"
[[plot]]
kind = "convergence"
x = "h"
y = "error"
line = "method"
[[plot]]
kind = "work"
y = "error"
line = "method"
[[plot]]
kind = "map"
x = "h"
y = "method"
""")
    study = seiche_study.Study(str(file))
    rows = []
    for variant in study.variants:
        h, b = variant.settings["h"], variant.settings["method"] == "b"
        failed = b and h == 0.1
        rows.append((variant.name, {**variant.settings, "exit_code": 3 if failed else 0,
                                    "cause": "Newton" if failed else "",
                                    "error": None if failed else 5 * h ** (1 if b else 2),
                                    "cpu_seconds": 1 / h}))
    study.write_table(rows, f"{folder}/results.csv")
    process = subprocess.run(
        [sys.executable, str(CONTRIB / "seiche_study_plots.py"), str(file), folder],
        capture_output=True, text=True, check=True)
    if "no pictures" in process.stderr:
        print("no matplotlib here:", process.stderr)
        return
    for name in ("convergence-1.png", "work-2.png", "map-3.png"):
        assert os.path.getsize(f"{folder}/{name}") > 5000, name
    with open(f"{folder}/orders.csv", newline="", encoding="utf-8") as table:
        lines = list(csv.DictReader(table))
    assert [(line["line"], line["points"], line["fitted order"]) for line in lines] == [
        ("a", "3", "2.000"), ("b", "2", "1.000")], lines


COARSE = {  # study of contrib/paper -> (base, entries of all its variants, their names)
    "rotating_patch": ("paper/rotating_patch.prm", """
"Grid/Cell size" = 0.1
"Time/Step" = 0.05
"Time/End time" = 1
""", ("mixed 36", "paper, mixed 36", "mixed 16")),
    "dam_break_2d": ("paper/dam_break_2d.prm", """
"Grid/Cell size" = 0.1
"Time/Step" = 0.02
"Time/End time" = 0.52
""", ("mixed", "paper, mixed")),
    "obstacle_3d": ("benchmarks/aureli_obstacle/aureli_obstacle.prm", """
"Grid/Cells x" = "8, 1, 5, 1, 5"
"Grid/Cells y" = "4, 3, 4"
"Grid/Cells z" = "1, 1, 1"
"Time/Step" = 0.02
"Time/End time" = 0.36
""", ("this code",)),
}


def paper(seiche, folder):
    """Figures and numbers of contrib/paper from tiny runs; some are missing."""
    for study, (base, entries, names) in COARSE.items():
        file = pathlib.Path(folder, "a.toml")
        file.write_text(
            f'base = "{HERE.parents[1]}/prm/{base}"\n[set]\n'
            f'"Points/Per cell and direction" = 2\n{entries}'
            + "".join(f'[[variants]]\nname = "{name}"\n' for name in names)
            + '[collect]\nenergy = "last(relative_energy)"\n')
        run(seiche, f"{folder}/{study}", file=file)
    process = subprocess.run(
        [sys.executable, str(CONTRIB / "paper"), "--plot-only", "--output", folder],
        capture_output=True, text=True)
    if process.returncode == 1 and "python3-matplotlib" in process.stderr:
        print("no matplotlib here:", process.stderr)
        return
    assert process.returncode == 0, process.stderr
    pictures = sorted(path.name[:9] for path in pathlib.Path(folder).glob("figure_*.png")
                      if path.stat().st_size > 20000)
    assert pictures == [f"figure_{i:02d}" for i in (2, 3, 4, 5, 7, 8, 9, 10, 12, 13, 14)], pictures

    with open(f"{folder}/figures.csv", newline="", encoding="utf-8") as table:
        numbers = {(line["table"].split(":")[0], line["run"], line["quantity"]): line["value"]
                   for line in csv.DictReader(table)}

    def number(*key):
        return float(numbers[key])

    # interFoam against the experiment: from the tables of reference/ alone
    assert abs(number("Figure 9", "interFoam", "one shift of its clock [s]") - 0.012) < 1e-9
    assert abs(number("Figure 9", "interFoam", "rms over H") - 0.0957) < 1e-4
    assert abs(number("Figure 10", "experiment, median, not smoothed",
                      "sensor1, mean 0.9 to 1.3 s [Pa]") - 4141) < 1
    # both names are the same run here; the patch is coarse, not wrong
    key = "rms of p - reference [Pa]"
    assert number("Figure 4", "this code", key) == number(
        "Figure 4", "founding paper's recipe", key) < 0.02
    assert number("Figure 5", "mixed 36", "smoothed [Pa]") < 0.02
    assert number("Figure 9", "mixed", "rms over H") < 0.3
    assert numbers["Figure 10", "mixed", "sensor1, mean 0.9 to 1.3 s [Pa]"] == ""  # ended before
    assert number("Figure 14", "this code", "mean at 0.32 s") >= 0
    assert "founding paper's recipe" not in {run for figure, run, _ in numbers
                                             if figure == "Figure 14"}
    text = pathlib.Path(folder, "figures.md").read_text()
    assert "| mixed |" in text and text.strip() in process.stdout



if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as scratch:
        cases = (resume, mistakes, expansion, orders, plots, paper)
        {case.__name__: case for case in cases}[sys.argv[2]](sys.argv[1], scratch)
    print("passed")
