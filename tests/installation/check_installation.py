#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user has who does not build Seiche (one case a call)."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

CASE, PROGRAM, SOURCE, BUILD = sys.argv[1], *map(pathlib.Path, sys.argv[2:5])


def run(*command, code=0, **options):
    """Standard output and error together; the exit code must be `code`."""
    result = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, check=False, **options)
    if result.returncode != code:
        sys.exit(f"exit code {result.returncode} instead of {code} of {command}:\n{result.stdout}")
    return result.stdout


def require(condition, text):
    if not condition:
        sys.exit(text)


def names_of_examples():
    lines = run(PROGRAM, "--example").split("\n\n")[0].splitlines()
    return [line.split()[0] for line in lines]


def version(_):
    text = run(PROGRAM, "--version")
    project = re.search(r"project\(seiche VERSION ([\d.]+)",
                        (SOURCE / "CMakeLists.txt").read_text()).group(1)
    require(text.startswith(f"seiche {project}\n"), f"not version {project}:\n{text}")
    for name, pattern in [("deal.II", r"9\.\d"), ("Trilinos", r"\d+\.\d"), ("p4est", r"2\.\d"),
                          ("HDF5", r"1\.\d"), ("MPI", r"Open MPI v\d"), ("Boost", r"1\.\d"),
                          ("HYPRE", r"2\.\d"), ("CHOLMOD", r"\d\.\d"), ("compiler", r"\d+\.\d"),
                          ("build", r"(Release|Debug) .*-Wall")]:
        require(re.search(rf"^  {re.escape(name)} +{pattern}", text, re.M),
                f"no line '{name} {pattern}' in\n{text}")
    for file in ("CITATION.cff", "CHANGELOG.md"):
        require(project in (SOURCE / file).read_text(), f"{file} does not know {project}")


def loaded(program):
    """Name and path of each library that the loader finds for a program."""
    return dict(re.findall(r"(lib\S+) => (\S+)", run("ldd", program)))


def require_left_out(program, folder):
    """Of the libraries that no scene needs the program loads empty ones, in
    `folder`, and not what those draw in."""
    pattern = re.compile(rf"lib({cached('SEICHE_LEAVE_OUT')})\.so")
    libraries = loaded(program)
    needed = loaded(next(path for name, path in libraries.items() if "deal.ii" in name))
    for name in filter(pattern.match, libraries):
        require(pathlib.Path(libraries[name]).resolve().parent == folder.resolve(),
                f"{name} is {libraries[name]}")
    without = set(needed) - set(libraries)
    require(bool(without) == any(map(pattern.match, needed)), f"left out: {without}")


def libraries(_):
    require_left_out(PROGRAM, BUILD / "left_out")


def options(_):
    """Known to --help, to the usage of a mistake and to the manual alike."""
    names = re.findall(r"^  (?:-h,)?(--[\w-]+)", run(PROGRAM, "--help"), re.M)
    require(len(names) > 8, f"{names}")
    usage = run(PROGRAM, code=2).split("Usage: ")[1].strip()
    page = (SOURCE / "doc/command_line.md").read_text()
    require(f"\nbuild/{usage}\n" in page, f"doc/command_line.md lacks\n{usage}")
    for name in names:
        require(f"[{name}" in usage and (f"| `{name}" in page or name == "--help"), name)
        mistyped = run(PROGRAM, name + "x", code=2)
        require(f'did you mean "{name}"' in mistyped, mistyped)


def examples(folder):
    names = names_of_examples()
    shipped = sorted(file.stem for file in (SOURCE / "prm/examples").glob("*.prm"))
    require(sorted(names) == shipped, f"{names} are not prm/examples: {shipped}")
    for name in names:
        text = run(PROGRAM, "--example", name)
        require(text == (SOURCE / f"prm/examples/{name}.prm").read_text(), f"{name} differs")
        (folder / f"{name}.prm").write_text(text)
        # alone in its folder: it needs no other file
        printed = run(PROGRAM, f"{name}.prm", "--validate", cwd=folder)
        require("is valid" in printed and "warning" not in printed, printed)
    # the first steps of each
    for name in names:
        run(PROGRAM, f"{name}.prm", "--set", "Time/End time = 0.02", cwd=folder)
        require((folder / name / "summary.json").exists(), f"{name} did not finish")
    printed = run(PROGRAM, "--example", "dam_brek", code=2)
    require('did you mean "dam_break"?' in printed, printed)
    printed = run(PROGRAM, "--example", "volcano", code=2)
    require('Examples: "dam_break"' in printed, printed)


