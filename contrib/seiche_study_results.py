# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of the runs of a parameter study: causes of failures, columns of the
table, orders of convergence. Standard library only; see seiche_study.py."""

import csv
import json
import math
import os
import re

COLUMN = re.compile(r"^(first|last|min|max|mean|integral|rise)\((.+)\)$|^at\((.+),\s*([^,]+)\)$")
# What the message of a numerical failure is about.
CAUSES = (
    ("Newton (stopped|hardly converged)", "Newton"),
    ("linear solver", "linear solver"),
    ("velocity projection", "velocity projection"),
    ("consistent start", "consistent start"),
    ("is lost|vanished", "lost point"),
    ("not finite", "not finite"),
    ("volume changes by", "volume of a point collapses"),
    ("moves by", "point moves too far"),
)


def cause(outcome):
    """Why a run failed, in a word or two; empty if it finished."""
    code, message = outcome["exit_code"], outcome.get("message", "")
    if outcome.get("timeout"):
        return "timeout"
    if code < 0:
        return f"killed by signal {-code}"
    if code == 3:
        head = message.split(", also at the smallest step")[0]
        return next((name for pattern, name in CAUSES if re.search(pattern, head)), "numerical")
    names = {0: "", 1: "internal error", 2: "input", 4: "files", 5: "stopped", 6: "verdict"}
    return names.get(code, f"exit code {code}")


def read_statistics(folder):
    """{column: [float or None]}; a cut last line is left out."""
    try:
        with open(os.path.join(folder, "statistics.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
    except OSError:
        return {}
    names = [name.strip() for name in rows[0]] if rows else []
    rows = [row for row in rows[1:] if len(row) == len(names)]
    if not rows:
        return {}

    def number(text):
        try:
            return float(text)
        except ValueError:
            return None

    return {name: [number(row[i]) for row in rows] for i, name in enumerate(names)}


def read_summary(folder):
    try:
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return {}


def integral(pairs):
    """Of a signal [(time, value)] over its time, by trapezoids: the impulse of a pressure."""
    return sum(0.5 * (v0 + v1) * (t1 - t0) for (t0, v0), (t1, v1) in zip(pairs, pairs[1:]))


def rise_time(pairs):
    """Twice the time from half of the largest value to that value, as in benchmarks of
    sloshing impacts (L. Loysel et al., ISOPE 2012)."""
    peak = max(range(len(pairs)), key=lambda i: pairs[i][1])
    half, i = 0.5 * pairs[peak][1], peak
    while i > 0 and pairs[i - 1][1] > half:
        i -= 1
    if i == 0:
        return None  # it was above half from the start
    (t0, v0), (t1, v1) = pairs[i - 1], pairs[i]
    return 2 * (pairs[peak][0] - t0 - (t1 - t0) * (half - v0) / (v1 - v0))


def collect(source, statistics, summary):
    """Value of "errors/NAME" (summary.json) or "last(COLUMN)" and the like
    (statistics.csv); None if it is missing."""
    match = COLUMN.match(source)
    if not match:
        value = summary
        for part in source.split("/"):
            value = value.get(part) if isinstance(value, dict) else None
        return value
    kind, column = match.group(1) or "at", (match.group(2) or match.group(3)).strip()
    times = statistics.get("time [s]", [])
    pairs = [(t, v) for t, v in zip(times, statistics.get(column, [])) if v is not None]
    if not pairs:
        return None
    values = [v for _, v in pairs]
    if kind == "at":
        time = float(match.group(4))
        for (t0, v0), (t1, v1) in zip(pairs, pairs[1:]):
            if t0 <= time <= t1:
                return v0 + (v1 - v0) * ((time - t0) / (t1 - t0) if t1 > t0 else 0.0)
        return None
    if kind in ("integral", "rise"):
        return (integral if kind == "integral" else rise_time)(pairs)
    return {"first": values[0], "last": values[-1], "min": min(values), "max": max(values),
            "mean": sum(values) / len(values)}[kind]


def fitted_order(sizes, errors):
    """Slope of log(error) over log(size) by least squares, and the orders
    between neighbours. Pairs without positive finite numbers do not count."""
    pairs = sorted(
        (math.log(h), math.log(e)) for h, e in zip(sizes, errors)
        if all(isinstance(v, (int, float)) and 0 < v < math.inf for v in (h, e))
    )[::-1]
    if len({h for h, _ in pairs}) < 2:
        return None, []
    mean_h = sum(h for h, _ in pairs) / len(pairs)
    mean_e = sum(e for _, e in pairs) / len(pairs)
    spread = sum((h - mean_h) ** 2 for h, _ in pairs)
    slope = sum((h - mean_h) * (e - mean_e) for h, e in pairs) / spread
    between = [(e0 - e1) / (h0 - h1) for (h0, e0), (h1, e1) in zip(pairs, pairs[1:]) if h0 != h1]
    return slope, between
