# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the machine can do at most: memory bandwidth and fused multiply-adds of
one core, measured by the two programs in machine/."""

import json
import os
import platform
import subprocess
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
FLAGS = ["-O3", "-march=native", "-fopenmp", "-mprefer-vector-width=512"]


def best(name):
    """The largest figure of a program of machine/, of three runs."""
    with tempfile.TemporaryDirectory() as folder:
        program = os.path.join(folder, name)
        subprocess.run(["gcc", *FLAGS, os.path.join(HERE, "machine", name + ".c"), "-o",
                        program], check=True)
        values = []
        for _ in range(3):
            run = subprocess.run([program], check=True, capture_output=True, text=True,
                                 env={**os.environ, "OMP_NUM_THREADS": "1"})
            values += [float(line.split(",")[-2]) for line in run.stdout.splitlines()]
    return max(values)


def describe_machine(path):
    """Reads or measures; {"bandwidth": GB/s, "fma": GFLOP/s, "text": one line}."""
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
    machine = {"bandwidth": best("stream"), "fma": best("fma")}
    machine["text"] = (f"{names[0] if names else platform.machine()}, {len(names)} cores; one core: "
                       f"{machine['bandwidth']:.0f} GB/s, {machine['fma']:.0f} GFLOP/s "
                       "(double, fused multiply-add).")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(machine, file, indent=1)
    return machine
