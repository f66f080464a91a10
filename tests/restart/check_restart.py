#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Interrupted and restarted runs against runs that were not.

check_restart.py SEICHE MPIRUN CASE
"""
import json
import os
import pathlib
import pty
import shutil
import signal
import sys
import tempfile
import time

from runs import (Program, checkpoints, frames, require_same_files,
                  wait_for_rows)

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "ranks"))
from compare_ranks import TOLERANCE, difference, read_columns  # noqa: E402

SCENE_2D = str(HERE / "dam_break_2d.prm")
SCENE_QUADRATIC = str(HERE / "dam_break_2d_quadratic.prm")
SCENE_3D = str(HERE / "column_3d.prm")
SCENE_PISTON = str(HERE / "piston_2d.prm")
SCENE_TANK = str(HERE / "tank_2d.prm")
SCENE_TANK_ON_SPRINGS = str(HERE / "tank_on_springs_3d.prm")
SCENE_ADAPTIVE = str(HERE / "adaptive_2d.prm")
SCENE_CROWDED = str(HERE.parent / "robustness/alarms/crowded.prm")
SCENE_GAP = str(HERE.parent / "robustness/alarms/closing_gap.prm")
SCENE_BOX = str(HERE / "box_3d.prm")
SCENE_SEAM = str(HERE / "seam_3d.prm")
SCENE_MATERIALS = str(HERE / "materials_3d.prm")
SCENE_SOLIDS = str(HERE / "solids_3d.prm")
SCENE_FREE_SOLIDS = str(HERE / "free_solids_3d.prm")
SCENE_POINTS = str(HERE / "cavity_2d.prm")
# leave nothing to the solver's choices
TIGHT = ["Solver/Newton tolerance = 1e-12",
         "Solver/Newton absolute tolerance = 1e-13",
         "Solver/Linear tolerance = 1e-12",
         "Solver/Projection tolerance = 1e-13"]
ROWS = ["statistics.csv", "probes.csv", "probe_bottom.csv", "probe_slow.csv"]
SENSOR_3D = ["Probe foot/Position = 0.1, 0.2, 0", "Probe foot/Diameter = 0.05",
             "Probe foot/Sampling rate = 2000", "Probe foot/Cut-off frequency = 20"]
INDEX = ["grid.pvd", "points.pvd"]


def exact(program, folder, files, interruptions):
    """Byte for byte what the run without interruptions gives."""
    program.run(f"{folder}/whole")
    program.run_until(f"{folder}/parts", interruptions[0])
    for end in interruptions[1:]:
        program.run(f"{folder}/parts", "--restart", "--set",
                    f"Time/End time = {end}")
    text = program.run(f"{folder}/parts", "--restart")
    assert "going on from" in text, text
    require_same_files(f"{folder}/whole", f"{folder}/parts", files + INDEX)
    names = frames(f"{folder}/whole")
    assert names and names == frames(f"{folder}/parts"), "other frames"
    require_same_files(f"{folder}/whole", f"{folder}/parts",
                       [name for name in names if name.endswith(".h5")])
    assert len(checkpoints(f"{folder}/parts")) == 2
    for key in ("errors", "ledger", "steps", "rejected_steps",
                "krylov_iterations"):
        one, other = (summary(f"{folder}/{run}")[key]
                      for run in ("whole", "parts"))
        assert one == other, f"{key}: {one} and {other}"


def progress(folder):
    return json.loads(pathlib.Path(folder, "progress.json").read_text())


def summary(folder):
    with open(f"{folder}/summary.json", encoding="utf-8") as file:
        return json.load(file)


def require_close(folder, other):
    one, two = read_columns(folder), read_columns(other)
    for name in one:
        if "iterations" not in name:
            error = difference(name, one, two)
            assert error <= TOLERANCE, f"{name}: {error:.1e}"


def exact_2d(make, folder, ranks):
    program = make(SCENE_2D, ranks)
    exact(program, folder, ROWS, ["0.235", "0.275"])
    totals = summary(f"{folder}/whole")
    assert totals["rejected_steps"] > 0, "the scene shall repeat a step"
    assert totals["ledger"]["outflow_points"] > 0, "no point has left"


def exact_quadratic(make, folder, ranks):
    exact(make(SCENE_QUADRATIC, ranks), folder, ROWS, ["0.235", "0.275"])


def exact_piston(make, folder, ranks):
    exact(make(SCENE_PISTON, ranks), folder, ["statistics.csv"],
          ["0.15", "0.25"])


def exact_tank(make, folder, ranks):
    """Moved by a table; with another row in it the scene is another one."""
    scene, table = f"{folder}/scene.prm", pathlib.Path(folder) / "roll.csv"
    table.write_text((HERE.parent / "scene/roll.csv").read_text())
    pathlib.Path(scene).write_text(
        f"include {SCENE_TANK}\nsubsection Table roll\n"
        "  set File = roll.csv\nend\n")
    program = make(scene, ranks)
    exact(program, folder, ["statistics.csv"], ["0.13", "0.29"])
    program.run_until(f"{folder}/again", "0.13")
    again = make(f"{folder}/whole/parameters.prm", ranks)  # elsewhere than the table
    again.run(f"{folder}/again", "--restart")
    require_same_files(f"{folder}/whole", f"{folder}/again", ["statistics.csv"])
    table.write_text(table.read_text() + "0.7,1\n")
    text = program.run(f"{folder}/parts", "--restart", code=4)
    assert "Table roll/File" in text and "checksum" in text, text


def exact_tank_on_springs(make, folder, ranks):
    exact(make(SCENE_TANK_ON_SPRINGS, ranks), folder, ["statistics.csv"],
          ["0.055", "0.095"])


def exact_3d(make, folder, ranks):
    exact(make(SCENE_3D, ranks, SENSOR_3D), folder,
          ["statistics.csv", "probe_foot.csv"], ["0.17"])


def exact_ml(make, folder, ranks):
    """No hierarchy has a memory, say of random numbers."""
    exact(make(SCENE_3D, ranks, ["Solver/Multigrid = ML"]), folder,
          ["statistics.csv"], ["0.17"])


def exact_error_control(make, folder, ranks):
    """The size of the next step depends on the steps before."""
    options = ["Time/Step control = error", "Time/Error tolerance = 0.02"]
    exact(make(SCENE_3D, ranks, options), folder, ["statistics.csv"],
          ["0.2325"])
    steps = read_columns(f"{folder}/whole")["dt [s]"]
    assert len({round(dt, 9) for dt in steps}) > 5, steps
    text = make(SCENE_3D, ranks).run(f"{folder}/parts", "--restart", code=4)
    assert '"Time/Step control"' in text, text


def exact_tank_adaptive(make, folder, ranks):
    exact(make(SCENE_TANK, ranks, ["Refinement surface/Criterion = free surface",
                                   "Refinement surface/Level = 1"]),
          folder, ["statistics.csv"], ["0.13", "0.29"])


def exact_tank_quadratic(make, folder, ranks):
    exact(make(SCENE_TANK, ranks, ["Formulation/Element degree = 2"]),
          folder, ["statistics.csv"], ["0.13", "0.29"])


def exact_adaptive(make, folder, ranks):
    """The surface follows from the points alone; its frames go on."""
    options = ["Output/Mean level = true",
               "Run-up right/Wall = right"]
    exact(make(SCENE_ADAPTIVE, ranks, options), folder,
          ["statistics.csv", "surface.pvd"], ["0.13"])
    assert any(name.startswith("surface_") for name in frames(f"{folder}/parts"))


def alarms(make, folder, ranks):
    """They are raised once, before the restart, and the last line still has
    them."""
    program = make(SCENE_CROWDED, ranks, ["Checkpoint/Every steps = 10"])
    program.run_until(f"{folder}/parts", "0.97")
    text = program.run(f"{folder}/parts", "--restart")
    with open(f"{folder}/parts/run.log", encoding="utf-8") as file:
        log = file.read()
    assert log.count("warning: more than 2 %") == 1, log
    assert any("BEWARE: " in line for line in text.strip().split("\n")[-2:]), text
    assert summary(f"{folder}/parts")["alarms"]["overfull"] > 0.02
    # full from 0.18 s on; the checkpoint at 0.2 s knows that it was said
    make(SCENE_GAP, ranks, ["Checkpoint/Every steps = 5"]).run(f"{folder}/gap")
    with open(f"{folder}/gap/run.log", encoding="utf-8") as file:
        log = file.read()
    assert log.count("is closed and full") == 1, log


def exact_box(make, folder, ranks):
    exact(make(SCENE_BOX, ranks), folder, ["statistics.csv"], ["0.07"])


def exact_seam(make, folder, ranks):
    """Points have crossed periodic sides."""
    exact(make(SCENE_SEAM, ranks), folder, ["statistics.csv"], ["0.07"])


def exact_solids(make, folder, ranks):
    """Walls cut cells."""
    exact(make(SCENE_SOLIDS, ranks), folder, ["statistics.csv"], ["0.13"])


def exact_free_solids(make, folder, ranks):
    """A body floats up beside a flap that turns."""
    exact(make(SCENE_FREE_SOLIDS, ranks), folder, ["statistics.csv"], ["0.09"])


def exact_materials(make, folder, ranks):
    """Two fluids; points have been split."""
    exact(make(SCENE_MATERIALS, ranks), folder, ["statistics.csv"], ["0.07"])


def exact_points(make, folder, ranks):
    """Points are shifted, split and merged."""
    exact(make(SCENE_POINTS, ranks), folder, ["statistics.csv"], ["0.47"])
    account = summary(f"{folder}/whole")["point control"]
    assert account == summary(f"{folder}/parts")["point control"], account
    assert account["points split [-]"] > 0, account
    assert account["points merged [-]"] > 0, account


def other_ranks(make, folder, _):
    """On another number of ranks, and without a checkpoint in the run that is
    compared with."""
    options = TIGHT + ["Time/Step control = fixed", "Time/Step = 0.005"]
    make(SCENE_2D, 1, options + ["Checkpoint/Every steps = 0"]).run(
        f"{folder}/whole")
    make(SCENE_2D, 1, options).run_until(f"{folder}/parts", "0.13")
    make(SCENE_2D, 2, options).run(f"{folder}/parts", "--restart", "--set",
                                   "Time/End time = 0.26")
    make(SCENE_2D, 1, options).run(f"{folder}/parts", "--restart")
    require_close(f"{folder}/whole", f"{folder}/parts")


def damaged(make, folder, _):
    """A newest checkpoint that is torn, altered or none at all."""
    program = make(SCENE_2D, 1)
    program.run(f"{folder}/whole")
    program.run_until(f"{folder}/origin", "0.32")
    size = os.path.getsize(checkpoints(f"{folder}/origin")[-1])
    damages = {f"cut at {n}": ("cut", n)
               for n in (0, 1, size // 3, size - 60, size - 1)}
    damages.update({f"byte {n}": ("flip", n)
                    for n in (0, 100, size // 2, size - 30, size - 5)})
    damages["foreign"] = ("text", b"no checkpoint\n" * 100)
    for name, damage in damages.items():
        parts = f"{folder}/parts"
        shutil.rmtree(parts, ignore_errors=True)
        shutil.copytree(f"{folder}/origin", parts)
        newest = checkpoints(parts)[-1]
        apply(damage, newest)
        text = program.run(parts, "--restart")
        assert f"{newest}: it is" in text and "older" in text, f"{name}: {text}"
        require_same_files(f"{folder}/whole", parts, ROWS + INDEX)


def apply(damage, filename):
    kind, what = damage
    if kind == "cut":
        os.truncate(filename, what)
        return
    with open(filename, "r+b") as file:
        if kind == "text":
            file.write(what)
            file.truncate()
            return
        file.seek(what)
        byte = file.read(1)[0]
        file.seek(what)
        file.write(bytes([byte ^ 1]))


def refused(make, folder, _):
    """Nothing to go on from: exit code and message."""
    program, parts = make(SCENE_2D, 1), f"{folder}/parts"
    assert "no checkpoint to restart from" in program.run(
        parts, "--restart", code=2)
    assert not os.path.exists(parts)
    program.run_until(parts, "0.25")

    text = program.run(parts, "--restart", "--set", "Time/End time = 0.1",
                       code=2)
    assert '"End time"' in text and "already" in text, text

    text = make(SCENE_2D, 1, ["Fluid/Density = 900"]).run(
        parts, "--restart", code=4)
    assert text.count("another scene") == 2 and '"Fluid/Density"' in text, text
    text = make(SCENE_2D, 1, ["Output/Mean level = true"]).run(
        parts, "--restart", code=4)  # a column of the table
    assert '"Output/Mean level"' in text, text
    make(SCENE_3D, 1).run_until(f"{folder}/3d", "0.1")
    shutil.copy(checkpoints(f"{folder}/3d")[-1], f"{parts}/checkpoint-000900.h5")
    text = program.run(parts, "--restart", "--set", "Time/End time = 0.26")
    assert "another scene" in text and "older checkpoint" in text, text

    for name in checkpoints(parts):
        apply(("cut", 5000), name)
    text = program.run(parts, "--restart", code=4)
    for name in checkpoints(parts):
        assert f"{name}: it is" in text, text

    program.run_until(parts, "0.25")  # a new run: no old checkpoints
    assert all("00090" not in name for name in checkpoints(parts))
    os.truncate(f"{parts}/statistics.csv", 1000)
    assert "statistics.csv" in program.run(parts, "--restart", code=4)
    os.remove(f"{parts}/statistics.csv")
    os.mkfifo(f"{parts}/statistics.csv")  # would wait for a writer
    assert "not a regular file" in program.run(parts, "--restart", code=4)
    os.remove(f"{parts}/statistics.csv")

    program.run_until(f"{folder}/judged", "0.25")
    judged = make(SCENE_2D, 1, ["Verdict all/Value = steps", "Verdict all/At least = 1"])
    assert "verdict" in judged.run(f"{folder}/judged", "--restart")

    program.run_until(parts, "0.25")
    stuck = f"{parts}/checkpoint-000001.h5"  # no file: cannot be removed
    os.makedirs(f"{stuck}/content")
    text = program.run(parts, "--restart")
    assert f"an old checkpoint stays ({stuck}: " in text, text
    assert "old checkpoint cannot be removed" in program.run(parts, code=4)


def stopped(make, folder, ranks):
    """By signals and by files; the rest of the run is as it would have been."""
    options = TIGHT + ["Checkpoint/Every steps = 0", "Time/Step = 0.004",
                       "Time/Step control = fixed", "Output/Interval = 0"]
    program, parts = make(SCENE_2D, ranks, options), f"{folder}/parts"
    program.run(f"{folder}/whole")

    def stop(action, row, *arguments):
        process = program.start(parts, *arguments)
        wait_for_rows(process, parts, row)
        action(process)
        text = process.communicate(timeout=60)[0]
        assert process.returncode == 5, f"{process.returncode}: {text}"
        assert "stopped; to go on" in text, text
        assert progress(parts)["state"] == "stopped", progress(parts)

    # only finished runs have a summary: an old one goes
    os.makedirs(parts, exist_ok=True)
    open(f"{parts}/summary.json", "w").close()
    if ranks == 1:
        stop(lambda process: process.send_signal(signal.SIGTERM), 10)
        stop(lambda process: process.send_signal(signal.SIGINT), 30, "--restart")
        stop(lambda process: process.send_signal(signal.SIGHUP), 40, "--restart")
        stop(lambda process: process.send_signal(signal.SIGXCPU), 50, "--restart")
    else:
        stop(lambda process: process.send_signal(signal.SIGUSR1), 10)
    assert not os.path.exists(f"{parts}/summary.json")
    stop(lambda _: open(f"{parts}/stop", "w").close(), 60, "--restart")
    assert not os.path.exists(f"{parts}/stop")

    process = program.start(parts, "--restart")
    wait_for_rows(process, parts, 75)
    open(f"{parts}/checkpoint-now", "w").close()
    assert process.wait(timeout=120) == 0, process.communicate()[0]
    assert not os.path.exists(f"{parts}/checkpoint-now")
    require_close(f"{folder}/whole", parts)
    assert progress(parts) == {**progress(parts), "state": "finished", "time": 0.4,
                               "end_time": 0.4, "seconds_left": 0}, progress(parts)


def stopped_by_mpirun(make, folder, ranks):
    """Ctrl-C to all that the terminal runs, SIGTERM and SIGUSR1 to the launcher only:
    with contrib/mpirun as on one rank."""
    program = make(SCENE_2D, ranks, TIGHT + ["Checkpoint/Every steps = 0",
        "Output/Interval = 0", "Time/Step = 0.004", "Time/Step control = fixed"])
    launcher = [os.path.join(HERE, "../../contrib/mpirun"), *program.launcher[1:]]
    whole, parts = f"{folder}/whole", f"{folder}/parts"
    os.environ["MPIRUN"] = program.launcher[0]
    program.run(whole)

    def ctrl_c(process):
        os.killpg(process.pid, signal.SIGINT)

    def term(process):
        process.terminate()

    def usr1(process):
        process.send_signal(signal.SIGUSR1)

    for action, row, arguments in ((ctrl_c, 10, []), (term, 30, ["--restart"]),
                                   (usr1, 50, ["--restart"])):
        process = program.start(parts, *arguments, launcher=launcher, session=True)
        wait_for_rows(process, parts, row)
        action(process)
        text = process.communicate(timeout=60)[0]
        assert process.returncode == 5, f"{process.returncode}: {text}"
        assert "exit code 5 of the program" in text.splitlines()[-1], text
        assert checkpoints(parts)
    program.run(parts, "--restart")
    require_close(whole, parts)


def hung_up(make, folder, ranks):
    """The terminal goes: the run stops with a checkpoint, though nobody can be told."""
    program = make(SCENE_2D, ranks, ["Checkpoint/Every steps = 0", "Output/Interval = 0",
                                     "Time/Step = 0.001", "Time/Step control = fixed"])
    parts = f"{folder}/parts"
    os.environ["MPIRUN"] = program.launcher[0]
    command = [os.path.join(HERE, "../../contrib/mpirun"), *program.launcher[1:],
               *program.command, "--output", parts]
    child, terminal = pty.fork()
    if child == 0:
        os.execvp(command[0], command)
    table = pathlib.Path(parts, "statistics.csv")
    while not table.exists() or table.read_bytes().count(b"\n") < 10:
        assert os.waitpid(child, os.WNOHANG) == (0, 0), "ended before row 10"
        time.sleep(0.01)
    os.close(terminal)
    _, status = os.waitpid(child, 0)
    assert os.waitstatus_to_exitcode(status) == 5, status
    assert checkpoints(parts)


def killed_by_mpirun(make, folder, ranks):
    """A second Ctrl-C ends the ranks at once, also those that do not answer, and says
    so."""
    program = make(SCENE_2D, ranks, ["Checkpoint/Every steps = 0", "Output/Interval = 0",
                                     "Time/Step = 0.0001", "Time/Step control = fixed"])
    launcher = [os.path.join(HERE, "../../contrib/mpirun"), *program.launcher[1:]]
    parts = f"{folder}/parts"
    os.environ["MPIRUN"] = program.launcher[0]

    def ranks_alive():
        found = []
        for entry in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                words = (entry / "cmdline").read_bytes().decode().split("\0")
                if words[0] == program.command[0] and parts in words:
                    found.append(int(entry.name))
            except (OSError, UnicodeDecodeError):
                pass  # it has ended
        return found

    process = program.start(parts, launcher=launcher, session=True)
    wait_for_rows(process, parts, 10)
    hung = ranks_alive()
    assert len(hung) == ranks, ranks_alive()
    for rank in hung:
        os.kill(rank, signal.SIGSTOP)  # would never write a checkpoint
    os.killpg(process.pid, signal.SIGINT)
    time.sleep(1.)
    begin = time.monotonic()
    os.killpg(process.pid, signal.SIGINT)
    text = process.communicate(timeout=60)[0]
    assert time.monotonic() - begin < 10., time.monotonic() - begin
    assert process.returncode == 1, f"{process.returncode}: {text}"
    assert "once more kills it" in text and "killed; what" in text, text
    assert not ranks_alive(), ranks_alive()


def stopped_unread(make, folder, _):
    """Nobody reads the screen any more, as after `seiche ... | head -1`; a second
    signal after the last line does no harm."""
    parts = f"{folder}/parts"
    process = make(SCENE_2D, 1, ["Output/Interval = 0"]).start(parts)
    wait_for_rows(process, parts, 10)
    process.stdout.close()
    assert process.wait(timeout=60) == 5, process.returncode
    assert checkpoints(parts)


def stopped_in_time(make, folder, _):
    """Before its hours are over, and goes on to the end of the unbroken run."""
    options = TIGHT + ["Time/Step = 0.0005", "Time/Step control = fixed",
                       "Output/Interval = 0"]
    program, parts = make(SCENE_2D, 1, options), f"{folder}/parts"
    begin = time.monotonic()
    process = program.start(parts, "--max-hours", "0.0002")
    text = process.communicate(timeout=60)[0]
    assert process.returncode == 5, f"{process.returncode}: {text}"
    assert time.monotonic() - begin < 0.72 + 2., time.monotonic() - begin
    assert "stopped; to go on" in text, text
    program.run(parts, "--restart")


def stopped_at_start(make, folder, _):
    """While the first step is being repeated."""
    parts = f"{folder}/parts"
    options = ["Checkpoint/Every steps = 0", "Time/Step control = fixed",
               "Output/Interval = 0"]
    tries = ["Time/Step = 1", "Time/Maximum displacement = 0.001"]  # many
    process = make(SCENE_2D, 1, options + tries).start(parts)
    wait_for_rows(process, parts, 1)
    process.send_signal(signal.SIGTERM)
    text = process.communicate(timeout=60)[0]
    assert process.returncode == 5, f"{process.returncode}: {text}"
    assert [os.path.basename(c) for c in checkpoints(parts)] == [
        "checkpoint-000000.h5"], checkpoints(parts)
    text = make(SCENE_2D, 1, options + ["Time/Step = 0.005"]).run(
        parts, "--restart", "--set", "Time/End time = 0.02")
    assert "going on from" in text, text


CASES = {"exact_2d": (exact_2d, 1), "exact_2d_2_ranks": (exact_2d, 2),
         "exact_quadratic": (exact_quadratic, 1),
         "exact_quadratic_2_ranks": (exact_quadratic, 2),
         "exact_piston": (exact_piston, 1),
         "exact_tank": (exact_tank, 1), "exact_tank_2_ranks": (exact_tank, 2),
         "exact_tank_on_springs": (exact_tank_on_springs, 1),
         "exact_tank_on_springs_2_ranks": (exact_tank_on_springs, 2),
         "exact_tank_adaptive": (exact_tank_adaptive, 1),
         "exact_tank_adaptive_2_ranks": (exact_tank_adaptive, 2),
         "exact_tank_quadratic": (exact_tank_quadratic, 1),
         "exact_3d": (exact_3d, 1), "exact_3d_2_ranks": (exact_3d, 2),
         "exact_ml_2_ranks": (exact_ml, 2),
         "exact_error_control_2_ranks": (exact_error_control, 2),
         "exact_adaptive_2_ranks": (exact_adaptive, 2),
         "alarms": (alarms, 1),
         "exact_box_2_ranks": (exact_box, 2),
         "exact_seam": (exact_seam, 1), "exact_seam_2_ranks": (exact_seam, 2),
         "exact_solids": (exact_solids, 1), "exact_solids_2_ranks": (exact_solids, 2),
         "exact_free_solids": (exact_free_solids, 1), "exact_free_solids_2_ranks": (exact_free_solids, 2),
         "exact_materials": (exact_materials, 1),
         "exact_materials_2_ranks": (exact_materials, 2),
         "exact_points": (exact_points, 1),
         "exact_points_2_ranks": (exact_points, 2),
         "other_ranks": (other_ranks, 1), "damaged": (damaged, 1),
         "refused": (refused, 1), "stopped": (stopped, 1),
         "stopped_at_start": (stopped_at_start, 1),
         "stopped_unread": (stopped_unread, 1),
         "stopped_in_time": (stopped_in_time, 1),
         "stopped_2_ranks": (stopped, 2),
         "stopped_by_mpirun_2_ranks": (stopped_by_mpirun, 2),
         "hung_up_2_ranks": (hung_up, 2),
         "killed_by_mpirun_2_ranks": (killed_by_mpirun, 2)}


def main():
    seiche, mpirun, name = sys.argv[1:]
    case, ranks = CASES[name]

    def make(scene, n, options=()):
        return Program(seiche, mpirun, scene, n, options)

    with tempfile.TemporaryDirectory() as folder:
        case(make, folder, ranks)
    print(f"{name}: as it should be")


if __name__ == "__main__":
    main()
