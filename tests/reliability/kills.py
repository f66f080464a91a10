#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""kill -9 at random moments and while checkpoints are written: three scenes, one
and two ranks; restart/kill_test.py does the work.

kills.py SEICHE MPIRUN
"""
import subprocess
import sys

from harness import ROOT, amount, arguments, seed

RUNS = [("dam_break_2d", 1), ("dam_break_2d", 2), ("adaptive_2d", 1), ("adaptive_2d", 2),
        ("column_3d", 1), ("column_3d", 2)]


def main():
    options = arguments(__doc__)
    total, failed = amount("kills"), 0
    for i, (scene, ranks) in enumerate(RUNS):
        kills = total * (i + 1) // len(RUNS) - total * i // len(RUNS)
        if kills:
            failed += 0 != subprocess.run(
                [sys.executable, ROOT / "tests/restart/kill_test.py", options.seiche,
                 options.mpirun, "--kills", str(kills), "--ranks", str(ranks), "--scene",
                 scene, "--seed", str(seed())], check=False).returncode
            sys.stdout.flush()
    print(f"kills: {total}; {failed} of the groups not as they should be")
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
