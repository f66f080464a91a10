#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Damaged tables (CSV) as references of scores.

tables.py SEICHE MPIRUN STARTS

--validate ends with exit code 0, or 2 with a message that names the table.
"""
import pathlib
import sys

from harness import ROOT, Account, Starts, amount, arguments, chance, over_all, scratch

sys.path.insert(0, str(ROOT / "tests/input"))
from check_input import SCENE  # noqa: E402

SCORE = """\
subsection Front f
end
subsection Score s
  set Column = front f [m]
  set Reference table = {table}
  set Interpolation = {interpolation}
end
"""
FIELDS = ["", " ", "nan", "inf", "-1e308", "1e309", "1e", "x", "0x1p3", "1,5", '"1"', '"1',
          "\xe9", "\0", "1 2", "-", "--1", "1e-400", "9" * 400, "\t0.1\t", ".", "#"]


def table(luck):
    rows = [["time", "value"]] + [[str(0.001 * i), str(0.4 + 0.01 * i)]
                                  for i in range(luck.choice([1, 2, 20, 20, 20, 20]))]
    for _ in range(luck.choice([0, 0, 1, 1, 2, 5])):
        row = luck.choice(rows)
        kind = luck.randrange(7)
        if kind <= 2 and row:
            row[luck.randrange(len(row))] = luck.choice(FIELDS)
        elif kind == 3 and row:
            row.pop()
        elif kind == 4:
            row.append(luck.choice(FIELDS))
        elif kind == 5:
            luck.shuffle(rows)
        else:
            rows.insert(luck.randrange(len(rows)), list(row))
    end = luck.choice(["\n", "\n", "\n", "\r\n", "\r", "\n\n"])
    comma = luck.choice([",", ",", ",", ",", ", ", ";"])
    text = end.join(comma.join(row) for row in rows)
    data = bytearray(luck.choice(["", "", "", "\ufeff"]).encode() + text.encode() +
                     luck.choice(["", "\n"]).encode())
    for _ in range(luck.choice([0, 0, 0, 1, 4])):
        if data:
            data[luck.randrange(len(data))] = luck.randrange(256)
    return bytes(data)


def main():
    options = arguments(__doc__)
    account = Account("tables")
    with scratch() as folder:
        starts = Starts(options.starts, folder)

        def one(case):
            luck = chance(case)
            data = pathlib.Path(folder, f"{case}.csv")
            scene = pathlib.Path(folder, f"{case}.prm")
            data.write_bytes(table(luck))
            scene.write_text(SCENE + SCORE.format(
                table=data.name, interpolation=luck.choice(["linear", "spline"])))
            outcome = starts.run(scene, "--validate")
            account.add(case, outcome, {0, 2},
                        "a message without the table" if outcome.code == 2 and
                        data.name not in outcome.text else "", [data, scene])

        over_all(one, range(amount("tables")))
    return account.verdict("damaged tables")


if __name__ == "__main__":
    raise SystemExit(main())
