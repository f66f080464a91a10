# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of the figures of the founding paper: running means, comparison with
a record whose origin of time is not known, tables. Needs numpy only."""

import csv
import os

import numpy


def smoothed(time, value, width):
    """Centred running mean over a width [s], on the samples of the run; at the
    ends over what there is."""
    if len(time) < 2:
        return value
    areas = 0.5 * (value[1:] + value[:-1]) * numpy.diff(time)
    integral = numpy.concatenate([[0], numpy.cumsum(areas)])
    low = numpy.clip(time - width / 2, time[0], time[-1])
    high = numpy.clip(time + width / 2, time[0], time[-1])
    return (numpy.interp(high, time, integral) - numpy.interp(low, time, integral)) / (high - low)


def mean_between(time, value, begin, end):
    """(mean over time, standard deviation) in a window, or None if the samples
    do not reach through it."""
    if len(time) == 0 or time[-1] < end - 0.01:
        return None
    t = numpy.linspace(begin, end, 2001)
    v = numpy.interp(t, time, value)
    return v.mean(), v.std()


def best_shift(time, value, record_time, record, last, largest=0.1):
    """(shift, rms) of a curve against a record whose clock is late by one
    shift [s], |shift| <= largest: that of least rms until `last` on the clock of
    the curve. None if the curve ends before."""
    if len(time) == 0 or time[-1] < last - 0.01:
        return None
    results = []
    for shift in numpy.arange(-largest, largest + 1e-9, 0.0005):
        moved = record_time - shift
        inside = (moved >= 0) & (moved <= last)
        error = numpy.interp(moved[inside], time, value) - record[inside]
        results.append((numpy.sqrt(numpy.mean(error**2)), shift))
    rms, shift = min(results)
    return shift, rms


def text_of(value):
    if value is None or value == "":
        return "-"
    return "%.4g" % value if isinstance(value, (float, numpy.floating)) else str(value)


class Numbers:
    """Tables of what the figures say: title -> run -> quantity -> value."""

    def __init__(self):
        self.tables = {}

    def add(self, title, run, **quantities):
        """Quantities with their unit as keys; more may follow for the same run."""
        self.tables.setdefault(title, {}).setdefault(run, {}).update(quantities)

    def add_study(self, title, runs, columns):
        """A line a run: {heading: column of results.csv}."""
        for name, variant in runs.items():
            values = {}
            for heading, column in columns.items():
                text = variant.row.get(column) or ""
                try:
                    values[heading] = float(text)
                except ValueError:
                    values[heading] = text
            self.add(title, name, **values)

    def markdown(self):
        parts = []
        for title, lines in self.tables.items():
            headings = list(dict.fromkeys(name for line in lines.values() for name in line))
            parts += ["**%s**" % title, "", "| run | " + " | ".join(headings) + " |",
                      "|" + "---|" * (len(headings) + 1)]
            for run, line in lines.items():
                cells = [text_of(line.get(name)) for name in headings]
                parts.append("| " + " | ".join([run] + cells) + " |")
            parts.append("")
        return "\n".join(parts)

    def write(self, folder):
        """figures.csv, a number a line, and figures.md, the tables."""
        with open(os.path.join(folder, "figures.csv"), "w", newline="", encoding="utf-8") as file:
            table = csv.writer(file)
            table.writerow(["table", "run", "quantity", "value"])
            for title, lines in self.tables.items():
                for run, line in lines.items():
                    for name, value in line.items():
                        table.writerow([title, run, name, "" if value is None else value])
        with open(os.path.join(folder, "figures.md"), "w", encoding="utf-8") as file:
            file.write(self.markdown())
