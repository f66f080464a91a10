# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table (Markdown) and plot of a benchmark case."""

import os

COLUMNS = {  # heading -> key of a row
    "run": "run", "version": "version", "rounds": "rounds", "steps": "steps",
    "processor time, best [s]": "cpu_seconds", "median [s]": "cpu_seconds median",
    "a step, best [ms]": "seconds_a_step", "start-up, best [s]": "start_seconds",
    "Newton a step": "newton", "Krylov a step": "krylov",
}


def text_of(heading, value):
    if value is None:
        return ""
    if heading.endswith("[ms]"):
        value *= 1000
    return f"{value:.3g}" if isinstance(value, float) else str(value)


def write_table(path, case, rows, machine):
    """Writes and returns the table of a case."""
    columns = {**COLUMNS, **{f"error of {name}": name for name in case.errors}}
    lines = [f"# {case.title}", "", machine["text"], "",
             "| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    for row in rows:
        lines.append("| " + " | ".join(text_of(h, row[key]) for h, key in columns.items()) + " |")
    lines += ["", "Arguments of the runs:", ""]
    lines += [f"- {row['run']}: {' '.join(map(str, row['arguments']))}" for row in rows]
    text = "\n".join(lines) + "\n"
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return text


def write_plot(path, case, rows):
    """Error against processor time, a panel an error and a line a program."""
    rows = [row for row in rows if not row["is_reference"]]
    if not case.errors or not rows:
        return
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    series = sorted({row["series"] for row in rows})
    figure, axes = plt.subplots(1, len(case.errors), figsize=(4.6 * len(case.errors), 3.6),
                                squeeze=False)
    for axis, name in zip(axes[0], case.errors):
        for name_of_series in series:
            points = sorted((r[case.time], r[name]) for r in rows
                            if r["series"] == name_of_series and r[name] is not None)
            if points:
                axis.loglog(*zip(*points), "o-", label=name_of_series)
        axis.set_xlabel("processor time [s]")
        axis.set_ylabel(f"error of {name}")
        axis.grid(True, which="both", alpha=0.3)
        if axis.lines:
            axis.legend(fontsize=7)
    figure.suptitle(os.path.splitext(os.path.basename(path))[0])
    figure.tight_layout()
    figure.savefig(path, dpi=120)
    plt.close(figure)
