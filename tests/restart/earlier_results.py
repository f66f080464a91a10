#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run in a folder with results of an earlier run.

earlier_results.py SEICHE MPIRUN CASE [KILL_AT_CALL]
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from runs import Program

SCENE = str(pathlib.Path(__file__).resolve().parent / "dam_break_2d.prm")
STEPS = ["Time/Step = 0.005", "Time/Step control = fixed", "Checkpoint/Every steps = 2"]
ONE, SHORT, LONG = (STEPS + [f"Time/End time = {end}"] for end in (0.005, 0.02, 0.03))
PLENTY = ["Output/Interval = 0.01", "Output/Surface = true", "Output/Point series = true"]
FAILS = ["Time/Maximum displacement = 0.001", "Time/Minimum step = 0.005",
         "Body force/Acceleration = 0; -1000"]
MARK = "moved-here.txt"


def content(folder):
    """Every file of a folder but locks and the mark."""
    root = pathlib.Path(folder)
    return {str(path.relative_to(root)): path.read_bytes() if path.is_file() else None
            for path in sorted(root.rglob("*")) if path.name not in (".lock", MARK)}


def beside(folder):
    """Which of the folders beside it there are."""
    return {end for end in ("moving", "old", "older") if os.path.exists(f"{folder}.{end}")}


def moved(make, folder, ranks):
    """Everything that a run has written goes, nothing else does; a run that fails at
    once displaces no results."""
    rich, poor, broken = (make(SHORT + more, ranks)
                          for more in (PLENTY, ["Output/Interval = 0"], FAILS))
    parts = f"{folder}/parts"
    poor.run(f"{folder}/alone")
    text = rich.run(parts)
    assert "earlier run" not in text, text
    first = content(parts)
    assert any(name.startswith("surface_") for name in first), sorted(first)

    pathlib.Path(parts, "notes.txt").write_text("mine\n")
    pathlib.Path(parts, "grid_000001.vtu.bak").write_text("mine\n")
    text = poor.run(parts)
    assert f"the results of an earlier run are now in {parts}.old" in text, text
    assert content(f"{parts}.old") == first, "not all has been moved"
    os.remove(f"{parts}/notes.txt")
    os.remove(f"{parts}/grid_000001.vtu.bak")
    # a file of a run that is missing in EarlierResults would be left over here
    assert content(parts).keys() == content(f"{folder}/alone").keys(), (
        content(parts).keys() ^ content(f"{folder}/alone").keys())
    assert beside(parts) == {"old"}

    second = content(parts)
    for _ in range(2):
        text = broken.run(parts, code=3)
        assert content(f"{parts}.old") == second, "displaced by a failed run"
        assert content(f"{parts}.older") == first, "removed by a failed run"
    assert f"earlier run are in {parts}.old" in text, text
    assert "failure/points_000000" in "".join(content(parts)), "no evidence"
    text = broken.run(parts, "--restart", code=2)
    assert f"{parts}.old" in text, text

    rich.run(parts)
    assert content(f"{parts}.old") == second and beside(parts) == {"old"}
    assert "failure" not in content(parts)
    # the results that were moved can be gone on with where they are
    text = make(LONG, ranks).run(f"{parts}.old", "--restart")
    assert "going on from" in text, text
    text = poor.run(parts, code=4)
    assert "not a folder that a run has moved results to" in text, text

    # somebody else's file of that name is not a run without a step
    other = f"{folder}/other"
    os.mkdir(other)
    pathlib.Path(other, "statistics.csv").write_text("my,header\n1,2\n")
    text = poor.run(other)
    assert f"now in {other}.old" in text, text
    assert content(f"{other}.old") == {"statistics.csv": b"my,header\n1,2\n"}


def names(make, folder, _):
    """x/, . and a link name the folder itself."""
    program = make(SHORT + ["Output/Interval = 0"], 1)
    real = f"{folder}/disk/real"
    program.run(real)
    os.symlink(real, f"{folder}/link")
    for name in (f"{real}/", f"{real}/.", f"{folder}/link", f"{folder}/link/"):
        first = content(real)
        program.run(name)
        assert content(f"{real}.old") == first, name
        assert beside(real) == {"old"} and not beside(f"{folder}/link"), name
    first = content(real)
    subprocess.run([*program.command, "--output", "."], cwd=real, check=True,
                   stdout=subprocess.DEVNULL)
    assert content(f"{real}.old") == first


