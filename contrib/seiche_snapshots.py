# SPDX-License-Identifier: LGPL-2.1-or-later
"""The water of a run at a few equally spaced times, on one page."""

import matplotlib.pyplot as plt
import numpy

from seiche_stage import make_stage

NUMBER = {2: 6, 3: 4}  # of times on a page, by the dimension
FEWEST = 4  # rather than leaving out the end of the run
WIDTH = 12.0  # [inches]
PIXELS = 1300


def equally_spaced(frames, number):
    """At most `number` frames [(time, file)] with equal steps of time between them,
    from the first on and as near to the last as that allows."""
    if len(frames) <= 2:
        return list(frames)
    times = numpy.array([time for time, _ in frames])
    interval = float(numpy.median(numpy.diff(times)))
    index = numpy.rint((times - times[0]) / interval).astype(int)
    by_index = {}
    for i, frame, time in zip(index, frames, times):
        if abs(time - times[0] - i * interval) < 0.3 * interval:
            by_index.setdefault(i, frame)
    last = max(by_index)
    best = None
    for n in range(min(number, last + 1), min(FEWEST, last + 1, number) - 1, -1):
        step = max(1, last // max(1, n - 1))
        chosen = [by_index[i] for i in range(0, (n - 1) * step + 1, step) if i in by_index]
        missed = last - (n - 1) * step
        if best is None or missed < best[0]:
            best = missed, chosen
    return best[1]


def nearest(frames, times):
    """The frames nearest to times [s]."""
    return [min(frames, key=lambda frame: abs(frame[0] - time)) for time in times]


def columns_for(number, ratio):
    """Panels beside each other, so that they can be read."""
    if number == 1 or ratio < 0.12:
        return 1
    return 3 if ratio > 0.7 and number > 4 else 2


def page(stage, number):
    """Figure and axes for so many panels."""
    across = columns_for(number, stage.ratio)
    rows = -(-number // across)
    width = (WIDTH - 1.3) / across
    figure, axes = plt.subplots(
        rows, across, figsize=(WIDTH, rows * (width * stage.ratio + 0.55) + 0.2),
        squeeze=False, layout="compressed")
    for unused in axes.flat[number:]:
        unused.set_visible(False)
    return figure, axes


def snapshots(run, path, name="pressure", times=(), scene=None, **options):
    """Picture at the given times [s], or at equally spaced ones; False without
    frames."""
    frames = run.frames("points")
    if not frames:
        return False
    chosen = nearest(frames, times) if len(times) else equally_spaced(frames, NUMBER[run.dim])
    stage = make_stage(run, frames, name, **options)
    stage.width = PIXELS // columns_for(len(chosen), stage.ratio)
    figure, all_axes = page(stage, len(chosen))
    for axes, (time, file) in zip(all_axes.flat, chosen):
        stage.draw(axes, stage.load(time, file))
        axes.label_outer()
        if scene and hasattr(scene, "overlay_snapshot"):
            scene.overlay_snapshot(axes, time)
    stage.colour_bar(figure, all_axes)
    figure.savefig(path, dpi=130, bbox_inches="tight")
    plt.close(figure)
    return True
