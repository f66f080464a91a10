#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a parameter study; called by contrib/study.

    contrib/seiche_study_plots.py FILE.toml DIR

reads DIR/results.csv and writes one PNG for each [[plot]] of the study file,
and DIR/orders.csv with the fitted orders of the convergence plots. Error bars of
DIR/error_bars.csv, if it is there, become bands.
"""

import csv
import os
import sys

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError as error:
    system = "/usr/bin/python3"  # has the Debian packages
    if os.path.exists(system) and "SEICHE_SYSTEM_PYTHON" not in os.environ:
        os.environ["SEICHE_SYSTEM_PYTHON"] = "1"
        os.execv(system, [system] + sys.argv)
    print("contrib/study: no pictures: %s (Debian: python3-matplotlib)" % error, file=sys.stderr)
    sys.exit(0)

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from seiche_study import Study, StudyError, evaluate, slug, text_of
from seiche_study_results import fitted_order

MARKERS = "osD^vP*Xh<>"
# Lines that a legend within the panel can name; more are numbered, with one legend below.
MOST_IN_PANEL = 14
GRID_MAXIMUM = 12  # values of a setting that still make a grid
PASSED = "#2a9d50"


def read_rows(path):
    """Rows of results.csv with numbers where there are numbers."""

    def value(text):
        try:
            return float(text)
        except ValueError:
            return text if text != "" else None

    with open(path, newline="", encoding="utf-8") as file:
        return [{key: value(text) for key, text in row.items()} for row in csv.DictReader(file)]


def add_error_bars(rows, path):
    """Each row gets its "bands": {quantity: (low, high)}."""
    bars = {}
    for bar in read_rows(path) if os.path.exists(path) else ():
        if bar["low"] is not None:
            bars.setdefault(bar["folder"], {})[bar["quantity"]] = (bar["low"], bar["high"])
    for row in rows:
        row["bands"] = bars.get(row["folder"], {})


def is_positive(value):
    return isinstance(value, float) and 0 < value < float("inf")


def as_list(names):
    return [names] if isinstance(names, str) else list(names)


def label_of(row, names):
    return ", ".join(text_of(row.get(name, "")) for name in names) or "all"


def shown(plot, name):
    """What a column or setting is called in the picture."""
    return plot.get("names", {}).get(name, "processor time [s]" if name == "cpu_seconds" else name)


def legend_title(plot):
    return ", ".join(shown(plot, name) for name in as_list(plot.get("line", [])))


def panels(rows, plot):
    """[(title, rows)] by the value of "panel"."""
    groups = {}
    for row in rows:
        names = as_list(plot.get("panel", []))
        title = ", ".join(f"{shown(plot, name)} = {text_of(row.get(name, ''))}" for name in names)
        groups.setdefault(title, []).append(row)
    return list(groups.items())


def new_figure(number, width=6.2, height=4.6):
    wide = min(2, number)
    tall = -(-number // wide)
    figure, axes = plt.subplots(tall, wide, figsize=(width * wide, height * tall), squeeze=False,
                                layout="constrained")
    for unused in list(axes.flat)[number:]:
        unused.set_visible(False)
    return figure, list(axes.flat)[:number]


def curves(rows, plot, quantity, x):
    """{label: [(x, y)]} of the finished runs in the order of the table, and the
    labels of failed ones."""
    lines, failed = {}, []
    for row in rows:
        label = label_of(row, as_list(plot.get("line", [])))
        lines.setdefault(label, [])
        if row["exit_code"] == 0 and is_positive(row.get(x)) and is_positive(row.get(quantity)):
            lines[label].append((row[x], row[quantity]))
        else:
            failed.append(label)
    return lines, failed


def styles(rows, plot):
    """{label of a line: how it is drawn}, the same in all panels."""
    labels = dict.fromkeys(label_of(row, as_list(plot.get("line", []))) for row in rows)
    if len(labels) > MOST_IN_PANEL:
        return {label: {"color": f"C{i % 10}", "marker": f"${i + 1}$", "lw": 0.5, "ms": 8, "mew": 0.3}
                for i, label in enumerate(labels)}
    return {label: {"color": f"C{i % 10}", "marker": MARKERS[i % len(MARKERS)], "lw": 1, "ms": 5,
                    "ls": "-" if i < 10 else "--"}
            for i, label in enumerate(labels)}


def draw_bands(axes, rows, plot, quantity, x, style):
    """Error bars around the lines that are drawn already. Values that hardly vary are
    no errors: their axes become linear; elsewhere the bands are cut off below."""
    values = [row[quantity] for row in rows if is_positive(row.get(quantity))]
    if not values or not any(quantity in row["bands"] for row in rows):
        return
    linear, bands = max(values) < 2 * min(values), {}
    bottom = -float("inf") if linear else 0.3 * min(values)
    for row in rows:
        if quantity in row["bands"] and is_positive(row.get(x)) and is_positive(row.get(quantity)):
            low, high = row["bands"][quantity]
            label = label_of(row, as_list(plot.get("line", [])))
            bands.setdefault(label, []).append((row[x], max(low, bottom), high))
    for label, points in bands.items():
        at, low, high = zip(*sorted(points))
        axes.fill_between(at, low, high, color=style[label]["color"], alpha=0.15, lw=0)
        axes.vlines(at, low, high, color=style[label]["color"], alpha=0.4, lw=1.5)
    if linear:
        axes.set_yscale("linear")
        lowest, highest = (pick(v for points in bands.values() for point in points for v in point[1:])
                           for pick in (min, max))
        lowest, highest = min(lowest, *values), max(highest, *values)
        axes.set_ylim(lowest - 0.05 * (highest - lowest), highest + 0.05 * (highest - lowest))


def add_failures(axes, failed):
    """Runs without a point are named, not left out silently."""
    if failed:
        counts = {label: failed.count(label) for label in dict.fromkeys(failed)}
        text = "failed: " + "; ".join(f"{label} ({n})" for label, n in list(counts.items())[:6])
        axes.set_title(axes.get_title() + "\n" + text[:110], fontsize=8, color="0.35")


def draw_work(rows, plot):
    """Error against processor time, one line a method."""
    x, quantities = plot.get("x", "cpu_seconds"), as_list(plot["y"])
    all_panels = [(title, q, part) for title, part in panels(rows, plot) for q in quantities]
    figure, all_axes = new_figure(len(all_panels))
    style = styles(rows, plot)
    for axes, (title, quantity, part) in zip(all_axes, all_panels):
        lines, failed = curves(part, plot, quantity, x)
        for label, points in lines.items():
            if points:
                axes.loglog(*zip(*points), **style[label], label=label)
        draw_bands(axes, part, plot, quantity, x, style)
        axes.set_xlabel(shown(plot, x))
        axes.set_ylabel(shown(plot, quantity))
        axes.set_title(title, fontsize=10)
        add_failures(axes, failed)
        axes.grid(alpha=0.3, which="both")
        if len(style) <= MOST_IN_PANEL:
            axes.legend(fontsize=7, title=legend_title(plot), title_fontsize=7)
    if len(style) > MOST_IN_PANEL:
        handles = {label: handle for axes in all_axes
                   for handle, label in zip(*axes.get_legend_handles_labels())}
        figure.legend(handles.values(), handles.keys(), loc="upper center", bbox_to_anchor=(0.5, 0), fontsize=7, ncol=5)
    return figure


def draw_convergence(rows, plot, table):
    """Errors over size with fitted orders; lines of the table are appended."""
    x = plot["x"]
    all_panels = [(t, q, part) for t, part in panels(rows, plot) for q in as_list(plot["y"])]
    figure, all_axes = new_figure(len(all_panels))
    style = styles(rows, plot)
    for axes, (title, quantity, part) in zip(all_axes, all_panels):
        lines, failed = curves(part, plot, quantity, x)
        for label, points in lines.items():
            if not points:
                continue
            points.sort()
            order, between = fitted_order(*zip(*points))
            fit = "" if order is None else f" ({order:.2f})"
            axes.loglog(*zip(*points), **style[label], label=label + fit)
            table.append([plot.get("file", "convergence"), title, label, quantity, len(points),
                          "" if order is None else f"{order:.3f}",
                          " ".join(f"{value:.3f}" for value in between)])
        draw_bands(axes, part, plot, quantity, x, style)
        axes.set_xlabel(shown(plot, x))
        axes.set_ylabel(shown(plot, quantity))
        axes.set_title(title, fontsize=10)
        add_failures(axes, failed)
        axes.grid(alpha=0.3, which="both")
        axes.legend(fontsize=7, title=legend_title(plot) + " (fitted order)", title_fontsize=7)
    return figure


def axis_of(rows, name):
    """(positions by value, logarithmic, labels or None) of a setting."""
    values = {row.get(name) for row in rows} - {None}
    numbers = sorted(v for v in values if isinstance(v, float))
    words = sorted(v for v in values if not isinstance(v, float))
    if len(values) <= GRID_MAXIMUM or not numbers:
        order = numbers + words
        return {v: i for i, v in enumerate(order)}, False, [text_of(v) for v in order]
    logarithmic = bool(numbers) and numbers[0] > 0 and numbers[-1] / numbers[0] > 50
    places = {v: v for v in numbers}
    # words, such as infinite, beyond the largest number
    for i, word in enumerate(words):
        places[word] = numbers[-1] * 10 ** (i + 1) if logarithmic else numbers[-1] * (1.1 + 0.1 * i)
    return places, logarithmic, None


def draw_map(rows, plot):
    """Passed and failed runs over two settings; causes by colour and name."""
    names = (plot["x"], plot["y"])
    causes = sorted({row["cause"] for row in rows if row["cause"]})
    colours = {name: ("#d62728", "#1f77b4", "#9467bd", "#ff7f0e", "#8c564b", "#e377c2", "k")[i % 7]
               for i, name in enumerate(causes)}
    all_panels = panels(rows, plot)
    figure, all_axes = new_figure(len(all_panels))
    axis = [axis_of(rows, name) for name in names]
    for axes, (title, part) in zip(all_axes, all_panels):
        stacks = {}
        for row in part:
            if row.get(names[0]) is not None and row.get(names[1]) is not None:
                place = tuple(axis[i][0][row[names[i]]] for i in (0, 1))
                stacks.setdefault(place, []).append(row["cause"] or "")
        if axis[0][2] and axis[1][2]:
            draw_cells(axes, stacks, colours)
        else:
            for cause in ["", *causes]:  # failures above
                points = [place for place, found in stacks.items() for c in found if c == cause]
                if points:
                    axes.scatter(*zip(*points), s=16 if not cause else 34, lw=0.9,
                                 marker="o" if not cause else "X",
                                 color=colours[cause] if cause else PASSED, alpha=0.8)
        for i, (set_scale, set_ticks) in enumerate((
                (axes.set_xscale, axes.set_xticks), (axes.set_yscale, axes.set_yticks))):
            if axis[i][2]:
                set_ticks(range(len(axis[i][2])), axis[i][2])
            elif axis[i][1]:
                set_scale("log")
        axes.set_xlabel(shown(plot, names[0]))
        axes.set_ylabel(shown(plot, names[1]))
        n_failed = sum(1 for row in part if row["cause"])
        title = title + ": " if title else ""
        axes.set_title(f"{title}{n_failed} of {len(part)} failed", fontsize=10)
    counts = {cause: sum(row["cause"] == cause for row in rows) for cause in causes}
    handles = [plt.Line2D([], [], marker="o", ls="", color=PASSED, label="passed (%d)" % sum(
        not row["cause"] for row in rows))]
    handles += [plt.Line2D([], [], marker="X", ls="", color=colours[c], label=f"{c} ({counts[c]})")
                for c in causes]
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0),
                  ncols=4, fontsize=8)
    return figure


def draw_cells(axes, stacks, colours):
    """One square for each pair of values: the share that passed in green, the
    causes in their colours, failed/all as text."""
    for (x, y), found in stacks.items():
        left = x - 0.45
        for cause in sorted(set(found)):
            width = 0.9 * found.count(cause) / len(found)
            axes.add_patch(plt.Rectangle((left, y - 0.45), width, 0.9, lw=0, alpha=0.75,
                                         fc=colours[cause] if cause else PASSED))
            left += width
        n_failed = sum(1 for cause in found if cause)
        axes.text(x, y, f"{n_failed}/{len(found)}", ha="center", va="center", fontsize=7)
    axes.set_xlim(min(x for x, _ in stacks) - 0.6, max(x for x, _ in stacks) + 0.6)
    axes.set_ylim(min(y for _, y in stacks) - 0.6, max(y for _, y in stacks) + 0.6)


def draw(study, folder):
    rows, orders = read_rows(os.path.join(folder, "results.csv")), []
    add_error_bars(rows, os.path.join(folder, "error_bars.csv"))
    for i, plot in enumerate(study.plots):
        kind = plot["kind"]
        part = [row for row in rows
                if "only" not in plot or evaluate(plot["only"], row, f"{study.path}: plot {i + 1}")]
        if not part:
            continue
        if kind == "convergence":
            figure = draw_convergence(part, plot, orders)
        else:
            figure = (draw_work if kind == "work" else draw_map)(part, plot)
        figure.suptitle(plot.get("title", study.title), fontsize=11)
        path = os.path.join(folder, slug(plot.get("file", f"{kind}_{i + 1}")) + ".png")
        figure.savefig(path, dpi=100, bbox_inches="tight")
        plt.close(figure)
        print(path)
    if orders:
        header = ["plot", "panel", "line", "quantity", "points", "fitted order",
                  "orders between neighbours"]
        with open(os.path.join(folder, "orders.csv"), "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([header, *orders])
        for line in orders:
            print("%-28s %-28s %-18s order %-7s (%s)" % (line[1], line[2], line[3], line[5], line[6]))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        print(__doc__)
        sys.exit(2)
    try:
        draw(Study(sys.argv[1]), sys.argv[2])
    except (StudyError, OSError) as problem:
        print("contrib/study: no pictures: %s" % problem, file=sys.stderr)
        sys.exit(1)
