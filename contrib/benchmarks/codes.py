# SPDX-License-Identifier: LGPL-2.1-or-later
"""The codes that the benchmarks run, one object each: is_installed(), and
run(arguments, folder), which leaves `curves.csv` (columns t, ...) in the folder
and returns a dictionary with at least

    version, cpu_seconds  processor time of the solver's whole process [s]
    steps, seconds_a_step processor time of the steps alone, over their number [s]
    start_seconds         from the start to the first step [s], or None
"""

import glob
import hashlib
import json
import os
import shutil
import subprocess
import time

from seiche_study_results import read_statistics, read_summary

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
PEERS = os.path.join(HERE, "peers")
KRATOS_PYTHON = os.path.join(ROOT, "results", "benchmarks", "kratos", "bin", "python")
ONE_CORE = {**os.environ, "OMP_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
            "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def digest(*files):
    total = hashlib.sha1()
    for name in sorted(files):
        with open(name, "rb") as file:
            total.update(file.read())
    return total.hexdigest()


class RunFailed(Exception):
    """A run that ended with an error; the message says which."""


def measured(command, folder):
    """Runs a command; (wall, processor) seconds of it and its children."""
    with open(os.path.join(folder, "output.txt"), "w", encoding="utf-8") as output:
        begin = time.monotonic()
        process = subprocess.Popen(command, cwd=folder, stdout=output, stderr=subprocess.STDOUT,
                                   stdin=subprocess.DEVNULL, env=ONE_CORE)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        with open(output.name, encoding="utf-8", errors="replace") as file:
            tail = " ".join(file.read().split())[-300:]
        raise RunFailed(f"exit code {process.returncode}: ... {tail}")
    return time.monotonic() - begin, usage.ru_utime + usage.ru_stime


def write_curves(folder, columns):
    """{name: values}, all of one length, as curves.csv."""
    with open(os.path.join(folder, "curves.csv"), "w", encoding="utf-8") as file:
        file.write(",".join(columns) + "\n")
        for row in zip(*columns.values()):
            file.write(",".join("%.9g" % value for value in row) + "\n")


def without_gaps(values):
    """What is not known, as a pressure before the first step, is what was known
    last, or first."""
    last = next(value for value in values if value is not None)
    return [last := last if value is None else value for value in values]


class Seiche:
    """build/seiche; arguments: parameter file (relative to prm/), then "Subsection/Entry = value"."""

    program = os.path.join(ROOT, "build", "seiche")
    columns = {  # of statistics.csv -> of curves.csv
        "time [s]": "t", "pressure_time [s]": "t_pressure", "front surge [m]": "front",
        "gauge column [m]": "height", "probe centre pressure [Pa]": "p_centre",
        "relative_energy": "energy", "kinetic energy [J]": "kinetic", "potential energy [J]": "potential",
        "gauge left [m]": "left", "gauge right [m]": "right", **{f"depth H{i} [m]": f"H{i}" for i in range(1, 5)},
        **{f"probe P{i} pressure [Pa]": f"P{i}" for i in range(1, 9)},
    }

    def is_installed(self):
        return os.access(self.program, os.X_OK)

    def identity(self, arguments):
        """Changes with the program and its files, as of the other codes."""
        scene = os.path.dirname(os.path.join(ROOT, "prm", arguments[0]))
        return digest(self.program, *glob.glob(os.path.join(scene, "*.prm")))

    def run(self, arguments, folder):
        run = os.path.join(folder, "run")
        shutil.rmtree(run, ignore_errors=True)
        command = [self.program, os.path.join(ROOT, "prm", arguments[0]), "--output", run]
        for entry in ("Output/Interval = 0", "Checkpoint/Every wall time = 0", *arguments[1:]):
            command += ["--set", entry]
        wall, cpu = measured(command, folder)
        statistics, summary = read_statistics(run), read_summary(run)
        write_curves(folder, {short: without_gaps(statistics[name])
                              for name, short in self.columns.items() if name in statistics})
        phases = summary["phase_seconds"]
        return {
            "version": "Seiche " + summary["program_version"], "wall_seconds": wall,
            "cpu_seconds": cpu, "steps": summary["steps"],
            "seconds_a_step": (sum(phases.values()) - phases["set-up"]) / summary["steps"],
            "start_seconds": cpu - sum(phases.values()) + phases["set-up"],
            "newton": summary["newton_iterations"] / summary["steps"],
            "krylov": summary["krylov_iterations"] / summary["steps"],
            "points": summary["points"], "cells": summary["occupied_cells_max"],
        }


class OpenFoam:
    """interFoam or interIsoFoam by peers/openfoam.py; arguments are its options."""

    def is_installed(self):
        return shutil.which("interFoam") is not None

    def identity(self, arguments):
        import openfoam

        return f"{openfoam.version()} {digest(*glob.glob(os.path.join(PEERS, 'openfoam*.py')))}"

    def run(self, arguments, folder):
        import openfoam

        return openfoam.run(arguments, folder, measured, write_curves)


class Kratos:
    """Kratos' material point application by one of peers/kratos_*.py in an environment
    of its own; arguments are that script's options."""

    def __init__(self, script):
        self.script = os.path.join(PEERS, script)

    def is_installed(self):
        return os.access(KRATOS_PYTHON, os.X_OK)

    def identity(self, arguments):
        packages = os.path.dirname(os.path.dirname(KRATOS_PYTHON))
        names = sorted(map(os.path.basename, glob.glob(
            os.path.join(packages, "lib", "*", "site-packages", "Kratos*.dist-info"))))
        return " ".join([*names, digest(*{os.path.join(PEERS, "kratos_mpm.py"), self.script})])

    def run(self, arguments, folder):
        wall, cpu = measured([KRATOS_PYTHON, self.script, *arguments, "--output", folder], folder)
        with open(os.path.join(folder, "kratos.json"), encoding="utf-8") as file:
            result = json.load(file)
        return {"wall_seconds": wall, "cpu_seconds": cpu, **result}


class PySph:
    """PySPH of Debian by peers/pysph_dam_break.py; arguments: particle spacing and end.
    seconds_a_step is of the whole process."""

    script = os.path.join(PEERS, "pysph_dam_break.py")

    def is_installed(self):
        return os.path.isdir("/usr/lib/python3/dist-packages/pysph")

    def identity(self, arguments):
        names = sorted(map(os.path.basename,
                           glob.glob("/usr/lib/python3/dist-packages/PySPH*-info")))
        return " ".join([*names, digest(self.script)])

    def run(self, arguments, folder):
        # the first run compiles its loops, which are kept
        measured(["/usr/bin/python3", self.script, "0.1", "0.01", folder], folder)
        wall, cpu = measured(["/usr/bin/python3", self.script, *arguments, folder], folder)
        with open(os.path.join(folder, "pysph.json"), encoding="utf-8") as file:
            result = json.load(file)
        return {"version": self.identity(arguments).split("-py")[0].split(".egg")[0],
                "wall_seconds": wall, "cpu_seconds": cpu,
                "seconds_a_step": cpu / result["steps"], **result}


CODES = {"seiche": Seiche(), "openfoam": OpenFoam(), "kratos": Kratos("kratos_mpm.py"),
         "kratos_walls": Kratos("kratos_walls.py"), "pysph": PySph()}
