#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameter files of the project, damaged at random.

mutants.py SEICHE MPIRUN STARTS

Each mutant is read with --validate: exit code 0, or 2 with a message that names
the file, and no file made. One in ten is also computed for a moment: it may end
in any way that the README lists but 1.
"""
import pathlib
import shutil

from harness import ROOT, Account, Starts, amount, arguments, chance, over_all, scratch

VALUES = ["", "0", "-1", "1", "2", "3", "1e-300", "1e300", "-1e308", "nan", "inf",
          "-inf", "infinite", "1e", "0x10", "4294967296", "18446744073709551616", "1,1",
          "0, 0, 0", "1; 2", "x", "t", "sqrt(-1)", "1/0", "sin(", "true", "no", "auto",
          "box", "ball", "slip", "no slip", "open", "../../etc/passwd", "/dev/null",
          "\xe9\u20ac", "a" * 5000, "1" * 400, "0.1 0.2", "= 3", "1 # 2", '"', "\\", "%s%n"]


def lines_of(text):
    return [i for i, line in enumerate(text) if line.strip()]


def change_value(luck, text, _):
    entries = [i for i, line in enumerate(text) if "=" in line]
    if entries:
        i = luck.choice(entries)
        text[i] = text[i].split("=")[0] + "= " + luck.choice(VALUES)


def scale_number(luck, text, _):
    entries = [i for i, line in enumerate(text)
               if "=" in line and any(c.isdigit() for c in line.split("=")[1])]
    if entries:
        i = luck.choice(entries)
        name, value = text[i].split("=", 1)
        words = value.split("#")[0].replace(",", " , ").split()
        numbers = [n for n, word in enumerate(words) if word[-1].isdigit()]
        if numbers:
            n = luck.choice(numbers)
            try:
                words[n] = repr(float(words[n]) *
                                luck.choice([-1, 0, 0.1, 0.5, 2, 1.0001, 7, 1e-9, 1e9]))
            except ValueError:
                return
            text[i] = name + "= " + " ".join(words)


def flip_byte(luck, text, _):
    whole = "\n".join(text)
    at = luck.randrange(len(whole))
    text[:] = (whole[:at] + chr(luck.randrange(1, 256)) + whole[at + 1:]).split("\n")


def drop_line(luck, text, _):
    del text[luck.choice(lines_of(text))]


def double_line(luck, text, _):
    i = luck.choice(lines_of(text))
    text.insert(i, text[i])


def swap_lines(luck, text, _):
    i, j = luck.choice(lines_of(text)), luck.choice(lines_of(text))
    text[i], text[j] = text[j], text[i]


def cut(luck, text, _):
    del text[luck.randrange(1, len(text) + 1):]


def splice(luck, text, other):
    i, j = luck.randrange(len(other)), luck.randrange(len(text))
    text[j:j] = other[i:i + luck.randrange(1, 8)]


def misspell(luck, text, _):
    i = luck.choice(lines_of(text))
    line = text[i]
    at = luck.randrange(len(line))
    text[i] = line[:at] + luck.choice(["", "x", " ", line[at] * 2]) + line[at + 1:]


MUTATIONS = [change_value, change_value, change_value, scale_number, scale_number, flip_byte,
             drop_line, double_line, swap_lines, cut, splice, splice, misspell]


def mutate(luck, text, other):
    lines = text.split("\n")
    for _ in range(luck.choice([1, 1, 1, 2, 3, 6])):
        if lines_of(lines):
            luck.choice(MUTATIONS)(luck, lines, other.split("\n"))
    return "\n".join(lines)


def main():
    options = arguments(__doc__)
    account, runs = Account("mutants"), Account("mutants that were computed")
    with scratch() as folder:
        starts = Starts(options.starts, folder)
        # scenes refer to tables and other files beside them
        tree = pathlib.Path(folder)
        for part in ("prm", "tests"):
            shutil.copytree(ROOT / part, tree / part)
        files = sorted(tree.rglob("*.prm"))
        small = [file for file in files if "tests" in file.parts]

        def one(case):
            luck = chance(case)
            is_run = case % 10 == 0
            origin = luck.choice(small if is_run else files)
            text = mutate(luck, origin.read_text(encoding="utf-8"),
                          luck.choice(files).read_text(encoding="utf-8"))
            mutant = origin.with_name(f"{origin.stem}-{case}.mutant")
            mutant.write_text(text, encoding="utf-8")
            outcome = starts.run(mutant, "--validate", "--output", tree / f"out-{case}")
            problem = ""
            if outcome.code == 2 and str(mutant) not in outcome.text and \
                    str(origin.parent) not in outcome.text:
                problem = "a message without the file"
            elif (tree / f"out-{case}").exists():
                problem = "a folder was made"
            account.add(case, outcome, {0, 2}, problem, [mutant])
            if outcome.code == 0 and is_run:
                compute(case, mutant)
            mutant.unlink()

        def compute(case, mutant):
            out = tree / f"run-{case}"
            outcome = starts.run(mutant, "--output", out, "--max-hours", "0.0005")
            # scenes with a test log do not say that they were stopped
            told = outcome.text.strip() or outcome.code == 5
            runs.add(case, outcome, {0, 2, 3, 4, 5, 6}, "" if told else "no message",
                     [mutant])
            shutil.rmtree(out, ignore_errors=True)

        over_all(one, range(amount("mutants")))
    return account.verdict("damaged parameter files") | runs.verdict("of them")


if __name__ == "__main__":
    raise SystemExit(main())
