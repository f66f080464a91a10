#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Does --validate foretell what a run needs, fast, and refuse what cannot be?

sizes: runs shipped scenes for a while; cells, points, steps, memory, files and
processor time must be those of the plan within a factor of two. steps: of walls
and tanks that move. dearer: what viscosity and formulas add. limits: grids and
clouds of 10^8, too many steps, full disks, years. bodies: small ones. doubts: scales
and warnings, as those of the run. picture: the SVG.
"""

import argparse
import json
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

from scenes import box_scene

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRM = ROOT / "prm"
SECONDS = {"s": 1., "min": 60., "h": 3600., "days": 86400., "years": 3.156e7}
BYTES = {"B": 1., "kB": 1e3, "MB": 1e6, "GB": 1e9, "TB": 1e12}

SCENES = [  # 2D and 3D, both forms, degree 2, an adaptive mesh, frames
    ("benchmarks/dam_break_2d/dam_break_2d.prm", "Time/End time = 0.5"),
    ("verification/sloshing_level.prm", "Time/End time = 3"),
    ("verification/elliptic_drop.prm", "Formulation/Element degree = 2",
     "Time/End time = 0.05"),
    ("verification/compressible_column.prm", "Time/End time = 0.2"),
    ("verification/standing_wave_small_3d.prm", "Time/End time = 0.3"),
    ("benchmarks/marin_box/marin_box.prm", "Time/End time = 0.05"),
    ("verification/manufactured_compressible.prm", "Time/End time = 0.1"),
]

# What is dearer than the water of the first one: viscosity, formulas of a force.
USUAL = ("verification/standing_wave_small_3d.prm", "Time/End time = 0.3")
DEARER = [
    ("benchmarks/viscous_column_3d/viscous_column_3d.prm", "Time/End time = 0.5"),
    ("verification/viscous_current.prm", "Time/End time = 5"),
    ("verification/manufactured_compressible.prm",),
]

BOX = box_scene("2, 1, 1", water="1, 1, 0.5", end="1")
POND = (box_scene("1, 0.3", "0.025", "1, 0.1", end="0.25", step="0.05")
        + "subsection Time\n  set Step control = CFL\nend\n")


def run(program, scene, overrides, folder, *options):
    """Result, processor time [s] and memory [bytes] of the call."""
    command = [program, str(scene), "--output", str(folder / "run"), *options]
    for text in overrides:
        command += ["--set", text]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, cwd=folder) as process:
        out, err = process.communicate(timeout=500)
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return process.returncode, out, err, usage


def plan_of(text):
    """The figures of a plan."""
    found = re.search(
        r"(\S+) cells, about (\S+) of them with fluid, about (\S+) points, "
        r"(?:at least|about) (\S+) steps", text)
    cost = re.search(
        r"(?:at least|about) (\S+) (\S+) of processor time, (\S+) (\S+) of memory, "
        r"(\S+) (\S+) of files", text)
    cells, occupied, points, steps = (float(x) for x in found.groups())
    return {"cells": cells, "occupied": occupied, "points": points, "steps": steps,
            "seconds": float(cost[1]) * SECONDS[cost[2]],
            "memory": float(cost[3]) * BYTES[cost[4]],
            "files": float(cost[5]) * BYTES[cost[6]]}


def size_of(folder):
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def check_sizes(program, problems):
    sums = {"foretold": 0., "taken": 0.}
    for name, *overrides in SCENES:
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            code, out, err, _ = run(program, PRM / name, overrides, folder,
                                    "--validate")
            if code:
                problems.append(f"{name}: not valid: {err}")
                continue
            plan = plan_of(out)
            code, _, err, _ = run(program, PRM / name, overrides, folder)
            if code:
                problems.append(f"{name}: the run failed: {err}")
                continue
            real = json.loads((folder / "run/summary.json").read_text())
            real = {"cells": real["cells"], "occupied": real["occupied_cells_max"],
                    "points": real["points"], "steps": real["steps"],
                    "seconds": real["cpu_seconds"],
                    "memory": real["peak_memory_mib"] * 2**20,
                    "files": size_of(folder / "run")}
        sums["foretold"] += plan["seconds"]
        sums["taken"] += real["seconds"]
        for key, value in plan.items():
            # the cores of a test may be shared: their sum is what is judged
            limit = {"seconds": 4., "points": 1.03}.get(key, 2.)
            if not 1. / limit <= value / real[key] <= limit:
                problems.append(f"{name}: {key} {value:g} foretold, {real[key]:g} "
                                "taken")
        print(name, " ".join(f"{key} {value / real[key]:.2f}"
                             for key, value in plan.items()))
    share = sums["foretold"] / sums["taken"]
    print(f"processor time foretold over taken, all scenes: {share:.2f}")
    if not 0.5 <= share <= 2.:
        problems.append(f"processor time {share:.2f} of what was taken")


MOVING_WALLS = [  # shallow water, so that it is the wall that limits the steps
    ("a piston", "subsection Walls\n"
     "  set Left displacement = 0.05*(1 - cos(2*pi*t/0.25))\nend\n"),
    ("a belt", "subsection Walls\n  set Bottom = no-slip\n"
     "  set Bottom velocity = 3*min(t/0.02, 1); 0\nend\n"),
    ("a tank", "subsection Tank motion\n"
     "  set Displacement = 0.1*sin(2*pi*t/0.4); 0\nend\n"),
    ("a roll", "subsection Tank motion\n"
     "  set Rotation = 0.2*sin(2*pi*t/0.4)\n  set Centre = 0.5, -0.5\nend\n"),
]


def check_steps(program, problems):
    """Of the CFL number, where walls and tanks move faster than the water falls."""
    for what, motion in MOVING_WALLS:
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            scene = folder / "scene.prm"
            scene.write_text(POND + motion)
            code, out, err, _ = run(program, scene, [], folder, "--validate")
            if code:
                problems.append(f"{what}: {out}{err}")
                continue
            foretold = plan_of(out)["steps"]
            code, out, err, _ = run(program, scene, [], folder)
            if code:
                problems.append(f"{what}: the run: {err}")
                continue
            taken = json.loads((folder / "run/summary.json").read_text())["steps"]
            print(f"{what}: {foretold:g} steps foretold, {taken} taken")
            if not 0.5 <= foretold / taken <= 2.:
                problems.append(f"{what}: {foretold:g} steps foretold, {taken} taken")
            if "walls move with up to" not in out:
                problems.append(f"{what}: the banner does not say how fast: " + out.split("\n")[2])


def share_foretold(program, name, overrides):
    """Processor time foretold over that taken."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        _, out, _, _ = run(program, PRM / name, overrides, folder, "--validate")
        code, _, err, _ = run(program, PRM / name, overrides, folder)
        if code:
            raise RuntimeError(f"{name}: the run failed: {err}")
        summary = json.loads((folder / "run/summary.json").read_text())
        return plan_of(out)["seconds"] / summary["cpu_seconds"]