def self_test(folder):
    environment = {**os.environ, "TMPDIR": str(folder)}
    text = run(PROGRAM, "--self-test", env=environment)
    require(len(re.findall(r"^passed ", text, re.M)) == 3 and "your build is fine" in text, text)
    # points that lose their energy: not what this build should compute
    text = run(PROGRAM, "--self-test", "--set", "Transfer/Method = PIC", code=3, env=environment)
    for failed in (r"^FAILED dam_break .*front 2\.2", r"^FAILED rotating_patch .*energy -0\.5",
                   "self-test FAILED: "):
        require(re.search(failed, text, re.M), f"no {failed} in\n{text}")
    # a step that cannot be done is a failure, too
    text = run(PROGRAM, "--self-test", "--set", "Solver/Newton maximum iterations = 1",
               "--set", "Time/Minimum step = 0.01", code=3, env=environment)
    require(re.search(r"^FAILED dam_break .*Newton", text, re.M), text)
    printed = run(PROGRAM, "dam.prm", "--self-test", code=2, env=environment)
    require('leave out "dam.prm"' in printed, printed)
    # empty folders of Open MPI 5 (open-mpi/ompi#13261)
    left = [path for path in folder.rglob("*") if not path.is_dir()]
    require(not left, f"left behind: {left}")


def papers(folder):
    bibliography = (SOURCE / "doc/references.bib").read_text()
    keys = re.findall(r"^@\w+\{(\w+),$", bibliography, re.M)
    require(len(keys) == len(set(keys)) > 20, "a key occurs twice")
    usual = SOURCE / "prm/examples/dam_break.prm"
    used = set()

    def cited(*settings, scene=usual):
        options = [word for text in settings for word in ("--set", text)]
        run(PROGRAM, scene, "--output", "run", "--set", "Time/End time = 0.001", *options, cwd=folder)
        found = re.findall(r"^@\w+\{(\w+),$", (folder / "run/methods.bib").read_text(), re.M)
        require(len(found) == len(set(found)), f"twice in {found}")
        used.update(found)
        return set(found)

    default = cited()
    require({"sulsky1994", "jiang2017", "codina2000", "p4est2011"} <= default, f"{default}")
    require(not {"wood1980", "lind2012", "hueeber2005"} & default, f"{default}")
    for settings, has, has_not in [
            (["Time/Scheme = bossak"], "wood1980", "newmark1959"),
            (["Time/Scheme = newmark"], "newmark1959", "wood1980"),
            (["Walls/Contact = unilateral"], "hueeber2005", "schlichting1979"),
            (["Walls/Bottom friction = 0.01"], "schlichting1979", "hueeber2005"),
            (["Points/Shifting sweeps = 1"], "lind2012", "wood1980"),
            (["Tank motion/Free = x", "Tank motion/Inertia = 100"], "broyden1965", "wood1980"),
            (["Fluid/Viscosity law = power law"], "bird1987", "wood1980"),
            (["Quadrature/Rule = material points"], "bonet1998", "saye2015"),
            (["Formulation/Stabilization = OSGS"], "codina2002", "codina2008"),
            (["Formulation/Stabilization = split OSGS"], "codina2008", "lind2012"),
            (["Formulation/Tau = root of squares"], "shakib1991", "badia2009"),
            (["Solver/Linear solver = iterative", "Solver/Multigrid = ML"], "vanek1996", "henson2002"),
            (["Solver/Linear solver = direct"], "eisenstat1996", "saad1993")]:
        found = cited(*settings)
        require(has in found and has_not not in found, f"{settings} cites {sorted(found)}")
    require("baerentzen2005" in cited(scene=SOURCE / "tests/scene/shapes_3d.prm"), "triangles")
    require("nitsche1971" in cited(scene=SOURCE / "tests/scene/turned_tank_rest_2d.prm"), "solids")
    require("jonkman2007" in cited(scene=SOURCE / "tests/scene/moored_box_2d.prm"), "moorings")
    require("chouly2013" in cited(scene=SOURCE / "tests/scene/leaves_solid_2d.prm"), "unilateral solids")
    require("juntunen2009" in cited(scene=SOURCE / "tests/scene/free_solids_3d.prm"), "no-slip solids")
    # every transfer has its paper, and every paper its use
    table = run(PROGRAM, "--print-parameters")
    methods = re.search(r"## Subsection Transfer\n.*?`Method` \|[^|]*\| one of ([^|]*)\|", table,
                        re.S).group(1)
    for method in re.findall(r'"([^"]+)"', methods):
        settings = [f"Transfer/Method = {method}"]
        if method == "FLIP acceleration":
            settings.append("Time/Scheme = newmark")
        found = cited(*settings)
        require(found & {"harlow1964", "brackbill1986", "jiang2017", "nakamura2023", "wobbes2019",
                         "hammerquist2017", "nairn2021"}, f"{method} cites {sorted(found)}")
    unused = set(keys) - used
    require(len(unused & {"dealii2022", "dealii2024"}) == 1 and len(unused) == 1,
            f"no scene cites {unused}")


