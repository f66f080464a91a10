#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Water that sloshes for many steps: memory and open files stay as they are.

soak.py SEICHE

Every 1000 steps (a tenth of a short run) it goes on as a restart would. In the two
periods after step 1000 (after the half of a short run) memory has settled; later the
resident memory takes at most 1 % more (5 % in a short run, which shows gross leaks
only), and no file stays open.
"""
import os
import pathlib
import re
import subprocess
import time

from harness import ROOT, amount, arguments, scratch

SCENE = ROOT / "tests/reliability/scenes/slosh.prm"
STEP = 0.01  # [s], of the scene


def sample(process, table):
    """Steps done, resident memory [KiB], open files; nothing if it has ended."""
    try:
        status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
        files = len(os.listdir(f"/proc/{process.pid}/fd"))
        rows = table.read_bytes().count(b"\n") - 2
    except OSError:
        return None
    resident = re.search(r"VmRSS:\s+(\d+)", status)
    return (rows, int(resident.group(1)), files) if resident else None


def main():
    options = arguments(__doc__)
    steps = amount("soak_steps")
    period = min(1000, steps // 10)
    begin = min(1000, steps // 2)
    settled = begin + 2 * period
    largest_growth = 0.01 if period == 1000 else 0.05
    samples = []
    with scratch() as folder:
        table = pathlib.Path(folder, "out/statistics.csv")
        with subprocess.Popen(
                [options.seiche, SCENE, "--set", f"Time/End time = {steps * STEP:g}",
                 "--set", f"Checkpoint/Every steps = {period}",
                 "--output", f"{folder}/out"], stdout=subprocess.DEVNULL) as process:
            while process.poll() is None:
                samples.append(sample(process, table))
                time.sleep(min(5.0, 1e-4 * steps))
        code = process.returncode
    # after its last step the program closes everything
    samples = [values for values in samples if values and begin <= values[0] < steps]
    first = [values[1] for values in samples if values[0] < settled]
    later_memory = [values[1] for values in samples if values[0] >= settled]
    if not first or not later_memory:
        print(f"soak: exit code {code}, the run was too quick to be seen")
        return 1
    growth = max(later_memory) / max(first) - 1.0
    # frames and checkpoints open one more while they are written, and a short run is
    # seen a few times only: files that stay open are in each of the last samples
    files = [values[2] for values in samples]
    quarter = max(1, len(files) // 4)
    usual = max(files[:quarter])
    later = min(files[-quarter:])
    good = code == 0 and growth < largest_growth and later <= usual
    print(f"soak: {steps} steps, exit code {code}; from step {settled} on memory "
          f"{max(first) / 1024:.0f} MiB grew by {100 * growth:.2f} %, open files at most "
          f"{usual}, later {later}: {'as it should be' if good else 'FAILED'}")
    return 0 if good else 1


if __name__ == "__main__":
    raise SystemExit(main())
