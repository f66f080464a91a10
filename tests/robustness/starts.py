#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What happens before the first step: starts.py CASE SEICHE SOURCE_FOLDER [NUMBER]"""
import csv
import os
import pathlib
import subprocess
import sys
import tempfile


def many(seiche, _, folder):
    """Starts beside each other need nothing in the folder of Open MPI, in which they once
    fell over each other."""
    number = int(sys.argv[4])
    environment = {**os.environ, "TMPDIR": folder}
    running = [subprocess.Popen([seiche, "--version"], env=environment, text=True,
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
               for _ in range(number)]
    messages = [process.communicate()[1] for process in running]
    failed = [text for process, text in zip(running, messages) if process.returncode]
    assert not failed, f"{len(failed)} of {number} failed: {failed[0]}"
    # Open MPI 5 leaves empty folders (open-mpi/ompi#13261)
    left = [path for path in pathlib.Path(folder).rglob("*") if not path.is_dir()]
    assert not left, left


def probes(seiche, source, folder):
    """No pressure is known before the first step: the field is empty, not zero."""
    scene = source / "tests/restart/dam_break_2d.prm"
    subprocess.run([seiche, scene, "--output", folder, "--set", "Time/End time = 0.005",
                    "--set", "Output/Interval = 0"], check=True)
    for name in ("statistics.csv", "probes.csv"):
        with open(f"{folder}/{name}", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        column = "probe bottom pressure [Pa]"
        assert rows[0][column] == "" and float(rows[1][column]) > 100., (name, rows)


def debian13(_, source, folder):
    """contrib/debian13 installs debootstrap where it is missing, then uses it."""
    tools = pathlib.Path(folder, "bin")
    tools.mkdir()
    for tool in ("bash", "dirname", "grep", "cat", "env", "chmod"):
        os.symlink(subprocess.check_output(["which", tool], text=True).strip(), tools / tool)
    log = pathlib.Path(folder, "log")
    scripts = {"id": f"#!{tools}/bash\necho 0\n",
               "apt-get": f'#!{tools}/bash\necho "apt-get $*" >>{log}\n'
                          f'printf "#!{tools}/bash\\necho debootstrap \\$* >>{log}; exit 7\\n"'
                          f" >{tools}/debootstrap\nchmod +x {tools}/debootstrap\n"}
    for name, text in scripts.items():
        (tools / name).write_text(text)
        (tools / name).chmod(0o755)
    result = subprocess.run([tools / "bash", source / "contrib/debian13", f"{folder}/system"],
                            env={"PATH": str(tools)}, text=True, capture_output=True)
    lines = log.read_text().splitlines() if log.exists() else []
    assert lines[:1] == ["apt-get install -y debootstrap"], (lines, result.stderr)
    assert len(lines) == 2 and lines[1].startswith("debootstrap ") and (
        f"trixie {folder}/system" in lines[1]), lines
    assert result.returncode == 7, result


def main():
    case, seiche, source = sys.argv[1:4]
    with tempfile.TemporaryDirectory() as folder:
        {"many": many, "probes": probes, "debian13": debian13}[case](
            seiche, pathlib.Path(source), folder)
    print(f"{case}: as it should be")


if __name__ == "__main__":
    main()
