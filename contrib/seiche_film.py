# SPDX-License-Identifier: LGPL-2.1-or-later
"""A film of a run: mp4 where there is ffmpeg, otherwise an animated gif (Pillow)."""

import os

import matplotlib.pyplot as plt
from matplotlib import animation

from seiche_stage import make_stage

SECONDS = 10.0  # that a film takes if its frames allow it
RATES = (4, 25)  # [frames/s] least and most
WIDTH, HEIGHT = 10.0, 6.5  # at most [inches]
DPI = 128  # 1280 pixels wide


def default_name(folder):
    kind = "mp4" if animation.writers.is_available("ffmpeg") else "gif"
    return os.path.join(folder, "film." + kind)


def make_writer(path, rate):
    kind = os.path.splitext(path)[1].lower()
    if kind == ".gif":
        return animation.PillowWriter(fps=rate)
    if kind != ".mp4":
        raise ValueError("a film is a .mp4 or a .gif, not " + path)
    if not animation.writers.is_available("ffmpeg"):
        raise ValueError("a .mp4 needs ffmpeg (Debian: ffmpeg); without it name a .gif")
    # colours that all players know
    return animation.FFMpegWriter(fps=rate, codec="libx264",
                                  extra_args=["-pix_fmt", "yuv420p", "-crf", "20"])


def figure_for(stage):
    """Figure and axes of the shape of the stage, with room for titles and the bar."""
    width = min(WIDTH, 1.9 + (HEIGHT - 1.0) / stage.ratio)
    height = min(HEIGHT, 1.0 + (width - 1.9) * stage.ratio)
    even = [2 * round(0.5 * DPI * length) / DPI for length in (width, height)]  # for mp4
    return plt.subplots(figsize=even, dpi=DPI, layout="compressed")


def film(run, path, name, progress=None, **options):
    """All frames, one after the other, into path; False without frames."""
    frames = run.frames("points")
    if not frames:
        return False
    rate = int(round(min(max(len(frames) / SECONDS, RATES[0]), RATES[1])))
    writer = make_writer(path, rate)
    stage = make_stage(run, frames, name, **options)
    figure, axes = figure_for(stage)
    stage.draw(axes, stage.load(*frames[0]))
    stage.draw_key(figure, axes)
    figure.canvas.draw()
    figure.set_layout_engine("none")  # nothing may move from here on
    place = axes.get_position()
    base, kind = os.path.splitext(path)
    unfinished = base + ".unfinished" + kind
    try:
        with writer.saving(figure, unfinished, DPI):
            for number, frame in enumerate(frames):
                axes.clear()
                stage.draw(axes, stage.load(*frame))
                axes.set_position(place)
                writer.grab_frame()
                if progress:
                    progress(number + 1, len(frames))
        os.replace(unfinished, path)
    finally:
        if os.path.exists(unfinished):
            os.remove(unfinished)
        plt.close(figure)
    return True
