# SPDX-License-Identifier: LGPL-2.1-or-later
"""The water of a run at a few equally spaced times, on one page."""

import matplotlib.pyplot as plt
import numpy

from seiche_stage import make_stage

NUMBER = {2: 6, 3: 4}  # of times on a page, by the dimension
FEWEST = 4  # rather than leaving out the end of the run
HOLE = 0.1  # an empty place on the page is as bad as missing this share of the run
WIDTH, HEIGHT = 9.0, 7.5  # of a page at most [inches]
BAR, TITLE = 1.3, 0.55  # width of the colour bar, height of a panel's title [inches]
DPI = 150


def equally_spaced(frames, number):
    """At most `number` frames [(time, file)] with equal steps of time between them,
    from the first on and as near to the last as that allows, rather four or six than
    five, which leave a hole on the page."""
    if len(frames) <= 2:
        return list(frames)
    first, last_but_one, end = frames[0][0], frames[-2][0], frames[-1][0]
    # frames come with the first step after their time, the last one with the end
    interval = (last_but_one - first) / (len(frames) - 2)
    last = int((end - first) / interval + 0.5)
    best = None
    for n in range(min(number, last + 1), min(FEWEST, last + 1, number) - 1, -1):
        step = max(1, last // max(1, n - 1))
        chosen = nearest(frames, first + interval * step * numpy.arange(n))
        cost = (last - (n - 1) * step) / last + HOLE * (n == 5)
        if best is None or cost < best[0]:
            best = cost, chosen
    return best[1]


def nearest(frames, times):
    """The frames nearest to times [s]."""
    return [min(frames, key=lambda frame: abs(frame[0] - time)) for time in times]


def far_off(frames, times):
    """A text for each time [s] without a frame within half an interval of frames."""
    interval = numpy.median(numpy.diff([time for time, _ in frames])) if len(frames) > 1 else 0.0
    return ["no frame near t = %g s: the nearest one, of %g s, is drawn" % (time, frame[0])
            for time, frame in zip(times, nearest(frames, times))
            if abs(frame[0] - time) > 0.5001 * interval]


def arrangement(number, ratio):
    """Columns of panels, height over width, that make these the widest on a page that
    they fill, and that width [inches]."""
    def width(across):
        rows = -(-number // across)
        return min((WIDTH - BAR) / across, (HEIGHT / rows - TITLE) / ratio)

    def filled(across):
        return number / (across * -(-number // across))

    across = max(range(1, number + 1), key=lambda n: width(n) * filled(n))
    return across, width(across)


def page(stage, number):
    """Figure and axes for so many panels."""
    across, width = arrangement(number, stage.ratio)
    rows = -(-number // across)
    figure, axes = plt.subplots(
        rows, across, figsize=(across * width + BAR, rows * (width * stage.ratio + TITLE) + 0.2),
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
    stage.width = int(DPI * arrangement(len(chosen), stage.ratio)[1])
    figure, all_axes = page(stage, len(chosen))
    for axes, (time, file) in zip(all_axes.flat, chosen):
        stage.draw(axes, stage.load(time, file))
        axes.label_outer()
        if scene and hasattr(scene, "overlay_snapshot"):
            scene.overlay_snapshot(axes, time)
    stage.draw_key(figure, all_axes)
    figure.savefig(path, dpi=DPI, bbox_inches="tight")
    plt.close(figure)
    return True
