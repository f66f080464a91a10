# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 2 to 5 of the founding paper: the rotating patch."""

import matplotlib.pyplot as plt
import numpy

from seiche_paper import (
    COLOUR, OURS, RECIPE, colour_bar, draw_points, label_edges, reference, save)
from seiche_paper_numbers import smoothed
from seiche_output import field

STUDY = "rotating_patch"
SMOOTHING = 0.05  # [s] the paper does not say how it smooths
LAST = 1.7  # omega t to which the reference of p(0, 0) is compared
ROWS = ((RECIPE, "paper, mixed 36"), (OURS, "mixed 36"))
UNIT = "p [Pa]"  # also in rho omega^2 L^2, all of them one


def outline(axes, time):
    """The reference surface where there is one: one side, turned; else the
    corners, whose paths are straight."""
    if time in (0.5, 1.0, 1.5):
        x, y = reference("benchmarks", STUDY, "reference", "surface_wt%g.csv" % time)
        for i in range(4):
            axes.plot(x, y, "k-", lw=0.9, label=None if i else "reference surface")
            x, y = -y, x
    else:
        corner = numpy.array([0.5 + 0.5 * time, 0.5 - 0.5 * time])
        turned = numpy.array([corner, [-corner[1], corner[0]], -corner, [corner[1], -corner[0]]])
        axes.plot(*turned.T, "k+", ms=9, mew=1.2, label="reference corners")


def evolution(patch, output, numbers):
    """Figure 2: pressure at omega t = 0.5, 1, 2, 4."""
    times = (0.5, 1.0, 2.0, 4.0)
    figure, all_axes = plt.subplots(2, 4, figsize=(13, 7.4), sharex="col", sharey="col",
                                    layout="constrained")
    for column, time in zip(all_axes.T, times):
        frames = [patch[name].frame_at(time) for _, name in ROWS]
        # of the less noisy field: outliers must not take the scale
        lowest = max([numpy.percentile(field(f, "pressure"), 1) for f in frames if f] or [-0.001])
        half = 1.07 * max(0.5 + 0.5 * time, abs(0.5 - 0.5 * time))
        for axes, frame, (method, name) in zip(column, frames, ROWS):
            draw_points(axes, frame, "pressure", (lowest, 0), "viridis", patch[name].ending())
            outline(axes, time)
            axes.set(xlim=(-half, half), ylim=(-half, half),
                     title=r"%s, $\omega t$ = %g" % (method, time))
            axes.locator_params(nbins=5)
        free = "lower left" if time < 1.5 else "lower right"  # no arm there
        column[0].legend(loc=free, frameon=False, fontsize=7)
        colour_bar(figure, column, (lowest, 0), "viridis", UNIT, location="bottom", shrink=0.9,
                   aspect=30, extend="both").ax.locator_params(nbins=5)
    label_edges(all_axes, "x [m]", "y [m]")
    save(figure, output, "figure_02_patch_evolution")


def formulations(patch, output, numbers):
    """Figure 3: pressure of three formulations at omega t = 0.3."""
    figure, all_axes = plt.subplots(2, 3, figsize=(11.5, 7.6), sharex=True, sharey=True,
                                    layout="constrained")
    shown = (("irreducible 36", r"irreducible, $\kappa = 10^5$ Pa"),
             ("unstabilized 36", "mixed without subscales"),
             ("mixed 36", "mixed with subscales"))
    for row, (method, prefix) in zip(all_axes, ((RECIPE, "paper, "), (OURS, ""))):
        for axes, (name, title) in zip(row, shown):
            variant = patch[prefix + name]
            reached, frame = variant.frame_up_to(0.3)
            draw_points(axes, frame, "pressure", (-0.2, 0.2), "coolwarm", variant.ending())
            if frame is not None and reached < 0.28:
                note = r"last frame, at $\omega t$ = %.3g;" % reached + "\nrun " + variant.ending()
                axes.text(0.03, 0.03, note, transform=axes.transAxes, fontsize=7, color="0.4")
            axes.set_title("%s: %s" % (method, title))
            axes.set(xlim=(-0.75, 0.75), ylim=(-0.75, 0.75))
    label_edges(all_axes, "x [m]", "y [m]")
    colour_bar(figure, all_axes, (-0.2, 0.2), "coolwarm", UNIT, shrink=0.7, extend="both")
    figure.suptitle(r"Pressure at $\omega t$ = 0.3")
    save(figure, output, "figure_03_patch_formulations")


def rays(axes, frame, exact, method, numbers):
    """Pressure of the points nearest to the places of the reference."""
    p, errors, edge = field(frame, "pressure"), [], []
    for i, angle in enumerate(numpy.unique(exact[0])):
        r, value = exact[1:3, exact[0] == angle]
        places = r * numpy.exp(1j * numpy.radians(angle))
        points = frame["points"][:, 0] + 1j * frame["points"][:, 1]
        nearest = p[numpy.argmin(abs(points - places[:, None]), axis=1)]
        errors += list(nearest - value)
        edge.append(abs(nearest[numpy.argmax(r)]))
        axes.plot(r, nearest, "o", ms=3.5, color="C%d" % i, label="points, %g degrees" % angle)
    numbers.add("Figure 4: rotating patch, p on four rays at omega t = 1", method, **{
        "rms of p - reference [Pa]": numpy.sqrt(numpy.mean(numpy.square(errors))),
        "largest error": numpy.max(numpy.abs(errors)), "farthest from 0 at the surface": max(edge)})


