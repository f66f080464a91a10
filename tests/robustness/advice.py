#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Follow the advice of a failed run, as a user would, until the scene runs.

advice.py SEICHE FOLDER STEPS FILE.prm [ENTRY=VALUE...]

Fails if the scene as it stands does not end with exit code 3, or if it still does
after STEPS pieces of advice, or if one of them leads to a mistake in the input.
"""
import re
import subprocess
import sys

FINISHED, INPUT, NUMERICAL = 0, 2, 3


def advised(text):
    """Entries in the order in which a message names them."""
    found = re.search(r"What may help in this scene: (.*)\.\s*$", text, re.M)
    if not found:
        return []
    return [entry for entry in re.split(r", (?=[A-Z][A-Za-z ]*/)", found.group(1))
            if " = " in entry]


def command(seiche, scene, folder, entries):
    options = [part for name, value in entries.items()
               for part in ("--set", f"{name} = {value}")]
    return [seiche, scene, "--output", folder, *options]


def run(seiche, scene, folder, entries, **limits):
    return subprocess.run(command(seiche, scene, folder, entries), text=True,
                          capture_output=True, **limits)


def follow(start, entries, steps):
    """Take the first piece of advice that is not taken yet, keep it, run again.
    start(entries) runs; the last result, and what was taken."""
    entries, taken = dict(entries), []
    result = start(entries)
    while result.returncode == NUMERICAL and len(taken) < steps:
        news = [entry for entry in advised(result.stderr) if entry not in taken]
        if not news:
            break
        taken.append(news[0])
        name, value = news[0].split(" = ", 1)
        entries[name] = value
        result = start(entries)
    return result, taken


def main():
    seiche, folder, steps, scene, *entries = sys.argv[1:]
    entries = dict(entry.split("=", 1) for entry in entries)
    first = run(seiche, scene, folder, entries)
    if first.returncode != NUMERICAL:
        sys.exit(f"exit code {first.returncode} as it stands: {first.stderr}")
    print(first.stderr)
    result, taken = follow(lambda now: run(seiche, scene, folder, now), entries,
                           int(steps))
    print("taken:", *taken, sep="\n  ")
    if result.returncode != FINISHED:
        sys.exit(f"exit code {result.returncode} in the end: {result.stderr}")


if __name__ == "__main__":
    main()
