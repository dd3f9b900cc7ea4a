"""Time series as SVG with the page's own colours: grey lines, colour only where something is abnormal."""

from __future__ import annotations

import io
import re
from collections.abc import Mapping, Sequence
from html import escape
from itertools import pairwise
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.gridspec import GridSpec

from core.array import Array
from core.estimation.segments import Segment
from core.gap.limits import GAP
from core.payload.channels import CHANNELS, UNITS
from core.payload.inertia import Motion
from core.words.ticks import mark_ticks
from core.words.wording import Wording

POINTS = 2000  # of a line
LEFT_IN, RIGHT_IN, TOP_IN, BOTTOM_IN, BETWEEN_IN = 0.8, 0.1, 0.3, 0.45, 0.85
"""Room for numbers and names round the axes of a figure, and between its columns."""

# stand-ins that become variables of the style sheet, so that a picture follows the page's light and dark
COLOURS = {"ink": "#0a0a01", "muted": "#0a0a02", "rule": "#0a0a03", "band": "#0a0a04", "alarm": "#0a0a05"}
INK, MUTED, RULE, BAND, ALARM = COLOURS.values()
STYLE: dict[Any, Any] = {
    "svg.fonttype": "none", "font.size": 9, "axes.edgecolor": RULE, "axes.labelcolor": INK, "xtick.color": RULE,
    "ytick.color": RULE, "xtick.labelcolor": INK, "ytick.labelcolor": INK, "text.color": INK, "axes.linewidth": 0.8,
    "axes.spines.top": False, "axes.spines.right": False, "axes.titlesize": 9, "axes.titlelocation": "left",
    "lines.linewidth": 1.1, "lines.solid_joinstyle": "round", "path.simplify": True,
    "axes.formatter.useoffset": False, "axes.ymargin": 0.1, "axes.xmargin": 0.0,
}  # fmt: skip


def wrench_chart(t: Array, measured: Array, reconstructed: Array, noise_std: Array, rotating: Sequence[Segment], words: Wording) -> str:
    """Fig. 8-9 of the paper over the whole run: wrench measured (without offset) and reconstructed, residual in sigmas.

    Args:
        t: (N,), s. measured, reconstructed: (N, 6), N and N m. noise_std: (6,).
    """
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(10.4, 7.4))
        grid = _lay_out(figure, 6, 2, [3, 1.15] * 3)
        for k, (channel, unit) in enumerate(zip(CHANNELS, UNITS, strict=True)):
            row, column = 2 * (k % 3), k // 3
            upper = figure.add_subplot(grid[row, column])
            lower = figure.add_subplot(grid[row + 1, column], sharex=upper)
            _mark(upper, t, rotating, labels=row == 0)
            _line(upper, t, measured[:, k], MUTED, width=2.4, alpha=0.55)
            _line(upper, t, reconstructed[:, k], INK)
            upper.set_ylabel(f"{channel}, {unit}")
            upper.tick_params(labelbottom=False)
            _residual(lower, t, (measured[:, k] - reconstructed[:, k]) / noise_std[k], words)
            lower.set_xlabel("t, s" if row == 4 else "")
        return _svg(figure, "wrench", words.say("report-wrench"), words)


def rotation_chart(t: Array, motion: Motion, measured: Array, reconstructed: Array, rotating: Sequence[Segment], words: Wording) -> str:
    """Fig. 6-9 of the paper in the rotations: angular velocity and acceleration, and the torque about the same axis.

    Args:
        t: (N,), s. motion: sensor frame. measured, reconstructed: (N, 6). rotating: one stretch per column.
    """
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(10.4, 5.6))
        axes = _lay_out(figure, 3, len(rotating)).subplots(sharex="col", squeeze=False)
        for column, part in enumerate(rotating):
            axis = part.axis or "x"
            k = "xyz".index(axis)
            time = t[part.rows] - t[part.rows][0]
            others = [i for i in range(3) if i != k]
            for row, turning, name in ((0, motion.omega, "ω, rad/s"), (1, motion.alpha, "α, rad/s²")):
                for i in others:
                    _line(axes[row, column], time, turning[part.rows, i], MUTED, width=0.8, alpha=0.6)
                _line(axes[row, column], time, turning[part.rows, k], INK)
                axes[row, column].set_ylabel(name if column == 0 else "")
            axes[0, column].set_title(words.say("report-about-axis", axis=axis))
            _line(axes[2, column], time, measured[part.rows, 3 + k], MUTED, width=2.4, alpha=0.55)
            _line(axes[2, column], time, reconstructed[part.rows, 3 + k], INK)
            axes[2, column].set_ylabel(f"t{axis}, N m")
            axes[2, column].set_xlabel(words.say("report-rotation-time"))
        return _svg(figure, "rotation", words.say("report-rotations"), words)