def boundary(patch, output, numbers):
    """Figure 4: pressure at omega t = 1, and along the rays of the reference."""
    exact = reference("paper", "reference", "patch_pressure_wt1.csv")
    figure, all_axes = plt.subplots(2, 2, figsize=(10, 9), layout="constrained")
    for (left, right), (method, name) in zip(all_axes, ROWS):
        frame = patch[name].frame_at(1.0)
        draw_points(left, frame, "pressure", (-0.11, 0), "rainbow", patch[name].ending())
        outline(left, 1.0)
        left.set(xlim=(-1.1, 1.1), ylim=(-1.1, 1.1), xlabel="x [m]", ylabel="y [m]",
                 title=r"%s, $\omega t$ = 1" % method)
        left.legend(loc="upper right", frameon=False)
        for angle in numpy.unique(exact[0]):
            r, value = exact[1:3, exact[0] == angle]
            right.plot(r, value, "k-", lw=0.9, label=None if angle else "reference")
            end = r.max() * numpy.exp(1j * numpy.radians(angle))
            left.plot([0, end.real], [0, end.imag], "w:", lw=1)
        if frame is not None:
            rays(right, frame, exact, method, numbers)
        right.set(xlabel="distance from the centre [m]", ylabel=UNIT, ylim=(-0.14, 0.06),
                  title="%s: pressure along the dotted rays" % method)
        right.grid(alpha=0.3)
        right.legend(loc="upper left", ncol=2)
    colour_bar(figure, all_axes[:, 0], (-0.11, 0), "rainbow", UNIT, location="bottom", shrink=0.8,
               aspect=30, extend="both")
    save(figure, output, "figure_04_patch_boundary")


def centre_curve(axes, patch, name, label, colour, numbers):
    time, p = patch[name].series("probe centre pressure [Pa]")
    if len(time) == 0:
        axes.plot([], [], color=colour, label="%s (no run)" % label)
        return
    mean = smoothed(time, p, SMOOTHING)
    axes.plot(time, p, lw=0.5, alpha=0.35, color=colour)
    axes.plot(time, mean, lw=1.3, color=colour, label=label)
    exact = reference("benchmarks", STUDY, "reference", "centre_pressure.csv")
    inside = time <= LAST
    error = [v[inside] - numpy.interp(time[inside], exact[0], exact[1]) for v in (p, mean)]
    rms = [numpy.sqrt(numpy.mean(e**2)) for e in error]
    numbers.add("Figure 5: rotating patch, rms of p(0, 0) against the reference to omega t = %g"
                % LAST, name, **{"raw [Pa]": rms[0], "smoothed [Pa]": rms[1],
                                 "compared to": time[inside][-1]})


def centre(patch, output, numbers):
    """Figure 5: pressure at the centre, raw and smoothed."""
    figure, panels = plt.subplot_mosaic(
        [["both", "both"], ["recipe", "ours"], ["forms r", "forms o"]], figsize=(12, 11),
        sharex=True, layout="constrained")
    points = (("mixed 9", "9 points a cell"), ("mixed 16", "16"), ("mixed 36", "36"))
    forms = (("mixed 36", "mixed with subscales"), ("unstabilized 36", "mixed without subscales"),
             ("irreducible 36", r"irreducible, $\kappa = 10^5$ Pa"))
    extra = (("unstabilized 36, ghost p", "without subscales, ghost penalty on p"),
             ("irreducible 36, kappa 1e3", r"irreducible, $\kappa = 10^3$ Pa"))
    groups = (
        ("both", "mixed form, 36 points a cell",
         [(name, method, COLOUR[method]) for method, name in ROWS]),
        ("recipe", "%s: points a cell" % RECIPE,
         [("paper, " + name, label, None) for name, label in points]
         + [("paper, mixed 16, dt 0.001", "16, dt 0.001 s", None)]),
        ("ours", "%s: points a cell" % OURS,
         [(name, label, None) for name, label in points]
         + [("mixed 16, dt 0.001", "16, dt 0.001 s", None)]),
        ("forms r", "%s: formulations" % RECIPE,
         [("paper, " + name, label, None) for name, label in forms]),
        ("forms o", "%s: formulations" % OURS,
         [(name, label, None) for name, label in forms + extra]),
    )
    exact = reference("benchmarks", STUDY, "reference", "centre_pressure.csv")
    for key, title, curves in groups:
        axes = panels[key]
        for i, (name, label, colour) in enumerate(curves):
            centre_curve(axes, patch, name, label, colour or "C%d" % i, numbers)
        axes.plot(exact[0], exact[1], "k--", lw=1.2, label="reference", zorder=5)
        axes.set(xlim=(0, 4), ylim=(-0.26, 0.08), ylabel="p(0, 0) [Pa]", title=title)
        axes.grid(alpha=0.3)
        axes.legend(loc="lower right", ncol=1 if len(curves) < 4 else 2)
    for key in ("forms r", "forms o"):
        panels[key].set_xlabel(r"$\omega t$")
    panels["both"].tick_params(labelbottom=True)
    figure.suptitle("Pressure at the centre (thin: raw, thick: mean over %g s)" % SMOOTHING)
    save(figure, output, "figure_05_patch_centre")


FIGURES = (evolution, formulations, boundary, centre)