def refused(make, folder, _):
    """Where nothing can be moved, nothing is touched."""
    program = make(SHORT + ["Output/Interval = 0"], 1)
    parts = f"{folder}/parts"
    program.run(parts)
    first = content(parts)
    for end in ("moving", "old", "older"):
        pathlib.Path(f"{parts}.{end}").mkdir()
        pathlib.Path(f"{parts}.{end}", "statistics.csv").write_text("mine\n")
        text = program.run(parts, code=4)
        assert f"{parts}.{end}: " in text and "--output" in text, text
        assert content(parts) == first, end
        assert content(f"{parts}.{end}") == {"statistics.csv": b"mine\n"}, end
        shutil.rmtree(f"{parts}.{end}")

    os.chmod(folder, 0o555)
    is_root = os.geteuid() == 0
    if is_root:  # who may write everywhere
        for path in [parts, *map(str, pathlib.Path(parts).rglob("*"))]:
            os.chown(path, 65534, 65534)
    process = subprocess.run([*program.command, "--output", parts], text=True,
                             capture_output=True, cwd=parts,
                             preexec_fn=(lambda: os.setuid(65534)) if is_root else None)
    os.chmod(folder, 0o755)
    assert process.returncode == 4, process
    assert "Permission denied" in process.stderr, process.stderr
    assert content(parts) == first


def killed(make, folder, _):
    """Just before each call that renames or removes something: what was there is
    there, and both ways of going on find it."""
    one, program, longer = (make(time + ["Output/Interval = 0"], 1)
                            for time in (ONE, SHORT, LONG))
    parts, origin = f"{folder}/parts", f"{folder}/origin"
    one.run(origin)
    program.run(origin)
    last, before = content(origin), content(f"{origin}.old")
    shutil.copytree(origin, f"{folder}/went_on")
    longer.run(f"{folder}/went_on", "--restart")
    call, restarts = 0, 0
    while True:
        call += 1
        for end in ("", ".moving", ".old", ".older"):
            shutil.rmtree(parts + end, ignore_errors=True)
        shutil.copytree(origin, parts)
        shutil.copytree(f"{origin}.old", f"{parts}.old")
        process = subprocess.run(
            [*one.command, "--output", parts], capture_output=True, text=True,
            env={**os.environ, "LD_PRELOAD": sys.argv[4], "KILL_IN": parts,
                 "KILL_AT": str(call)})
        if process.returncode == 0:
            break
        assert process.returncode == -9, f"{process.returncode}: {process.stderr}"
        here = content(parts) if os.path.exists(parts) else {}
        has_step = here.get("statistics.csv", b"").count(b"\n") > 2
        places = [content(f"{parts}.{end}") if os.path.exists(f"{parts}.{end}") else {}
                  for end in ("moving", "old", "older")]
        is_here = last.items() <= {**places[0], **here}.items()
        assert is_here or last == places[1], f"call {call}: results are lost"
        assert has_step or before in places[1:], f"call {call}: older ones are lost"
        if call % 3:
            continue  # each third is gone on with
        if is_here and call % 2:
            restarts += 1
            longer.run(parts, "--restart")
            assert (content(parts)["statistics.csv"]
                    == content(f"{folder}/went_on")["statistics.csv"]), f"call {call}"
        elif not has_step:
            text = "" if is_here else one.run(parts, "--restart", code=2)
            assert is_here or f"{parts}.old" in text, f"call {call}: {text}"
            one.run(parts)
            assert content(f"{parts}.old") == last, f"call {call}"
            assert beside(parts) == {"old"}, f"call {call}"
    assert restarts > 1, "hardly anything was killed"
    print(f"killed before {call - 1} calls, {restarts} restarts")


CASES = {"moved": (moved, 1), "moved_2_ranks": (moved, 2), "names": (names, 1),
         "refused": (refused, 1), "killed": (killed, 1)}


def main():
    seiche, mpirun, name = sys.argv[1:4]
    case, ranks = CASES[name]

    def make(options, n):
        return Program(seiche, mpirun, SCENE, n, options)

    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        case(make, folder, ranks)
    print(f"{name}: as it should be")


if __name__ == "__main__":
    main()
