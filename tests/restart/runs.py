# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start, interrupt and compare runs; shared by the tests of restarts."""
import os
import signal
import subprocess
import time


class Program:
    """`seiche` on some ranks with one scene."""

    def __init__(self, seiche, mpirun, scene, ranks=1, options=()):
        self.ranks = ranks
        self.launcher = [mpirun, "-n", str(ranks)] if ranks > 1 else []
        self.command = [seiche, scene]
        for option in options:
            self.command += ["--set", option]

    def start(self, folder, *arguments, launcher=None, session=False):
        return subprocess.Popen(
            (self.launcher if launcher is None else launcher)
            + self.command + ["--output", folder, *arguments],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            start_new_session=session)

    def run(self, folder, *arguments, code=0):
        """Run to the end; what it printed. AssertionError for another code."""
        process = self.start(folder, *arguments)
        text = process.communicate(timeout=300)[0]
        assert process.returncode == code, (
            f"exit code {process.returncode} instead of {code}:\n{text}")
        return text

    def run_until(self, folder, end_time):
        """A run that is interrupted: it ends earlier than it should. Its last
        two steps are not those of the whole run; none may be a checkpoint."""
        self.run(folder, "--set", f"Time/End time = {end_time}")


def read(folder, name):
    with open(os.path.join(folder, name), "rb") as file:
        content = file.read()
    if name.endswith(".pvd"):  # deal.II puts the date into a comment
        content = b"\n".join(line for line in content.split(b"\n")
                             if not line.startswith(b"#"))
    return content


def require_same_files(folder, other, names):
    for name in names:
        assert read(folder, name) == read(other, name), f"{name} differs"


def frames(folder):
    return sorted(name for name in os.listdir(folder)
                  if name.startswith(("grid_", "points_", "surface_")))


def checkpoints(folder):
    """Full names, the oldest first."""
    return sorted(os.path.join(folder, name) for name in os.listdir(folder)
                  if name.startswith("checkpoint-") and name.endswith(".h5"))


def wait_for_rows(process, folder, n):
    """Until statistics.csv has n rows; AssertionError if the run ends first."""
    name = os.path.join(folder, "statistics.csv")
    while True:
        try:
            if read(folder, "statistics.csv").count(b"\n") > n:
                return
        except FileNotFoundError:
            pass
        assert process.poll() is None, f"ended before row {n} of {name}"
        time.sleep(0.005)


def descendants(pid):
    children = {}
    for entry in os.listdir("/proc"):
        if entry.isdigit():
            try:
                with open(f"/proc/{entry}/stat", encoding="ascii") as file:
                    parent = int(file.read().rsplit(")", 1)[1].split()[1])
                children.setdefault(parent, []).append(int(entry))
            except (OSError, ValueError):
                pass
    found = [pid]
    for process in found:  # grows as it is gone through
        found += children.get(process, [])
    return found


def ranks_of(process, program):
    """Process numbers of the ranks that have begun, the first one first."""
    found = []
    for pid in descendants(process.pid):
        try:
            if os.path.samefile(f"/proc/{pid}/exe", program):
                found.append(pid)
        except OSError:
            pass
    return sorted(found)


def kill(process):
    """kill -9 of the process and all that it has started."""
    for pid in descendants(process.pid):
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    process.communicate()