def install(folder):
    prefix = folder / "there"
    run("cmake", "--install", BUILD, "--prefix", prefix)
    programs = prefix / "bin"
    require(run(programs / "seiche", "--version").startswith("seiche "), "no program")
    require_left_out(programs / "seiche", prefix / cached("CMAKE_INSTALL_LIBDIR") / "seiche")
    (folder / "dam.prm").write_text(run(programs / "seiche", "--example", "dam_break"))
    run(programs / "seiche", "dam.prm", "--set", "Time/End time = 0.1", cwd=folder)
    run(programs / "seiche-plot", "dam", cwd=folder)
    require(list((folder / "dam/pictures").glob("*.png")), "no picture")
    for script in ("seiche-study", "seiche-pictures", "seiche-mpirun"):
        run(programs / script, "--help")
    (folder / "dam.toml").write_text(
        'base = "dam.prm"\n[set]\n"Time/End time" = 0.02\n[vary]\n"Time/Step" = [0.01, 0.005]\n'
        '[collect]\ne = "last(relative_energy)"\n[[plot]]\nkind = "convergence"\nx = "Time/Step"\ny = "e"\n')
    run(programs / "seiche-study", "dam.toml", "--output", "study", cwd=folder)
    require(list((folder / "study").glob("*.png")), "no plot of the study")
    root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    printed = run(programs / "seiche-mpirun", "-n", "2", "--oversubscribe", programs / "seiche",
                  "dam.prm", "--set", "Time/End time = 0.02", cwd=folder,
                  env={**os.environ, **root})
    require("2 ranks" in printed and "finished" in printed, printed)
    # Debian's numpy belongs to Debian's interpreter
    lines = run("/usr/bin/python3", "-c",
                'from seiche_output import Run; print(len(Run("dam").statistics))', cwd=folder,
                env={**os.environ, "PYTHONPATH": str(prefix / cached("SEICHE_PYTHON_DIR"))})
    require(int(lines) > 5, lines)
    run(programs / "seiche", prefix / "share/seiche/prm/benchmarks/dam_break_2d/dam_break_2d.prm",
        "--validate")
    # headers and libraries, without those of the sources
    run("cmake", "-G", "Ninja", "-S", prefix / "share/doc/seiche/examples", "-B", folder / "build",
        f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_BUILD_TYPE={cached('CMAKE_BUILD_TYPE')}")
    run("cmake", "--build", folder / "build")
    printed = run(folder / "build/example_column", cwd=folder)
    require(re.search(r"^t 0\.4 s, front 1\.\d+ m", printed, re.M), printed)
    summary = json.loads((folder / "column/summary.json").read_text())
    require(summary["status"] == "finished" and summary["steps"] == 40, f"{summary}")


def cached(name):
    """Of the build that is installed."""
    return re.search(rf"^{name}:\w+=(\S*)$", (BUILD / "CMakeCache.txt").read_text(), re.M).group(1)


with tempfile.TemporaryDirectory() as name:
    globals()[CASE](pathlib.Path(name))
print("passed")