def distance_chart(t: Array, distance_m: Array, limit_m: float, words: Wording) -> str:
    """Smallest distance to obstacles and protected zones against the limit; alarm colour below it.

    Args:
        t: (K,), s. distance_m: (K,), m.
    """
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(10.4, 2.5))
        axes = figure.add_subplot(_lay_out(figure, 1, 1)[0, 0])
        _line(axes, t, distance_m, INK)
        low = np.where(distance_m < limit_m, distance_m, np.nan)
        if np.isfinite(low).any():
            axes.plot(t, low, color=ALARM, linewidth=2.5)
        axes.axhline(limit_m, color=INK, linewidth=0.9, linestyle=(0, (4, 3)))
        axes.annotate(words.say("report-distance-limit", limit_m=limit_m), (1, limit_m), (-2, 3), xycoords=("axes fraction", "data"),
                      textcoords="offset points", ha="right", fontsize=8)  # fmt: skip
        k = int(np.nanargmin(distance_m))
        axes.plot(t[k], distance_m[k], "o", color=INK, markersize=4)
        top = max(1.15 * float(np.nanmax(distance_m)), 1.5 * limit_m)
        below = distance_m[k] - limit_m > 0.25 * top  # nothing else is drawn there: it is the smallest
        along = (t[k] - t[0]) / np.ptp(t)
        side, aside = ("left", 5) if along < 0.15 else ("right", -5) if along > 0.85 else ("center", 0)
        axes.annotate(
            words.mark(f"{distance_m[k]:.3f} m"),
            (t[k], distance_m[k] if below else max(float(distance_m[k]), limit_m)),
            (aside, -9 if below else 9),
            textcoords="offset points",
            ha=side,
            va="top" if below else "bottom",
            fontsize=8,
        )
        axes.set_ylim(0.0, top)
        axes.set_xlabel("t, s")
        axes.set_ylabel(words.say("report-distance-axis"))
        return _svg(figure, "distance", words.say("report-distance"), words)


def gap_chart(gaps: Mapping[str, tuple[float, float]], floor: float, words: Wording) -> str:
    """The gap of each channel before and after the effect was added, in standard deviations of the noise; alarm colour where it matters.

    Args:
        gaps: before and after of each channel, named.
        floor: noise alone.
    """
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(10.4, 0.5 + 0.46 * len(gaps)), layout="constrained")
        axes = figure.add_subplot()
        top = max(2.0 * floor, *(max(pair) for pair in gaps.values()))
        for row, (before, after) in enumerate(gaps.values()):
            for value, offset, height, colour in ((before, -0.19, 0.3, MUTED), (after, 0.19, 0.3, INK)):
                abnormal = value > GAP * floor and colour == INK
                axes.barh(row + offset, value, height, color=ALARM if abnormal else colour, alpha=0.55 if colour == MUTED else 1.0)
                axes.annotate(
                    words.mark(f"{value:.2f}"), (value, row + offset), (4, 0), textcoords="offset points", va="center", fontsize=8
                )
        axes.axvline(floor, color=INK, linewidth=0.9, linestyle=(0, (4, 3)))
        axes.annotate(words.say("report-gap-noise"), (floor, 1), (0, 3), xycoords=("data", "axes fraction"),
                      textcoords="offset points", ha="center", fontsize=8)  # fmt: skip
        axes.set_yticks(range(len(gaps)), list(gaps))
        axes.tick_params(axis="y", length=0)
        axes.set_ylim(len(gaps) - 0.45, -0.55)
        axes.set_xlim(0.0, 1.07 * top)
        axes.set_xlabel(words.say("report-gap-axis"))
        return _svg(figure, "gap", words.say("report-gap-by-channel"), words)


def overlay_chart(t: Array, measured: Array, before: Array, after: Array, noise_std: Array, channels: Sequence[int], words: Wording) -> str:
    """Measured wrench over one motion with the simulation before and after the effect was added; below, what each leaves in sigmas.

    Args:
        t: (K,), s. measured, before, after: (K, 6), N and N m. noise_std: (6,), of one row.
        channels: columns to draw.
    """
    changed = not np.allclose(before, after, rtol=1e-9, atol=1e-12)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(10.4, 4.6), layout="constrained")
        grid = figure.add_gridspec(2, len(channels), height_ratios=[3, 1.4])
        for column, k in enumerate(channels):
            upper = figure.add_subplot(grid[0, column])
            lower = figure.add_subplot(grid[1, column], sharex=upper)
            _line(upper, t, measured[:, k], MUTED, width=5.0, alpha=0.45)
            lower.axhspan(-3, 3, color=BAND, linewidth=0)
            _draw_simulation(upper, lower, t, before[:, k], (measured[:, k] - before[:, k]) / noise_std[k], dashed=changed)
            if changed:
                _draw_simulation(upper, lower, t, after[:, k], (measured[:, k] - after[:, k]) / noise_std[k], dashed=False)
            upper.set_ylabel(f"{CHANNELS[k]}, {UNITS[k]}")
            upper.tick_params(labelbottom=False)
            lower.margins(y=0.15)
            lower.set_ylabel(words.say("report-gap-rest-axis") if column == 0 else "")
            lower.set_xlabel("t, s")
        return _svg(figure, "overlay", words.say("report-gap-overlay"), words)


