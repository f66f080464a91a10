#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two runs that want the same folder at the same time: exactly one gets it.

races.py SEICHE
"""
import shutil
import threading

from harness import ROOT, Account, amount, arguments, run, scratch, within_time

SCENE = ROOT / "tests/restart/dam_break_2d.prm"


def main():
    options = arguments(__doc__)
    account = Account("races")
    with scratch() as folder:
        for case in within_time(range(amount("races"))):
            outcomes = [None, None]

            def start(i, outcomes=outcomes):
                outcomes[i] = run([options.seiche, SCENE, "--output", f"{folder}/out"])

            threads = [threading.Thread(target=start, args=(i,)) for i in (0, 1)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            outcomes.sort(key=lambda outcome: outcome.code)
            winner, loser = outcomes
            account.add(case, winner, {0})
            account.add(case, loser, {4}, "" if "another run" in loser.text else
                        "no message about the other run")
            shutil.rmtree(f"{folder}/out")
    return account.verdict("runs, two at a time in one folder")


if __name__ == "__main__":
    raise SystemExit(main())
