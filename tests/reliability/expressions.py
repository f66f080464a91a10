#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random expressions, right and wrong ones, in all entries that take them.

expressions.py SEICHE MPIRUN STARTS

--validate ends with exit code 0, or 2 with a message that names the file. What is
valid is computed for two steps: exit code 0, 2 or 3, and no number in the results
that is not finite.
"""
import pathlib
import sys

from harness import ROOT, Account, Starts, amount, arguments, chance, over_all, scratch

sys.path.insert(0, str(ROOT / "tests/input"))
from check_input import SCENE  # noqa: E402

# the entry with {} for an expression, where it stands in SCENE
PLACES = [
    ("Acceleration = 0; -9.81", "Acceleration = {}; -9.81"),
    ("Acceleration = 0; -9.81", "Acceleration = 0; {}"),
    ("Upper corner = 0.4, 0.3\n", "Upper corner = 0.4, 0.3\n  set Velocity = {}; 0\n"),
    ("subsection Time", "subsection Score s\n  set Column = front f [m]\n"
     "  set Reference = {}\nend\nsubsection Front f\nend\nsubsection Time"),
    ("subsection Time", "subsection Walls\n  set Left displacement = {}\nend\n"
     "subsection Time"),
]
NUMBERS = ["0", "1", "-2.5", "1e-3", "1e300", "1e-300", "0.1", "3", "1e309", ".5", "5."]
NAMES = ["x", "y", "t", "pi", "z", "q", "_pi", "e"]
UNARY = ["sin", "cos", "tan", "exp", "log", "sqrt", "abs", "atan", "cosh", "tanh", "asin",
         "sign", "rint", "foo", "-", "+", "!"]
BINARY = ["+", "-", "*", "/", "^", "<", ">", "==", "&&", "||", "%", "**", "&", "|", " "]
BROKEN = ["(", ")", ",", ";", "?", ":", "..", "\xe9", "$", "1e", "()", "\"", "=", "#"]


def expression(luck, depth):
    kind = luck.random()
    if depth == 0 or kind < 0.2:
        return luck.choice(NUMBERS if luck.random() < 0.5 else NAMES[:3] * 4 + NAMES)
    if kind < 0.45:
        # most of the names that it knows
        function = luck.choice(UNARY[:8] * 3 + UNARY)
        return f"{function}({expression(luck, depth - 1)})"
    if kind < 0.55:
        return (f"({expression(luck, depth - 1)} < {expression(luck, depth - 1)} ? "
                f"{expression(luck, depth - 1)} : {expression(luck, depth - 1)})")
    if kind < 0.6:
        return (f"{luck.choice(['min', 'max', 'pow', 'atan2', 'fmod', 'if'])}("
                f"{expression(luck, depth - 1)}, {expression(luck, depth - 1)})")
    return (f"({expression(luck, depth - 1)} {luck.choice(BINARY[:5] * 4 + BINARY)} "
            f"{expression(luck, depth - 1)})")


def make(luck):
    text = expression(luck, luck.choice([1, 2, 3, 4, 6]))
    if luck.random() < 0.3:
        at = luck.randrange(len(text) + 1)
        text = text[:at] + luck.choice(BROKEN) + text[at + luck.randrange(2):]
    if luck.random() < 0.01:
        text = "(" * 3000 + text + ")" * luck.choice([3000, 2999])
    if luck.random() < 0.01:
        text = "+".join([text] * 2000)
    return text


def not_finite(folder):
    """What in the statistics is no finite number; an empty field is a missing value."""
    table = pathlib.Path(folder, "statistics.csv")
    if not table.exists():
        return ""
    for line in table.read_text(encoding="utf-8").split("\n")[1:]:
        for field in line.split(","):
            if field and field.lower().strip("-") in ("nan", "inf"):
                return f"{field} in statistics.csv"
    return ""


def main():
    options = arguments(__doc__)
    account = Account("expressions")
    runs = Account("expressions that were computed")
    with scratch() as folder:
        starts = Starts(options.starts, folder)

        def one(case):
            luck = chance(case)
            old, new = luck.choice(PLACES)
            scene = pathlib.Path(folder, f"{case}.prm")
            scene.write_text(SCENE.replace(old, new.replace("{}", make(luck))),
                             encoding="utf-8")
            outcome = starts.run(scene, "--validate")
            account.add(case, outcome, {0, 2},
                        "a message without the file" if outcome.code == 2 and
                        str(scene) not in outcome.text else "", [scene])
            if outcome.code == 0:
                out = pathlib.Path(folder, f"out-{case}")
                outcome = starts.run(scene, "--output", out, "--max-hours", "0.003")
                runs.add(case, outcome, {0, 2, 3}, not_finite(out), [scene])

        over_all(one, range(amount("expressions")))
    return account.verdict("expressions") | runs.verdict("of them")


if __name__ == "__main__":
    raise SystemExit(main())