def _lay_out(figure: Figure, rows: int, columns: int, heights: Sequence[float] | None = None) -> GridSpec:
    """A grid of axes with room that is known beforehand: to measure every label first takes as long as to draw."""
    width, height = figure.get_size_inches()
    each = (width - LEFT_IN - RIGHT_IN - (columns - 1) * BETWEEN_IN) / columns
    return figure.add_gridspec(
        rows,
        columns,
        left=LEFT_IN / width,
        right=1.0 - RIGHT_IN / width,
        top=1.0 - TOP_IN / height,
        bottom=BOTTOM_IN / height,
        wspace=BETWEEN_IN / each,
        hspace=0.24,
        height_ratios=heights,
    )


def _draw_simulation(upper: Axes, lower: Axes, t: Array, values: Array, sigmas: Array, *, dashed: bool) -> None:
    """A simulated line with what it leaves below; in alarm colour where that is more than noise can be."""
    colour = ALARM if float(np.sqrt(np.mean(sigmas**2))) > GAP else INK
    for axes, line in ((upper, values), (lower, sigmas)):
        x, y = decimate(t, line)
        axes.plot(x, y, color=colour, linewidth=1.1, linestyle=(0, (5, 2)) if dashed else "-")


def decimate(t: Array, values: Array) -> tuple[Array, Array]:
    """At most `POINTS` points of a line that keep its extremes: the least and the greatest value of each stretch."""
    if len(t) <= POINTS:
        return t, values
    edges = np.linspace(0, len(t), POINTS // 2 + 1).astype(int)
    rows = np.concatenate([sorted({a + int(np.argmin(values[a:b])), a + int(np.argmax(values[a:b]))}) for a, b in pairwise(edges)])
    return t[rows], values[rows]


def _line(axes: Axes, t: Array, values: Array, colour: str, *, width: float = 1.1, alpha: float = 1.0) -> None:
    x, y = decimate(t, values)
    few = len(t) < 100  # single poses: the line between them means nothing
    axes.plot(
        x,
        y,
        color=colour,
        linewidth=width,
        alpha=alpha,
        marker="o" if few else None,
        markersize=2 * width,
        linestyle="" if few else "-",
    )


def _residual(axes: Axes, t: Array, sigmas: Array, words: Wording) -> None:
    """Residual in standard deviations of the noise with the band where it belongs; in alarm colour far outside."""
    axes.axhspan(-3, 3, color=BAND, linewidth=0)
    _line(axes, t, sigmas, INK, width=0.6)
    far = np.abs(sigmas) > 6
    if far.any():
        x, y = t[far], sigmas[far]
        step = max(1, len(x) // 500)
        axes.plot(x[::step], y[::step], ".", color=ALARM, markersize=2)
    reach = max(4.0, 1.1 * float(np.max(np.abs(sigmas))))
    axes.set_ylim(-reach, reach)
    axes.set_ylabel(words.say("report-residual-sigma"), fontsize=8)


def _mark(axes: Axes, t: Array, rotating: Sequence[Segment], *, labels: bool) -> None:
    """The rotations as bands behind the lines."""
    for part in rotating:
        a, b = t[part.rows][0], t[part.rows][-1]
        axes.axvspan(a, b, color=BAND, linewidth=0)
        if labels:
            axes.annotate(part.axis or "", ((a + b) / 2, 1), (0, 2), xycoords=("data", "axes fraction"),
                          textcoords="offset points", ha="center", fontsize=8)  # fmt: skip


def _svg(figure: Figure, name: str, label: str, words: Wording) -> str:
    """The figure as an SVG element of an HTML page.

    Args:
        name: keeps its identifiers apart from those of other figures.
        label: what it shows, for those who cannot see it.
    """
    mark_ticks(figure, words)
    FigureCanvasSVG(figure)
    stream = io.StringIO()
    with mpl.rc_context({"svg.hashsalt": name}):
        figure.savefig(
            stream,
            format="svg",
            transparent=True,
            metadata={"Date": None, "Creator": None, "Format": None, "Type": None},
        )
    text = stream.getvalue()
    text = text[text.index("<svg") :]
    text = re.sub(
        r'<svg[^>]*viewBox="([^"]*)"[^>]*>',
        rf'<svg class="chart" viewBox="\1" role="img" aria-label="{escape(label)}">',
        text,
        count=1,
    )
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = re.sub(r'( d| x| y|transform)="[^"]*"', lambda found: re.sub(r"(\.\d\d)\d+", r"\1", found[0]), text)
    text = re.sub(r' id="(figure|patch|axes|line2d|text|matplotlib\.axis|xtick|ytick|FillBetween\w*)_?\d+"', "", text)
    text = re.sub(r"font: ([\d.]+px) [^;\"]*", r"font-size: \1", text)
    for variable, stand_in in COLOURS.items():
        text = text.replace(stand_in, f"var(--{variable})")
    return text
