# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameter studies: read a study file, expand its variants, collect results.

Needs nothing but the standard library; the format is described in
doc/studies.md. Used by contrib/study, which runs the variants, and by
seiche_study_plots.py. What a run left is read by seiche_study_results.py.
"""

import ast
import csv
import hashlib
import itertools
import json
import math
import os
import random
import re
import tomllib

from seiche_study_results import COLUMN, cause, collect, read_statistics, read_summary

FUNCTIONS = {
    name: getattr(math, name)
    for name in ("sqrt", "exp", "log", "log10", "floor", "ceil", "pi", "inf")
}
FUNCTIONS.update(min=min, max=max, abs=abs, round=round, int=int)
NODES = (
    ast.Expression, ast.BinOp, ast.UnaryOp, ast.BoolOp, ast.Compare, ast.IfExp, ast.Call,
    ast.Name, ast.Load, ast.Constant, ast.operator, ast.unaryop, ast.boolop, ast.cmpop,
    ast.Tuple, ast.List,
)
TABLES = {"title", "base", "timeout", "restart", "set", "vary", "variants", "sample", "skip",
          "collect", "fail", "plot", "error_bars"}
PLOT_KEYS = {"kind", "file", "title", "x", "y", "line", "panel", "only", "names"}
PLOT_KINDS = ("work", "convergence", "map")
ALWAYS = {  # columns of every study
    "cpu_seconds": "cpu_seconds",
    "steps": "steps",
    "rejected_steps": "rejected_steps",
    "newton_iterations": "newton_iterations",
    "krylov_iterations": "krylov_iterations",
    "end_time": "last(time [s])",
}
OUTCOME = ["exit_code", "cause", "message", "program", "wall_seconds"]


class StudyError(Exception):
    """A mistake in a study file, as one message."""


class FloatPowers(ast.NodeTransformer):
    """Powers of floats: those of whole numbers may take for ever."""

    def visit_BinOp(self, node):
        self.generic_visit(node)
        if isinstance(node.op, ast.Pow):
            node.left = ast.Call(ast.Name("float", ast.Load()), [node.left], [])
        return node


def parse(text, known, where):
    """Tree of an expression of numbers, names that are known and a few functions."""
    try:
        tree = ast.parse(text.strip(), mode="eval")
    except SyntaxError:
        raise StudyError(f"{where}: {text!r} is no expression") from None
    for node in ast.walk(tree):
        if not isinstance(node, NODES):
            raise StudyError(f"{where}: {text!r}: only numbers, names, operators and "
                             f"{', '.join(FUNCTIONS)} are allowed")
        if isinstance(node, ast.Name) and node.id not in FUNCTIONS and node.id not in known:
            raise StudyError(f"{where}: {text!r}: there is no variable {node.id!r}; known: "
                             + (", ".join(sorted(map(str, known))) or "none"))
    return ast.fix_missing_locations(FloatPowers().visit(tree))


def evaluate(text, names, where, known=None):
    """Value of an expression; known: what messages list, if more than names."""
    tree = parse(text, known or names, where)
    try:
        return eval(compile(tree, where, "eval"), {"__builtins__": {}, "float": float},
                    {**FUNCTIONS, **names})
    except StudyError:
        raise
    except Exception as error:
        raise StudyError(f"{where}: {text!r}: {error}") from None


def text_of(value):
    """A value as it stands in a parameter file."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return "infinite" if math.isinf(value) else f"{value:.10g}"
    return str(value)


