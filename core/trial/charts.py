"""The pictures of a score sheet: SVG files on white, repeatable to the byte."""

from __future__ import annotations

import io
from collections import Counter
from collections.abc import Sequence
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

from core.trial.figures import Bin
from core.words.ticks import mark_ticks
from core.words.wording import Wording

INK, MUTED, RULE = "#1a1d21", "#8a9099", "#c9ced6"
SHADES = mpl.colormaps["Blues"]
STYLE: dict[Any, Any] = {
    "svg.fonttype": "none", "svg.hashsalt": "heft", "font.size": 9, "font.family": "sans-serif", "axes.edgecolor": RULE,
    "axes.labelcolor": INK, "xtick.color": RULE, "ytick.color": RULE, "xtick.labelcolor": INK, "ytick.labelcolor": INK, "text.color": INK,
    "axes.spines.top": False, "axes.spines.right": False, "figure.constrained_layout.use": True, "axes.linewidth": 0.8,
}  # fmt: skip


def confusion_chart(pairs: Counter[tuple[str, str]], words: Wording) -> str:
    """Planted (rows) against answered (columns); the right answer on the diagonal, shade by share of the row."""
    planted = sorted({row for row, _ in pairs})
    answered = [*planted, *sorted({column for _, column in pairs} - set(planted))]
    counts = np.array([[pairs[row, column] for column in answered] for row in planted])
    share = counts / counts.sum(axis=1, keepdims=True)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(2.6 + 0.3 * len(answered), 1.9 + 0.24 * len(planted)))
        axes = figure.add_subplot()
        axes.pcolormesh(share, cmap=SHADES, vmin=0.0, vmax=1.2, edgecolors="white", linewidth=1.0)
        for i, j in np.argwhere(counts):
            axes.text(
                j + 0.5, i + 0.5, str(counts[i, j]), ha="center", va="center", fontsize=8, color="white" if share[i, j] > 0.6 else INK
            )
        for i in range(len(planted)):
            axes.plot([i, i + 1, i + 1, i, i], [i, i, i + 1, i + 1, i], color=INK, linewidth=0.7)
        axes.set_xticks(np.arange(len(answered)) + 0.5, answered, rotation=90)
        axes.set_yticks(np.arange(len(planted)) + 0.5, planted)
        axes.tick_params(length=0)
        axes.set_xlim(-0.05, len(answered))
        axes.set_ylim(len(planted) + 0.05, -0.05)
        axes.set_xlabel(words.say("sheet-answered"))
        axes.set_ylabel(words.say("sheet-planted"))
        return _svg(figure, words)


def reliability_chart(first: Sequence[Bin], every: Sequence[Bin], words: Wording) -> str:
    """How often an answer was right against its probability, with 95 % intervals: the first answers, and all of them."""
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(7.4, 3.7))
        titles = words.say("sheet-most-probable-class"), words.say("sheet-every-class")
        for axes, table, title in zip(figure.subplots(1, 2), (first, every), titles, strict=True):
            axes.plot([0, 1], [0, 1], color=RULE, linewidth=1.0)
            for row in table:
                axes.plot([row.mean, row.mean], row.share.interval, color=MUTED, linewidth=1.2)
                axes.plot(row.mean, row.share.value, "o", color=INK, markersize=5)
                axes.annotate(
                    str(row.share.of), (row.mean, row.share.value), (6, -9), textcoords="offset points", fontsize=7.5, color=MUTED
                )
            axes.set_title(title, fontsize=9, loc="left")
            _unit_square(axes)
            axes.set_xlabel(words.say("sheet-probability-given"))
            axes.set_ylabel(words.say("sheet-share-right"))
        return _svg(figure, words)


def closure_chart(pairs: Sequence[tuple[float, float]], words: Wording) -> str:
    """Closure of the first name against that of the true effect."""
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(3.9, 3.7))
        axes = figure.add_subplot()
        axes.plot([0, 1], [0, 1], color=RULE, linewidth=1.0)
        axes.plot([x for x, _ in pairs], [y for _, y in pairs], "o", color=INK, markersize=4, alpha=0.5, markeredgewidth=0)
        _unit_square(axes)
        axes.set_xlabel(words.say("sheet-closure-of-truth"))
        axes.set_ylabel(words.say("sheet-closure-of-first"))
        return _svg(figure, words)


def detection_chart(trials: dict[str, list[tuple[float, bool]]], words: Wording) -> str:
    """Each trial of one fault by its distance from nothing, named or not, one line per effect.

    Args:
        trials: distance in standard deviations, and whether the fault was named, by effect.
    """
    names = sorted(trials)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(7.4, 1.0 + 0.23 * max(len(names), 1)))
        axes = figure.add_subplot()
        for row, name in enumerate(names):
            for sigma, hit in trials[name]:
                axes.plot(max(sigma, 0.1), row, "o", color=INK if hit else "none", markeredgecolor=INK if hit else MUTED, markersize=5)
        axes.axvline(3.0, color=INK, linewidth=0.8, linestyle=(0, (4, 3)))
        axes.set_xscale("log")
        axes.set_yticks(range(len(names)), names)
        axes.set_ylim(len(names) - 0.4, -0.6)
        axes.grid(axis="y", color=RULE, linewidth=0.4)
        axes.tick_params(axis="y", length=0)
        axes.set_xlabel(words.say("sheet-distance-from-nothing"))
        return _svg(figure, words)


def _unit_square(axes: Axes) -> None:
    axes.set_xlim(-0.02, 1.04)
    axes.set_ylim(-0.02, 1.04)
    axes.set_aspect("equal")


def _svg(figure: Figure, words: Wording) -> str:
    mark_ticks(figure, words)
    FigureCanvasSVG(figure)
    stream = io.StringIO()
    figure.savefig(stream, format="svg", facecolor="white", metadata={"Date": None, "Creator": None})
    return stream.getvalue()