def check_dearer(program, problems):
    """Beside a usual run before each of them, for the cores may be shared, within a
    factor of two; what others do on the cores is not the same in three attempts."""
    for name, *overrides in DEARER:
        for _ in range(3):
            usual = share_foretold(program, USUAL[0], USUAL[1:])
            share = share_foretold(program, name, overrides) / usual
            print(f"{name}: {share:.2f} of the time taken foretold, beside a usual run")
            if 0.5 <= share <= 2.:
                break
        else:
            problems.append(f"{name}: {share:.2f} of the time taken foretold")


def expect(problems, program, folder, overrides, code, *texts, body=BOX):
    """Call --validate; problems if it does not end as expected."""
    scene = folder / "scene.prm"
    scene.write_text(body)
    got, out, err, usage = run(program, scene, overrides, folder, "--validate")
    if got != code and code is not None:
        problems.append(f"{overrides}: exit code {got}, not {code}: {out}{err}")
    for text in texts:
        if text not in out + err:
            problems.append(f"{overrides}: the answer lacks {text!r}: {out}{err}")
    return usage


def check_limits(program, problems):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        # 5 * 10^8 cells with 10^10 points fit nowhere; 10^8 of either may
        huge = ["Grid/Cell size = 0.0016"]
        for code, overrides in (
                (2, huge),
                (None, ["Grid/Cell size = 0.00271",
                        "Fluid body column/Upper corner = 0.1, 0.1, 0.1"]),
                (None, ["Grid/Cell size = 0.02",
                        "Points/Per cell and direction = 12"]),
                (None, ["Grid/Cells x = 2000001", "Grid/Cells y = 7",
                        "Grid/Cells z = 7"])):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            usage = expect(problems, program, folder, overrides, code, "memory")
            seconds = usage.ru_utime + usage.ru_stime - (before.ru_utime +
                                                         before.ru_stime)
            print(f"{overrides[0]}: {seconds:.2f} s, {usage.ru_maxrss / 1e3:.0f} MB")
            if seconds > 2. or usage.ru_maxrss > 300e3:
                problems.append(f"{overrides}: {seconds} s, {usage.ru_maxrss} kB")
        expect(problems, program, folder, huge, 2, "larger cells")
        expect(problems, program, folder, ["Time/End time = 1e300"], 2, "2^32 steps")
        expect(problems, program, folder, ["Time/End time = 4e7", "Grid/Cell size = 0.05"], 0,
               "years of processor time")
        expect(problems, program, folder,
               ["Time/End time = 1000", "Output/Interval = 0.001",
                "Grid/Cell size = 0.03", "Output/Point series = true"], 0,
               "free: make Output/Interval longer")
        expect(problems, program, folder,
               ["Fluid body column/Upper corner = 1e-4, 1e-4, 1e-4"], 2,
               "no material point")
        expect(problems, program, folder, [], 0,
               "0.098 m in x, between 0 and 0.49 m, by Grid/Cell size, "
               "Obstacle post/Lower corner",
               body=BOX + "subsection Obstacle post\n"
               "  set Lower corner = 0.49, 0.4, 0\n"
               "  set Upper corner = 0.6, 0.6, 1\nend\n")