class Names(dict):
    """Variables of one variant; texts with {expressions} are evaluated on the
    first use, so that they may refer to each other in any order."""

    def __init__(self, raw, where):
        super().__init__(raw)
        self.where, self.done, self.active = where, {}, []

    def __getitem__(self, name):
        if name not in self.done:
            if name in self.active:
                raise StudyError(f"{self.where}: {' -> '.join(self.active + [name])}: "
                                 "the expressions go round in a circle")
            self.active.append(name)
            self.done[name] = self.fill(super().__getitem__(name), name)
            self.active.pop()
        return self.done[name]

    def fill(self, value, name):
        """Replace every {expression} of a text."""
        if not isinstance(value, str) or "{" not in value:
            return value
        where = f"{self.where}: {name}"

        def value_of(part):
            used = set(re.findall(r"[A-Za-z_]\w*", part)) - FUNCTIONS.keys()
            return evaluate(part, {key: self[key] for key in used if key in self}, where,
                            known=self.keys())

        whole = re.fullmatch(r"\{([^{}]*)\}", value.strip())
        if whole:
            return value_of(whole.group(1))
        return re.sub(r"\{([^{}]*)\}", lambda match: text_of(value_of(match.group(1))), value)


def base_text(path, seen=()):
    """Parameter file with its includes and without comments, for the hash."""
    with open(path, encoding="utf-8") as file:
        lines = [line.split("#")[0].strip() for line in file]
    folder, parts = os.path.dirname(path), []
    for line in lines:
        match = re.match(r"include\s+(.+)", line)
        target = os.path.join(folder, match.group(1).strip()) if match else ""
        if match and os.path.isfile(target) and target not in seen:
            parts.append(base_text(target, (*seen, path)))
        elif line:
            parts.append(" ".join(line.split()))
    return "\n".join(parts)


class Variant:
    """One run: name of its folder, parameter file, entries, all settings; those
    before the evaluation of expressions are the raw ones."""

    def __init__(self, base, text, settings, label_names, raw):
        self.base = base
        self.settings, self.raw, self.labels = settings, raw, label_names
        self.entries = {name: text_of(v) for name, v in settings.items() if "/" in name}
        content = json.dumps([text, self.entries], sort_keys=True)
        label = "_".join(
            slug(name.split("/")[-1]) + "=" + slug(short(settings[name]))
            for name in label_names if name in settings
        )
        self.name = (label[:90].strip("-_") + "_" if label else "") + hashlib.sha256(
            content.encode()).hexdigest()[:8]


def short(value):
    return f"{value:.3g}" if isinstance(value, float) else text_of(value)


def slug(text):
    """Part of a name of a folder; the sign of a number is kept."""
    return re.sub(r"[^A-Za-z0-9.+]+", "-", text).rstrip("-") or "-"


