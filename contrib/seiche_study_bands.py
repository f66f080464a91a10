# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error bars of a study's results from the companion runs of each variant: order,
uncertainty of the grid, spread of the replicas. Standard library only; what the
columns mean: doc/studies.md."""

import csv
import math
import os

from seiche_study import OUTCOME, ALWAYS, StudyError, text_of
from seiche_study_companions import FACTORS, FINEST
from seiche_study_results import read_statistics, read_summary

# Columns of statistics.csv whose maximum gets a band.
GAUGES = ("gauge ", "depth ", "run-up ", "mean level", "probe ", "force ", "moment ")
SIGNED = ("force ", "moment ")  # and their minimum
LOWEST_ORDER = 0.5  # that is used
SAFETY, SAFETY_OUTSIDE = 1.25, 3.0  # factors of the GCI (Roache 1994)
ROUND_OFF = 1e-10  # of the values
SIMILAR = 0.05  # share by which a ratio of sizes may miss 2
SMALLEST_RATIO = 1.3  # of sizes (Celik et al. 2008)
# 97.5 % quantile of Student's t for 1, 2, ... degrees of freedom
QUANTILES = (12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228)
COLUMNS = ["quantity", "value", "order", "method", "grid uncertainty", "replicas",
           "standard deviation", "replica uncertainty", "uncertainty", "low", "high",
           "truth", "inside", "remark"]


def observed_order(near, far, ratio_near, ratio_far):
    """p of f = f0 + a h^p from the differences near = f2 - f1, far = f3 - f2 of the
    same sign, with h2 = ratio_near h1, h3 = ratio_far h2 (Celik et al. 2008, eq. 3);
    None where the differences grow towards finer grids."""

    def quotient(p):
        return (ratio_far ** p - 1) / (1 - ratio_near ** -p)

    low, high, wanted = 1e-6, 20.0, far / near
    if wanted <= quotient(low):
        return None
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if quotient(middle) < wanted else (low, middle)
    return low


def grid_uncertainty(values, sizes, highest_order=1.0):
    """(observed order or None, name of the method, half width) of the value on the
    first of three grids: the grid convergence index of Roache (1994) with an order
    of at most the one given, one for free surfaces, from the pair of grids that
    gives more. Not the order observed as it is (Celik et al. 2008): one that is
    too high by accident, or differences that change their sign, make bands that
    miss (doc/studies.md)."""
    near, far = values[1] - values[0], values[2] - values[1]
    ratio_near, ratio_far = sizes[1] / sizes[0], sizes[2] / sizes[1]
    if max(abs(near), abs(far)) <= ROUND_OFF * max(map(abs, values)):
        return None, "same on all grids", 0.0
    order, used, safety, name = None, highest_order, SAFETY, "up and down"
    if near * far > 0:
        order, name = observed_order(near, far, ratio_near, ratio_far), ""
        used = min(max(order or 0.0, LOWEST_ORDER), highest_order)
        safety = SAFETY if order is not None and order >= LOWEST_ORDER else SAFETY_OUTSIDE
    errors = [abs(near) / (ratio_near ** used - 1),
              abs(far) / (ratio_near ** used * (ratio_far ** used - 1))]
    return order, f"GCI {safety:g} {name}".strip(), safety * max(errors)


def spread(values):
    """(standard deviation, half width at 95 % of one value) of a run and its replicas."""
    n = len(values)
    if n < 2:
        return None, 0.0
    mean = math.fsum(values) / n
    deviation = math.sqrt(math.fsum((v - mean) ** 2 for v in values) / (n - 1))
    return deviation, QUANTILES[n - 2] * deviation


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def quantities(study, row, folder):
    """{name: value} of a run: its columns of [collect], scores, maxima of gauges."""
    skip = {*ALWAYS, *OUTCOME}
    found = {name: row.get(name) for name in study.columns if name not in skip}
    sources = set(study.columns.values())
    for name, value in read_summary(folder).get("errors", {}).items():
        if f"errors/{name}" not in sources:
            found[f"score {name}"] = value
    for column, values in read_statistics(folder).items():
        values = [v for v in values if v is not None and math.isfinite(v)]
        wanted = column.startswith(GAUGES) and " spray [" not in column
        ends = {"max": max, "min": min} if column.startswith(SIGNED) else {"max": max}
        for end, of in ends.items() if wanted and values else ():
            if f"{end}({column})" not in sources:
                found[f"{end} {column}"] = of(values)
    return {name: value for name, value in found.items() if is_number(value)}


FINISHED = (0, 6)  # a run that fails its own verdict has measured, too


class Run:
    """What one run contributes: its quantities, the size of its cells."""

    def __init__(self, study, variant, outcome, folder):
        self.row = study.row(variant, outcome, folder)
        self.passed = outcome["exit_code"] in FINISHED
        self.quantities = quantities(study, self.row, folder) if self.passed else {}
        summary = read_summary(folder)
        self.size = (summary["cells"] ** (-1.0 / summary["dim"])
                     if summary.get("cells") and summary.get("dim") else None)


class Bands:
    """Bands of all variants of a study from the runs that there are."""

    def __init__(self, study, bars, find_run):
        """find_run(variant): its Run, or None if it was not run."""
        self.study, self.bars = study, bars
        self.runs, self.rows, self.n_inside, self.n_known = {}, [], 0, 0
        for variant in study.variants:
            companions = {key: find_run(v) for key, v in bars.companions(variant).items()}
            if companions[1, 0] is not None and companions[1, 0].passed:
                self.runs[variant.name] = (variant, companions)
        for variant, companions in self.runs.values():
            for name in companions[1, 0].quantities:
                self.rows.append(self.row(variant, companions, name))

    @staticmethod
    def sample(companions, factor, name):
        """Values of the run of that size and its replicas, the run first."""
        return [run.quantities[name] for (of, _), run in sorted(companions.items())
                if of == factor and run is not None and name in run.quantities]

    def sizes(self, companions):
        """Cell sizes of the three grids and a remark about them, or None and why."""
        runs = [companions[factor, 0] for factor in FACTORS]
        for factor, run in zip(FACTORS, runs):
            if run is None or not run.passed or not run.size:
                cause = run.row["cause"] if run is not None else "not run"
                return None, f"no grid uncertainty: run with {factor}h: {cause}"
        sizes = [run.size for run in runs]
        ratios = [sizes[1] / sizes[0], sizes[2] / sizes[1]]
        if min(ratios) < SMALLEST_RATIO:
            return None, "no grid uncertainty: cells of the coarse runs are hardly larger"
        bad = any(abs(ratio / 2 - 1) > SIMILAR for ratio in ratios)
        return sizes, "ratios of cells %.2f, %.2f instead of 2" % tuple(ratios) if bad else ""

    def row(self, variant, companions, name):
        samples = [self.sample(companions, factor, name) for factor in FACTORS]
        value = samples[0][0]
        sizes, remark = self.sizes(companions)
        if sizes and not all(samples):
            sizes, remark = None, "no grid uncertainty: a coarse run has no value"
        order, method, of_grid = (None, "", None) if not sizes else grid_uncertainty(
            [sample[0] for sample in samples], sizes, self.bars.order)
        missing = self.bars.replicas + 1 - len(samples[0])
        if missing:
            remark = "; ".join(filter(None, [remark, f"without {missing} replicas"]))
        deviation, of_replicas = spread(samples[0])
        both = None if of_grid is None else math.hypot(of_grid, of_replicas)
        result = dict(zip(COLUMNS, [
            name, value, order, method, of_grid, len(samples[0]) - 1, deviation, of_replicas, both,
            None if both is None else value - both, None if both is None else value + both]))
        result.update(folder=variant.name, settings=variant.settings, remark=remark,
                      truth=self.truth(variant, name), inside=None)
        if both is not None and result["truth"] is not None:
            slack = ROUND_OFF * max(abs(value), abs(result["truth"]))
            inside = result["low"] - slack <= result["truth"] <= result["high"] + slack
            result["inside"] = "yes" if inside else "no"
            if both > 0:  # one that is the same everywhere proves nothing
                self.n_known += 1
                self.n_inside += inside
        return result

    def truth(self, variant, name):
        """A number, or None; the mean over the replicas of the finest grid on request."""
        truth = self.bars.truth(name, variant)
        if truth != FINEST:
            return truth
        scaled = {*self.bars.exponents(variant)}
        like = [(v, runs) for v, runs in self.runs.values() if v.base == variant.base and all(
            v.raw.get(key) == variant.raw.get(key) for key in {*v.raw, *variant.raw} - scaled)]
        finest, runs = min(like, key=lambda pair: pair[1][1, 0].size or math.inf)
        if finest.name == variant.name or name not in runs[1, 0].quantities:
            return None
        sample = self.sample(runs, 1, name)
        return math.fsum(sample) / len(sample)

    def write(self, folder):
        """error_bars.csv and error_bars.txt; returns the text."""
        settings = self.study.settings
        path = os.path.join(folder, "error_bars.csv")
        with open(path + ".new", "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(["folder", *settings, *COLUMNS])
            for row in self.rows:
                cells = [row["settings"].get(key) for key in settings] + [row[key] for key in COLUMNS]
                writer.writerow([row["folder"], *("" if cell is None else text_of(cell) for cell in cells)])
        os.replace(path + ".new", path)
        text = self.text()
        with open(os.path.join(folder, "error_bars.txt"), "w", encoding="utf-8") as file:
            file.write(text)
        return text

    def text(self):
        lines, last = [], None
        for row in self.rows:
            if row["folder"] != last:
                last = row["folder"]
                lines += ["", last, "  %-36s %11s   %-11s %6s  %-17s %10s %10s  %s" % (
                    "quantity", "value", "+-", "order", "method", "grid", "replicas", "truth")]

            def number(key, digits="%.4g"):
                return "-" if row[key] is None else digits % row[key]

            truth = "" if row["truth"] is None else "%.4g %s" % (
                row["truth"], {"yes": "inside", "no": "OUTSIDE", None: ""}[row["inside"]])
            lines.append(("  %-36s %11s   %-11s %6s  %-17s %10s %10s  %s  %s" % (
                row["quantity"], number("value"), number("uncertainty", "%.2g"),
                number("order", "%.2f"), row["method"], number("grid uncertainty", "%.2g"),
                number("replica uncertainty", "%.2g"), truth, row["remark"])).rstrip())
        if self.n_known:
            lines += ["", f"{self.n_inside} of {self.n_known} bands hold the truth"]
        return "\n".join(lines).lstrip("\n") + "\n"
