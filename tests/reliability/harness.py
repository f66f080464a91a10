# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all drivers of this folder share: numbers of cases, runs under a time
limit, and the account of what came out.

The environment variable SEICHE_RELIABILITY chooses the numbers: sample (some
seconds, the default), night or release. SEICHE_RELIABILITY_SEED starts another
sequence of chance; SEICHE_RELIABILITY_SHARE = 0.1 runs a tenth, and
SEICHE_RELIABILITY_MINUTES = 30 begins no case after half an hour. Inputs of cases
that failed are kept in `failures/` of the folder in which the driver runs.
"""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/restart"))
import runs  # noqa: E402

AMOUNTS = {  # sample, night, release
    "mutants": (12, 2000, 20000),
    "expressions": (12, 2000, 20000),
    "tables": (8, 1000, 10000),
    "checkpoints": (10, 5000, 5000),
    "kills": (2, 50, 500),
    "disks": (3, 100, 100),
    "signals": (2, 84, 84),
    "repeatability": (2, 20, 20),
    "rank_scenes": (1, 2, 2),
    "faults": (7, 42, 42),
    "stress": (2, 1000, 1000),
    "soak_steps": (300, 20000, 100000),
    "races": (2, 20, 20),
    "time_limits": (1, 20, 20),
    "memory_limits": (2, 20, 20),
}
LEVELS = ("sample", "night", "release")
END = time.monotonic() + 60 * float(os.environ.get("SEICHE_RELIABILITY_MINUTES", "inf"))
SLOWEST = float(os.environ.get("SEICHE_RELIABILITY_HANG", "60"))  # [s]

ROWS = ["statistics.csv", "probes.csv"]


def amount(name):
    level = os.environ.get("SEICHE_RELIABILITY", LEVELS[0])
    if level not in LEVELS:
        sys.exit(f"SEICHE_RELIABILITY = {level} is none of {', '.join(LEVELS)}")
    share = float(os.environ.get("SEICHE_RELIABILITY_SHARE", "1"))
    return max(1, round(share * AMOUNTS[name][LEVELS.index(level)]))


def seed():
    return int(os.environ.get("SEICHE_RELIABILITY_SEED", "1"))


def chance(case):
    """Each case has a sequence of its own: one can be repeated alone."""
    return random.Random(f"{seed()}/{case}")


Outcome = collections.namedtuple("Outcome", "code text seconds")
HANG = "hang"


def run(command, folder=None, seconds=None, prepare=None, stdin=subprocess.DEVNULL,
        environment=None):
    """Run to the end; the code is HANG if it had to be killed."""
    begin = time.monotonic()
    process = subprocess.Popen(
        [str(part) for part in command], cwd=folder, stdin=stdin, preexec_fn=prepare,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True,
        env={**os.environ, **(environment or {})})
    try:
        text = process.communicate(timeout=seconds or SLOWEST)[0]
        code = process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        text, code = process.communicate()[0], HANG
    return Outcome(code, text.decode(errors="replace"), time.monotonic() - begin)


class Starts:
    """Starts of the program on one rank by the test program `starts`, which loads the
    libraries once for each thread: as run(), for a third of the time."""

    def __init__(self, program, folder):
        self.command = [program, str(round(SLOWEST))]
        self.folder, self.own = folder, threading.local()

    def run(self, *arguments_of_start):
        if not hasattr(self.own, "server"):
            self.own.printed = tempfile.NamedTemporaryFile(dir=self.folder, delete=False)
            self.own.server = subprocess.Popen(
                self.command, cwd=self.folder, stdin=subprocess.PIPE,
                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        begin = time.monotonic()
        words = [self.own.printed.name, *map(str, arguments_of_start)]
        self.own.server.stdin.write("\t".join(words) + "\n")
        self.own.server.stdin.flush()
        code = int(self.own.server.stdout.readline())
        text = pathlib.Path(self.own.printed.name).read_text(errors="replace")
        return Outcome(HANG if code == -signal.SIGALRM else code, text,
                       time.monotonic() - begin)


def outcome_of(process, begin):
    """Of a process of runs.Program that began then; killed with its ranks if it hangs."""
    try:
        text = process.communicate(timeout=SLOWEST)[0]
        code = process.returncode
    except subprocess.TimeoutExpired:
        runs.kill(process)
        text, code = "", HANG
    return Outcome(code, text, time.monotonic() - begin)


def limit(kind, size):
    """For prepare= of run(): a limit of the system."""
    return lambda: resource.setrlimit(kind, (size, size))


class Account:
    """Counts outcomes; every driver ends with its verdict."""

    def __init__(self, name):
        self.name, self.codes, self.problems = name, collections.Counter(), []
        self.slowest = 0.0

    def add(self, case, outcome, allowed, problem="", inputs=()):
        """Count a case; keep its inputs and say why if it is not as it should be."""
        self.codes[outcome.code] += 1
        self.slowest = max(self.slowest, outcome.seconds)
        if not problem:
            problem = self.wrong(outcome, allowed)
        if not problem:
            return
        self.problems.append(problem)
        keep = pathlib.Path("failures", f"{self.name}-{seed()}-{case}".replace("/", "_"))
        keep.mkdir(parents=True, exist_ok=True)
        for file in inputs:
            shutil.copy(file, keep)
        (keep / "printed").write_text(f"{problem}\n{outcome.text}", encoding="utf-8")
        print(f"FAILED {case} (seed {seed()}): {problem}; see {keep}/")
        print("    | " + "\n    | ".join(outcome.text.strip().split("\n")[-6:])[:2000],
              flush=True)

    @staticmethod
    def wrong(outcome, allowed):
        if outcome.code in allowed:
            return ""
        if outcome.code == HANG:
            return f"still running after {outcome.seconds:.0f} s"
        if outcome.code < 0:
            return f"signal {signal.Signals(-outcome.code).name}"
        return f"exit code {outcome.code}, allowed {sorted(allowed, key=str)}"

    def verdict(self, what):
        """Print the line for doc/reliability.md; the exit code of the driver."""
        codes = ", ".join(f"{n} {'hangs' if code == HANG else f'exit {code}'}"
                          for code, n in sorted(self.codes.items(), key=str))
        print(f"{self.name}: {sum(self.codes.values())} {what}: {codes or 'none'}; slowest "
              f"{self.slowest:.1f} s; {len(self.problems)} not as they should be")
        return 1 if self.problems else 0


def within_time(cases):
    """The cases, as long as SEICHE_RELIABILITY_MINUTES since the start are not over."""
    for case in cases:
        if time.monotonic() > END:
            return
        yield case


def over_all(work, cases):
    """work(case) for each, on all cores; stops at the first exception."""
    remaining, lock = within_time(cases), threading.Lock()

    def worker(_):
        while True:
            with lock:
                case = next(remaining, None)
            if case is None:
                return
            work(case)

    n = len(os.sched_getaffinity(0))
    with concurrent.futures.ThreadPoolExecutor(n) as pool:
        for _ in pool.map(worker, range(n)):
            pass


def arguments(text):
    parser = argparse.ArgumentParser(description=text)
    parser.add_argument("seiche", type=os.path.abspath)
    parser.add_argument("mpirun", nargs="?", default="mpirun")
    parser.add_argument("starts", nargs="?", type=os.path.abspath)
    return parser.parse_args()


def scratch():
    return tempfile.TemporaryDirectory(prefix="seiche-")


def snapshot(folder):
    return {str(file): file.stat().st_mtime_ns
            for file in pathlib.Path(folder).rglob("*")}