class Study:
    """A study file, or a parameter file as the only variant."""

    def __init__(self, path):
        self.path = path
        name, ending = os.path.splitext(os.path.basename(path))
        try:
            with open(path, "rb") as file:
                self.data = ({"base": os.path.basename(path), "variants": [{"name": name}],
                              "timeout": 86400}
                             if ending == ".prm" else tomllib.load(file))
        except OSError as error:
            raise StudyError(f"{path}: {error.strerror}") from None
        except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
            raise StudyError(f"{path}: {error}") from None
        self.check_tables()
        self.title = self.data.get("title", os.path.basename(path))
        self.timeout = float(self.data.get("timeout", 600))
        self.restart = bool(self.data.get("restart", False))
        self.columns = {**ALWAYS, **self.data.get("collect", {})}
        self.conditions = self.data.get("fail", {})
        self.texts = {}  # of the parameter files
        self.variants = self.expand()
        self.settings = list(dict.fromkeys(n for v in self.variants for n in v.settings))
        self.plots = self.data.get("plot", [])
        self.check_plots()
        self.check_conditions()

    def fail(self, text):
        raise StudyError(f"{self.path}: {text}")

    def check_tables(self):
        for name in self.data:
            if name not in TABLES:
                self.fail(f"there is no table or key {name!r}; known: {', '.join(sorted(TABLES))}")
        for name in ("set", "vary", "sample", "collect", "fail"):
            if not isinstance(self.data.get(name, {}), dict):
                self.fail(f"{name!r} has to be a table, [{name}]")
        for name in ("variants", "plot", "skip"):
            if not isinstance(self.data.get(name, []), list):
                self.fail(f"{name!r} has to be a list")
        timeout = self.data.get("timeout", 1)
        if not isinstance(timeout, (int, float)) or timeout <= 0:
            self.fail("'timeout' has to be a positive number of seconds")
        for name, source in self.data.get("collect", {}).items():
            if not re.fullmatch(r"[A-Za-z_]\w*", name) or not isinstance(source, str):
                self.fail(f"collect: {name!r}: names are letters, digits and _, sources are texts")
            if "{" not in source and "(" in source and not COLUMN.match(source):
                self.fail(f"collect: {name!r}: {source!r}: known: errors/NAME and other paths in "
                          "summary.json, first, last, min, max, mean, integral, rise as in last(COLUMN), "
                          "at(COLUMN, TIME)")
        if not any(self.data.get(name) for name in ("vary", "variants", "sample")):
            self.fail("nothing varies: one of [vary], [[variants]], [sample] is needed; a single run "
                      "with error bars is contrib/study FILE.prm --error-bars")

    def check_plots(self):
        known = {*self.settings, *self.columns, *OUTCOME}
        for i, plot in enumerate(self.plots):
            where = f"plot {i + 1}"
            for key in plot:
                if key not in PLOT_KEYS:
                    self.fail(f"{where}: there is no key {key!r}; known: "
                              + ", ".join(sorted(PLOT_KEYS)))
            if plot.get("kind") not in PLOT_KINDS:
                self.fail(f"{where}: 'kind' has to be one of {', '.join(PLOT_KINDS)}")
            for key in ("x", "y"):
                if key not in plot and not (key == "x" and plot["kind"] == "work"):
                    self.fail(f"{where}: {key!r} is missing")
            for key in ("x", "y", "line", "panel"):
                names = plot.get(key, [])
                for name in [names] if isinstance(names, str) else names:
                    if name not in known:
                        self.fail(f"{where}: {key}: there is no setting or column {name!r}")

    def check_conditions(self):
        known = {*self.settings, *self.columns, *OUTCOME}
        for name, text in self.conditions.items():
            parse(text, known, f"{self.path}: fail: {name}")

    def factors(self):
        """[(name, [settings of each choice])], in the order of the file."""
        result = []
        for name, values in self.data.get("vary", {}).items():
            if not isinstance(values, list) or not values:
                self.fail(f"vary: {name!r} needs a list of values")
            result.append((name, [self.choice(name, value) for value in values]))
        if self.data.get("variants"):
            result.append(("variant", [self.choice("variant", v) for v in self.data["variants"]]))
        if self.data.get("sample"):
            result.append(("sample", self.sample(self.data["sample"])))
        return result

    def choice(self, name, value):
        """Settings of one choice: a value, or a table with a name."""
        if not isinstance(value, dict):
            return {name: value}
        if "name" not in value:
            self.fail(f"{name}: every table of it needs a 'name'")
        return {name: value["name"], **{k: v for k, v in value.items() if k != "name"}}

    def sample(self, table):
        """Latin hypercube: each range is cut into as many strata as there are
        samples, each list is used evenly; the pairing is at random."""
        count, seed = table.get("count"), table.get("seed", 1)
        if not isinstance(count, int) or count < 1:
            self.fail("sample: 'count' has to be a positive whole number")
        generator, columns = random.Random(seed), {}
        for name, of in table.items():
            if name in ("count", "seed"):
                continue
            if isinstance(of, list) and of:
                column = [of[i * len(of) // count] for i in range(count)]
            elif isinstance(of, dict) and {"from", "to"} <= of.keys() <= {"from", "to", "scale"}:
                log = of.get("scale", "linear") == "log"
                if log and min(of["from"], of["to"]) <= 0:
                    self.fail(f"sample: {name!r}: a scale of logarithms needs positive numbers")
                low, high = (math.log(of[k]) if log else of[k] for k in ("from", "to"))
                column = [low + (high - low) * (i + generator.random()) / count for i in range(count)]
                column = [float(f"{math.exp(v) if log else v:.4g}") for v in column]
            else:
                self.fail(f"sample: {name!r} needs a list or {{from = , to = , scale = \"log\"}}")
            generator.shuffle(column)
            columns[name] = column
        return [dict(zip(columns, row)) for row in zip(*columns.values())]

    def expand(self):
        variants, names = [], set()
        factors = self.factors()
        labels = [n for n, _ in factors if n != "sample"]
        labels += [n for n in self.data.get("sample", {}) if n not in ("count", "seed")]
        for choices in itertools.product(*(values for _, values in factors)):
            raw, owner = dict(self.data.get("set", {})), {}
            for (factor, _), choice in zip(factors, choices):
                for key, value in choice.items():
                    if key in owner:
                        self.fail(f"{key!r} is set by {owner[key]!r} and by {factor!r}")
                    owner[key] = factor
                    raw[key] = value
            variant = self.variant({"base": self.data.get("base"), **raw}, labels)
            settings = {"base": variant.base, **variant.settings}
            if any(evaluate(text, settings, f"{self.path}: skip")
                   for text in self.data.get("skip", [])):
                continue
            if variant.name not in names:
                names.add(variant.name)
                variants.append(variant)
        if not variants:
            self.fail("'skip' leaves no variant")
        return variants

    def variant(self, raw, labels):
        """The run of settings whose expressions are not evaluated yet."""
        names = Names(raw, self.path)
        settings = {key: names[key] for key in names}
        if not isinstance(settings["base"], str):
            self.fail("'base', the parameter file, is missing")
        base = os.path.normpath(os.path.join(os.path.dirname(self.path), settings.pop("base")))
        if not os.path.isfile(base):
            self.fail(f"base: there is no file {base}")
        if base not in self.texts:
            self.texts[base] = base_text(base)
        first = {n: settings[n] for n in labels if n in settings}
        return Variant(base, self.texts[base], {**first, **settings}, labels, raw)

    # ---- results ----

    def empty_columns(self, ordered):
        """Those of [collect] that no run which has finished has a value of."""
        finished = [row for _, row in ordered if int(row["exit_code"]) == 0]
        return {name: source for name, source in self.data.get("collect", {}).items()
                if finished and all(row.get(name) is None for row in finished)}

    def row(self, variant, outcome, folder):
        """The line of the table for a finished variant."""
        row = dict(variant.settings)
        statistics, summary = read_statistics(folder), read_summary(folder)
        code = outcome["exit_code"]
        row.update(exit_code=code, message=outcome.get("message", ""), cause=cause(outcome),
                   program=outcome.get("program"), wall_seconds=outcome.get("wall_seconds"))
        derived = {}
        for name, source in self.columns.items():
            if "{" in source:
                derived[name] = source
            else:
                row[name] = collect(source, statistics, summary)
        if row["cpu_seconds"] is None:
            row["cpu_seconds"] = outcome.get("cpu_seconds")
        if row["steps"] is None and statistics:
            row["steps"] = int(statistics["step"][-1] or 0)
        for name, source in derived.items():
            try:
                row[name] = Names({**row, name: source}, self.path)[name]
            except (StudyError, TypeError):
                row[name] = None  # a value that it needs is missing
        for name, condition in self.conditions.items():
            try:
                if not row["cause"] and evaluate(condition, row, f"{self.path}: fail: {name}"):
                    row["cause"] = name
            except StudyError:
                if code == 0:
                    raise
        return row

    def write_table(self, rows, path):
        header = ["folder", *self.settings, *OUTCOME, *self.columns]
        header = list(dict.fromkeys(header))
        with open(path + ".new", "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(header)
            for name, row in rows:
                writer.writerow([name] + [
                    "" if row.get(key) is None else text_of(row[key])
                    if isinstance(row.get(key), float) else row.get(key) for key in header[1:]])
        os.replace(path + ".new", path)
