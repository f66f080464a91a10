#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes of prm/verification and prm/stress, their scores and orders.

check_verification.py --list
check_verification.py SEICHE CASE

Limits are about one and a half times what was measured when the case was
written; orders are bounded from below (and above, where a higher order would
mean that something is not tested).
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import traceback

PRM = pathlib.Path(__file__).resolve().parents[2] / "prm"
sys.path.insert(0, str(PRM / "verification"))
import wave_fit  # noqa: E402


def cells(n, dim=2):
    return [f"Grid/Cells {axis} = {n}" for axis in "xyz"[:dim]]


# case: (scene, settings, {score: limit}); limits of "ledger ..." are of the
# entry of the ledger
SCENES = {
}

# case: (scene, settings of each run, ratio of the step sizes, {score: (least
# order, greatest)}) from the last two runs
ORDERS = {
}


class Runner:
    """Runs scenes, each in a folder of its own."""

    def __init__(self, seiche, folder):
        self.seiche, self.folder, self.count = seiche, folder, 0

    def run(self, scene, settings):
        """Folder and summary of a run."""
        self.count += 1
        output = f"{self.folder}/{self.count}"
        command = [self.seiche, str(PRM / f"{scene}.prm"), "--output", output]
        for setting in settings:
            command += ["--set", setting]
        process = subprocess.run(command, stdout=subprocess.PIPE, text=True,
                                 stderr=subprocess.STDOUT, timeout=300)
        assert process.returncode == 0, (
            f"{scene} {settings}: exit code {process.returncode}\n{process.stdout}")
        with open(f"{output}/summary.json", encoding="utf-8") as file:
            return output, json.load(file)


def value(summary, name):
    if name.startswith("ledger "):
        return abs(summary["ledger"][name[len("ledger "):]])
    return abs(summary["errors"][name])


def check_scene(runner, scene, settings, limits):
    _, summary = runner.run(scene, settings)
    failed = []
    for name, limit in limits.items():
        measured = value(summary, name)
        print(f"{scene} {name}: {measured:.3g}, limit {limit:.3g}")
        if not measured <= limit:
            failed.append(name)
    assert not failed, f"{scene}: {', '.join(failed)} above the limit"


def check_order(runner, scene, runs, ratio, orders):
    errors = [runner.run(scene, settings)[1]["errors"] for settings in runs]
    failed = []
    for name, (least, greatest) in orders.items():
        order = math.log(errors[-2][name] / errors[-1][name]) / math.log(ratio)
        print(f"{scene} {name}: {[e[name] for e in errors]}, order {order:.2f}")
        if not least <= order <= greatest:
            failed.append(name)
    assert not failed, f"{scene}: order of {', '.join(failed)}"


def standing_wave(runner):
    """Frequency within 1 %, damping rate within 10 %."""
    output, _ = runner.run("verification/standing_wave", ["Time/End time = 1.8"])
    table = PRM / "verification/reference/standing_wave.csv"
    frequency, damping = wave_fit.fit(output, table)
    print(f"frequency {frequency:+.4f}, damping rate {damping:+.4f}")
    assert abs(frequency) <= 0.01 and abs(damping) <= 0.1


def time_order(runner):
    """Generalized midpoint, rho_inf = 1: differences from a run with small
    steps on the same grid."""
    columns = ["probe one velocity x [m/s]", "probe two velocity y [m/s]"]
    steps = [0.2, 0.1, 0.05, 0.0125]
    ends = []
    for step in steps:
        output, _ = runner.run("verification/time_order", [f"Time/Step = {step}"])
        with open(f"{output}/statistics.csv", encoding="utf-8") as file:
            lines = file.read().splitlines()
        last = dict(zip(lines[0].split(","), lines[-1].split(",")))
        ends.append([float(last[c]) for c in columns])
    errors = [math.dist(e, ends[-1]) for e in ends[:-1]]
    orders = [math.log2(a / b) for a, b in zip(errors, errors[1:])]
    print(f"differences {errors}, orders {orders}")
    assert min(orders) >= 1.9, orders


OTHERS = {"standing_wave": standing_wave, "order_time_midpoint": time_order}


def main():
    if sys.argv[1:] == ["--list"]:
        print("\n".join([*SCENES, *ORDERS, *OTHERS]))
        return 0
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    seiche, case = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(seiche, folder)
        try:
            if case in SCENES:
                check_scene(runner, *SCENES[case])
            elif case in ORDERS:
                check_order(runner, *ORDERS[case])
            else:
                OTHERS[case](runner)
        except AssertionError:
            traceback.print_exc(limit=1)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