SMALL_BODIES = [  # in cells between lines of the map, beside many obstacles
    (2, "4, 2", 0.01, "2, 1", 0.011, 0),
    (3, "1, 1, 1", 0.02, "0.5, 0.5, 0.5", 0.024, 0),
    (3, "1, 1, 1", 0.02, "0.51, 0.5, 0.5", 0.024, 18),
]


def drop_in_a_box(upper, size, shape, obstacles):
    """A scene of one drop, and a row of obstacles away from it."""
    text = box_scene(upper, size, end="1e-4", step="1e-4", shape=shape)
    dim = upper.count(",") + 1
    for i in range(obstacles):
        lower = ", ".join([f"{0.04 * i + 0.1:g}", "0.1", "0"][:dim])
        end = ", ".join([f"{0.04 * i + 0.12:g}", "0.2", "0.1"][:dim])
        text += (f"subsection Obstacle o{i}\n  set Lower corner = {lower}\n"
                 f"  set Upper corner = {end}\nend\n")
    return text


def check_films(program, problems):
    """A film thinner than the spacing of the points holds a layer of them."""
    for thickness in ("0.002", "0.02", "0.0429"):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            scene = folder / "scene.prm"
            scene.write_text(dam(body=f"1, {thickness}", end="1e-3", step="1e-3"))
            foretold = plan_of(run(program, scene, [], folder, "--validate")[1])["points"]
            run(program, scene, [], folder)
            points = json.loads((folder / "run/summary.json").read_text())["points"]
            print(f"film of {thickness} m: {foretold:g} points foretold, {points} taken")
            if not 0.7 < foretold / points < 1.4:
                problems.append(f"film: {foretold} points foretold, {points} taken")


def check_bodies(program, problems):
    """Small bodies are valid, and the plan knows the points of those with a box."""
    check_films(program, problems)
    for dim, upper, size, centre, radius, obstacles in SMALL_BODIES:
        ball = "+".join(f"({x}-{c})^2" for x, c in zip("xyz", centre.split(", ")))
        for shape in (f"set Shape = ball\nset Centre = {centre}\nset Radius = {radius}",
                      f"set Shape = expression\nset Expression = {ball} - {radius}^2"):
            what = f"{dim}D {shape.split()[3]} beside {obstacles} obstacles"
            with tempfile.TemporaryDirectory() as folder:
                folder = pathlib.Path(folder)
                scene = folder / "scene.prm"
                scene.write_text(drop_in_a_box(upper, size, shape, obstacles))
                code, out, err, _ = run(program, scene, [], folder, "--validate")
                if code:
                    problems.append(f"{what}: {out}{err}")
                    continue
                if "ball" not in shape or dim == 3:
                    continue  # unseen, or too many cells for this test
                foretold = plan_of(out)["points"]
                code, _, err, _ = run(program, scene, [], folder)
                if code:
                    problems.append(f"{what}: the run: {err}")
                    continue
                points = json.loads((folder / "run/summary.json").read_text())["points"]
                print(f"{what}: {foretold:g} points foretold, {points} taken")
                if not 0.7 < foretold / points < 1.4:
                    problems.append(f"{what}: {foretold} points foretold, {points} taken")


