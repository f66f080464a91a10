# SPDX-License-Identifier: LGPL-2.1-or-later
"""Companion runs of a variant, for its error bars: the same scene with cells and
steps twice and four times as large, and replicas with another start of the points. Standard library only; doc/studies.md describes [error_bars]."""

import re

from seiche_study import StudyError, base_text, evaluate, text_of

FACTORS = (1, 2, 4)  # cells and steps over those of the variant
MOST_REPLICAS = 10
DEFAULT_SCALE = {"Grid/Cell size": 1, "Grid/Cells x": -1, "Grid/Cells y": -1, "Grid/Cells z": -1,
                 "Time/Step": 1}
SIZES = [name for name in DEFAULT_SCALE if name.startswith("Grid/")]
FINEST = "finest"


def entries_of(path):
    """{"Section/Entry": text} of a parameter file with its includes."""
    found, sections = {}, []
    for line in base_text(path).split("\n"):
        if line.startswith("subsection "):
            sections.append(line[len("subsection "):])
        elif line == "end" and sections:
            sections.pop()
        elif line.startswith("set ") and "=" in line:
            name, value = line[len("set "):].split("=", 1)
            found["/".join([*sections, name.strip()])] = value.strip()
    return found


def scaled(value, factor, where):
    """A number, or each of a list "8, 16", times a factor; whole numbers (of
    cells) that are divided have to stay whole."""
    results = []
    for text in text_of(value).split(","):
        try:
            number = float(text) * factor
        except ValueError:
            raise StudyError(f"{where}: {text_of(value)!r} is no number that could be scaled") from None
        if factor < 1 and re.fullmatch(r"\s*\d+\s*", text):
            if number != int(number) or number < 1:
                raise StudyError(f"{where} = {text_of(value)}: cells {1 / factor:g} times as large "
                                 f"need whole multiples of {1 / factor:g} here; a study file with "
                                 "a variable for the size and 'scale' may say otherwise")
            number = int(number)
        results.append(number)
    return results[0] if len(results) == 1 else ", ".join(map(text_of, results))


class ErrorBars:
    """The table [error_bars] of a study file."""

    KEYS = {"replicas": 4, "jitter": 0.2, "order": 1, "scale": None, "truth": {}}

    def __init__(self, study):
        self.study, table = study, study.data.get("error_bars", {})
        where = f"{study.path}: error_bars"
        if not isinstance(table, dict):
            raise StudyError(f"{where} has to be a table, [error_bars]")
        for key in table:
            if key not in self.KEYS:
                raise StudyError(f"{where}: there is no key {key!r}; known: {', '.join(self.KEYS)}")
        self.replicas, self.jitter, self.order, self.scale, self.truths = (
            table.get(key, default) for key, default in self.KEYS.items())
        if not isinstance(self.replicas, int) or not 0 <= self.replicas <= MOST_REPLICAS:
            raise StudyError(f"{where}: 'replicas' has to be a whole number from 0 to {MOST_REPLICAS}")
        if not isinstance(self.jitter, (int, float)) or not 0 < self.jitter <= 0.5:
            raise StudyError(f"{where}: 'jitter' has to be a number above 0, at most 0.5")
        if not isinstance(self.order, (int, float)) or not 0.5 <= self.order <= 4:
            raise StudyError(f"{where}: 'order' has to be a number from 0.5 to 4")
        for key, kind in (("scale", (int, float)), ("truth", (int, float, str))):
            values = table.get(key, {})
            if not isinstance(values, dict) or not all(isinstance(v, kind) for v in values.values()):
                raise StudyError(f"{where}: {key!r} has to be a table, as in doc/studies.md")

    def exponents(self, variant):
        """{setting: exponent of the factor}."""
        known = {**entries_of(variant.base), **variant.settings}
        scale = self.scale or {
            name: power for name, power in DEFAULT_SCALE.items()
            if text_of(known.get(name, "0")).strip() not in ("", "0")}
        for name in scale:
            if name not in known:
                raise StudyError(f"{self.study.path}: error_bars: scale: there is no setting {name!r}")
        if not self.scale and not any(name in scale for name in SIZES):
            raise StudyError(f"{variant.base}: no entry sets the size of the cells; "
                             "'scale' in [error_bars] of a study file has to say what does")
        return {name: (power, known[name]) for name, power in scale.items()}

    def companions(self, variant):
        """{(factor, replica): variant}; (1, 0) is the variant itself."""
        base, result = entries_of(variant.base), {}
        known = {**base, **variant.entries}
        jitter = float(known.get("Points/Jitter", 0)) or self.jitter
        own = int(known.get("Points/Seed", 1)) if "Points/Jitter" in known else 0
        seeds = [seed for seed in range(1, self.replicas + 2) if seed != own][:self.replicas]
        for factor in FACTORS:
            raw = dict(variant.raw)
            for name, (power, value) in self.exponents(variant).items():
                if factor != 1:
                    raw[name] = scaled(value, factor ** power, f"{variant.name}: {name}")
            result[factor, 0] = self.study.variant(raw, variant.labels) if factor != 1 else variant
            for i, seed in enumerate(seeds if factor == 1 else ()):
                replica = {**raw, "Points/Jitter": jitter, "Points/Seed": seed}
                labels = list(dict.fromkeys([*variant.labels, "Points/Seed"]))
                result[factor, i + 1] = self.study.variant(replica, labels)
        return result

    def truth(self, quantity, variant):
        """True value of a quantity: a number, FINEST, or None if nobody knows."""
        value = self.truths.get(quantity, self.truths.get("*"))
        if isinstance(value, str) and value != FINEST:
            value = evaluate(value, variant.settings, f"{self.study.path}: error_bars: truth")
        return float(value) if isinstance(value, (int, float)) else value
