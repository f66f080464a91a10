#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The harness of the benchmarks with codes that only pretend to run.

check_benchmark.py CASE SEICHE
"""
import contextlib
import importlib.machinery
import importlib.util
import io
import os
import pathlib
import sys
import tempfile

BENCHMARKS = pathlib.Path(__file__).resolve().parents[2] / "contrib" / "benchmarks"
os.environ["SEICHE_SYSTEM_PYTHON"] = "1"  # the tests' own Python will do


def load_harness():
    loader = importlib.machinery.SourceFileLoader("benchmark", str(BENCHMARKS / "benchmark"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("benchmark", loader))
    loader.exec_module(module)
    return module


harness = load_harness()
from cases import Case, Run, rms_difference  # noqa: E402
from codes import RunFailed, Seiche, write_curves  # noqa: E402
from curves import read_curves  # noqa: E402
from openfoam import crossing  # noqa: E402


class Stub:
    """A code whose front is its argument times t."""

    def __init__(self):
        self.program, self.runs, self.problem = "first", 0, None

    def is_installed(self):
        return True

    def identity(self, arguments):
        return self.program

    def run(self, arguments, folder):
        self.runs += 1
        assert os.path.isabs(folder), "codes run in another folder"
        if self.problem is not None:
            raise self.problem
        write_curves(folder, {"t": [0.0, 1.0], "front": [0.0, float(arguments[0])]})
        return {"version": "Stub 1", "cpu_seconds": float(self.runs), "steps": 10,
                "seconds_a_step": 0.1, "start_seconds": None}


class Bench:
    """The harness in a folder of its own, with one stub and one case."""

    def __init__(self, folder):
        self.folder, self.code = folder, Stub()
        runs = [Run("stub reference", "stub", ["1"], is_reference=True),
                Run("stub h 1", "stub", ["1.1"], "stub reference"),
                Run("other h 1", "stub", ["1.5"], "stub reference")]
        case = Case("A case", runs, {"front": rms_difference("front", 0, 1, 1)})
        harness.CODES.clear()
        harness.CODES["stub"] = self.code
        harness.CASES.clear()
        harness.CASES["case"] = case
        harness.describe_machine = lambda path: {"text": "A machine."}
        harness.write_plot = lambda *arguments: None

    def __call__(self, *options):
        """(exit code, table or "", messages)"""
        sys.argv = ["benchmark", "--output", self.folder, *options]
        messages = io.StringIO()
        with contextlib.redirect_stderr(messages), contextlib.redirect_stdout(io.StringIO()):
            code = harness.main()
        table = pathlib.Path(self.folder) / "case.md"
        return code, table.read_text() if table.is_file() else "", messages.getvalue()


def rows(table):
    return [line for line in table.splitlines() if line.startswith(("| stub", "| other"))]


def check_rerun(bench):
    code, table, _ = bench()
    assert code == 0 and bench.code.runs == 3 and len(rows(table)) == 3, table
    bench()
    assert bench.code.runs == 3, "ran again what was there"
    bench.code.program = "second"
    bench()
    assert bench.code.runs == 6, "another program's results served"
    bench("--fresh")
    assert bench.code.runs == 9
    bench("--repeat", "2")
    assert bench.code.runs == 11, "a second round of all but the reference"
    assert "| 2 |" in rows(bench("--table-only")[1])[1], "the table knows one round only"
    bench.code.program = "third"
    assert "| 1 |" in rows(bench()[1])[1], "a table of two programs"


def check_failures(bench):
    bench()
    for problem in (RunFailed("as a test"), KeyError("steps"), TypeError("missing")):
        bench.code.problem = problem
        code, table, messages = bench("--fresh")
        assert code == 1 and not table, f"old results after a failure:\n{table}"
        assert "nothing has been measured" in messages, messages
        assert "stub h 1" in messages and "other h 1" in messages, messages
    bench.code.problem = None
    code, table, _ = bench()
    assert code == 0 and len(rows(table)) == 3


def check_only(bench):
    bench()
    code, table, _ = bench("--only", "other*", "--fresh")
    assert code == 0 and bench.code.runs == 4, bench.code.runs
    assert len(rows(table)) == 3, f"rows are lost:\n{table}"
    assert "0.0577" in rows(table)[1], f"no error without its reference:\n{table}"
    try:
        bench("--only", "nothing*")
    except SystemExit as stop:
        assert stop.code == 2
    else:
        raise AssertionError("a pattern without runs is accepted")


def check_folder(bench):
    os.chdir(bench.folder)
    bench.folder = "below"
    code, table, messages = bench()
    assert code == 0 and len(rows(table)) == 3, messages
    pathlib.Path("file").touch()
    bench.folder = "file"
    code, _, messages = bench()
    assert code == 2 and messages.count("\n") == 1, messages
    os.chdir(os.path.dirname(os.getcwd()))


def check_numbers(bench):
    bench("--repeat", "2")
    table = rows(bench("--repeat", "2")[1])
    columns = [column.strip() for column in table[2].split("|")]
    # runs 3 and 5 of the stub; rms of 0.5 t
    assert columns[5:7] == ["3", "4"] and columns[-2] == "0.289", columns
    assert crossing([0.5, 1.5, 2.5], [1.0, 0.75, 0.25], True) == 2.0
    assert crossing([0.5, 1.5, 2.5], [1.0, 1.0, 1.0], True) == 3.0
    assert crossing([0.5, 1.5, 2.5], [0.0, 0.0, 0.0], True) == 0.0


def check_program(bench):
    """The program itself: what the errors read is there from the start on."""
    code = Seiche()
    code.program = sys.argv[2]
    result = code.run(["benchmarks/rotating_patch/rotating_patch.prm",
                       "Time/End time = 0.1", "Time/Step = 0.05"], bench.folder)
    curves = read_curves(bench.folder)
    assert result["steps"] == 2 and len(curves["t"]) == 3, (result, curves)
    assert curves["p_centre"][0] == curves["p_centre"][1], curves["p_centre"]


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as results:
        globals()["check_" + sys.argv[1]](Bench(results))