def dam(upper="1, 0.5", cell="0.05", body="1, 0.2", end="0.01", step="0.01",
        force="0; -9.81", more=""):
    """A scene in 2D of one body."""
    return box_scene(upper, cell, body, end, step, gravity=force, more=more)


def roll(angle):
    return f"end\nsubsection Tank motion\n  set Rotation = {angle}\n"


DOUBTFUL = [  # what is said, what is not, the scene
    (["430 kg of fluid, depth 0.43 m (22 cells)"], ["warning"], dam(body="1, 0.43", cell="0.02")),
    (["about 0.5 m (10 cells), sqrt(g H) 2.2 m/s"], ["warning"],
     dam(upper="1, 1", more="  set Shape = expression\n"
         "  set Expression = y - 0.5 + 0.001*cos(3*x)\n").replace(
             "  set Lower corner = 0, 0\n  set Upper corner = 1, 0.2\n", "")),
    (["warning: the body force points upwards"], [], dam(force="0; 9.81")),
    (["warning: the body force points to a wall at the side"], [],
     box_scene("1, 1, 1", water="0.4, 0.4, 0.4", cell="0.2", end="0.01",
               gravity="0; -9.81; 0")),
    ([], ["warning"], dam(force="-9.81; 0")),
    (["warning: Tracked point far lies outside"], ["Tracked point near"],
     dam() + "subsection Tracked point far\n  set Position = 0.9, 0.4\nend\n"
     "subsection Tracked point near\n  set Position = 0.9, 0.21\nend\n"),
    (["warning: the fluid is compressed by 20 %", "Bulk modulus should be 1.1e+04 Pa"], [],
     dam().replace("= infinite", "= 5000")),
    ([], ["compressed"], dam().replace("= infinite", "= 1.1e4")),
    (["fastest 500 m/s", "warning: the fluid starts with 500 m/s"], [],
     dam(more="  set Velocity = 500; 0\n", step="1e-6", end="1e-6")),
    (["warning: the tank turns by 229 degrees", "radians"], ["upwards"],
     dam(more=roll("4*sin(2*pi*t/1.63)"), end="2")),
    (["warning: the tank turns by 180 degrees"], ["upwards"], dam(more=roll("pi"))),
    (["in steps of 0.01 s"], ["warning"], dam(more=roll("0.07*sin(2*pi*t/1.63)"), end="2")),
    (["warning: the fluid moves by 8e-13 cells in a step", "Fluid/Dynamic viscosity = 8e+07"],
     [], dam().replace("viscosity = 0.001", "viscosity = 1e14")),
]


