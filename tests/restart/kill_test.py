#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kill a run at random moments, restart it, and compare its end.

kill_test.py SEICHE MPIRUN [--kills N] [--ranks N] [--seed N] [--scene NAME]

kill -9 of all ranks, alternately at any moment and as soon as a checkpoint is
being written. In the end statistics.csv (and probes.csv) must be byte for byte
those of a run that nobody touched. Runs that end before enough kills are
compared too, and the next one starts in a new folder.
"""
import argparse
import glob
import os
import pathlib
import random
import tempfile
import time

from runs import Program, checkpoints, kill, require_same_files

HERE = pathlib.Path(__file__).resolve().parent
SCENES = {  # options, files to compare
    "dam_break_2d": (["Time/Step = 0.002", "Checkpoint/Every steps = 10",
                      "Output/Interval = 0.02"],
                     ["statistics.csv", "probes.csv"]),
    "adaptive_2d": (["Output/Interval = 0.02"], ["statistics.csv"]),
    "column_3d": ([], ["statistics.csv"])}


def being_written(folder):
    return glob.glob(f"{folder}/checkpoint-*.h5.writing")


def wait_until(process, end, condition=lambda: False):
    """Until a moment or a condition; false if the run ended before."""
    while time.monotonic() < end and not condition():
        if process.poll() is not None:
            return False
        time.sleep(0.0001)
    return process.poll() is None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("seiche")
    parser.add_argument("mpirun")
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--scene", choices=SCENES, default="dam_break_2d")
    arguments = parser.parse_args()
    seed = arguments.seed if arguments.seed is not None else time.time_ns()
    chance = random.Random(seed)
    options, results = SCENES[arguments.scene]
    program = Program(arguments.seiche, arguments.mpirun,
                      str(HERE / f"{arguments.scene}.prm"), arguments.ranks, options)

    kills, in_writing, before_first, whole_runs = 0, 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        begin = time.monotonic()
        program.run(f"{folder}/whole")
        duration = time.monotonic() - begin
        parts = f"{folder}/parts0"
        while kills < arguments.kills:
            resumes = os.path.isdir(parts) and bool(checkpoints(parts))
            before_first += not resumes and kills > 0
            begin = time.monotonic()
            process = program.start(parts, *(["--restart"] if resumes else []))
            moment = begin + chance.uniform(0, max(0.3 * duration, 1.))
            runs = wait_until(process, moment)
            if runs and kills % 2 == 1:
                runs = wait_until(process, moment + duration,
                                  lambda: being_written(parts))
            if runs:
                kill(process)
                kills += 1
                in_writing += bool(being_written(parts))
                continue
            text = process.communicate()[0]
            if not resumes:  # the first run may have waited for others
                duration = min(duration, time.monotonic() - begin)
            assert process.returncode == 0, f"seed {seed}: {text}"
            require_same_files(f"{folder}/whole", parts, results)
            whole_runs += 1
            parts = f"{folder}/parts{whole_runs}"
        resumes = os.path.isdir(parts) and bool(checkpoints(parts))
        program.run(parts, *(["--restart"] if resumes else []))
        require_same_files(f"{folder}/whole", parts, results)
    print(f"{arguments.scene}, seed {seed}: {kills} kills on {arguments.ranks} ranks, "
          f"{in_writing} while a checkpoint was written, {before_first} starts "
          f"without one; {whole_runs + 1} runs completed, all the same as one "
          f"without kills ({duration:.1f} s)")


if __name__ == "__main__":
    main()