def check_doubts(program, problems):
    """Scales and warnings are those of the run; forces that are no numbers."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        scene = folder / "scene.prm"
        for texts, absent, text in DOUBTFUL:
            scene.write_text(text)
            code, out, err, _ = run(program, scene, [], folder, "--validate")
            problems += [f"lacks {t!r}: {out}{err}" for t in texts if t not in out + err]
            problems += [f"has {t!r}: {out}{err}" for t in absent if t in out + err]
            if code:
                problems.append(f"{texts}: exit code {code}: {err}")
                continue
            said = subprocess.run([program, "scene.prm", "--output", "run"], cwd=folder,
                                  text=True, capture_output=True, check=False).stdout
            for line in (out + err).splitlines():
                if ("depth" in line or "warning" in line) and line.strip() not in said:
                    problems.append(f"the run does not say {line!r}: {said}")
        expect(problems, program, folder, [], 2, "component 2 is not finite",
               '"Acceleration" in "Body force"', body=dam(force="0; -9.81*sqrt(0.9-x)"))
        expect(problems, program, folder, [], 0, "is valid",
               body=dam(force="0; -9.81*sqrt(0.9-x)", body="0.8, 0.2"))


def texts_that_cover(file):
    """Pairs of texts of a picture, of which one covers the other."""
    space = "{http://www.w3.org/2000/svg}"
    boxes = []
    for element in xml.etree.ElementTree.parse(file).getroot().iter(space + "text"):
        width = 6.5 * len(element.text)
        left = float(element.get("x")) - width * {"start": 0, "middle": .5, "end": 1}[
            element.get("text-anchor", "start")]
        boxes.append((left, left + width, float(element.get("y")), element.text))
    return [(a[3], b[3]) for i, a in enumerate(boxes) for b in boxes[:i]
            if a[0] < b[1] - 1 and b[0] < a[1] - 1 and abs(a[2] - b[2]) < 12]


def check_picture(program, problems):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "many.prm").write_text(dam(more="end\n" + "".join(
            f"subsection Probe sensor {i}\n  set Position = {0.3 + 0.02 * i:g}, 0.01\nend\n"
            f"subsection Gauge long {i}\n  set Position = {0.3 + 0.02 * i:g}, 0\nend\n"
            f"subsection Obstacle post {i}\n  set Lower corner = {0.5 + 0.1 * i:g}, 0.2\n"
            f"  set Upper corner = {0.55 + 0.1 * i:g}, 0.25\nend\n"
            for i in range(4))[:-4]))
        code, out, err, _ = run(program, folder / "many.prm", [], folder, "--validate")
        problems += [f"small things: {code} {out}{err}"] if code else [
            f"texts cover each other: {pair}" for pair in texts_that_cover(folder / "run.svg")]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for name, texts in (
                ("benchmarks/marin_box/marin_box.prm",
                 ["x [m]", "y [m]", "z [m]", "box", "P1", "H1", "slip", "open"]),
                ("verification/wave_maker.prm",
                 ["x [m]", "y [m]", "near", "far", "moving wall"]),
                ("verification/progressive_wave.prm", ["periodic", "slip"]),
                ("verification/elliptic_drop.prm", ["x [m]"]),
                ("verification/internal_wave.prm", ["water", "oil"])):
            code, out, err, _ = run(program, PRM / name, [], folder, "--validate")
            file = folder / "run.svg"
            if code or not file.is_file() or str(file) not in out:
                problems.append(f"{name}: no picture: {out}{err}")
                continue
            root = xml.etree.ElementTree.parse(file).getroot()
            space = "{http://www.w3.org/2000/svg}"
            found = [element.text for element in root.iter(space + "text")]
            problems += [f"{name}: the picture lacks {text!r}" for text in texts
                         if text not in found]
            if any(not element.get("style") for element in root.iter(space + "line")):
                problems.append(f"{name}: a line without style")
            paths = list(root.iter(space + "path"))
            fluids = {element.get("style") for element in paths}
            if len(fluids) != 1 + ("oil" in texts):
                problems.append(f"{name}: fluids in the colours {fluids}")
            water = [element.get("d") for element in paths]
            if not any(len(path) > 100 for path in water):
                problems.append(f"{name}: no water in the picture")
            if file.stat().st_size > 3e6:
                problems.append(f"{name}: {file.stat().st_size} bytes")
            file.unlink()
        scene = folder / "scene.prm"
        scene.write_text(BOX)
        # beside the folder, however it is named
        for ending in ("/", "/."):
            said = subprocess.run([program, "scene.prm", "--validate", "--output",
                                   "there" + ending], cwd=folder, text=True,
                                  capture_output=True, check=False)
            if "there.svg" not in said.stdout or not (folder / "there.svg").is_file():
                problems.append(f"--output there{ending}: {said}")
            (folder / "there.svg").unlink(missing_ok=True)
        # the answer comes even where no picture can be written
        (folder / "run.svg").mkdir()
        code, out, err, _ = run(program, scene, [], folder, "--validate")
        if code or "is valid" not in out or "no picture" not in err:
            problems.append(f"a folder run.svg: {code} {out}{err}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    checks = {"sizes": check_sizes, "steps": check_steps, "dearer": check_dearer,
              "limits": check_limits, "bodies": check_bodies, "doubts": check_doubts,
              "picture": check_picture}
    parser.add_argument("group", choices=checks)
    options = parser.parse_args()
    problems = []
    checks[options.group](str(options.program.resolve()), problems)
    for problem in problems:
        print("FAILED:", problem)
    return 1 if problems else 0


sys.exit(main())
