"""The numbers along the axes of a picture, in its language."""

from __future__ import annotations

from matplotlib.figure import Figure
from matplotlib.ticker import ScalarFormatter

from core.words.wording import Wording


class _Ticks(ScalarFormatter):
    """As Matplotlib writes them, with the decimal mark of a language."""

    def __init__(self, words: Wording) -> None:
        super().__init__()
        self.words = words

    def __call__(self, x: float, pos: int | None = None) -> str:
        return self.words.mark(super().__call__(x, pos))


def mark_ticks(figure: Figure, words: Wording) -> None:
    """Every axis with plain numbers has them in a language; the last that is done to a figure before it is saved."""
    for axis in [axis for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)]:
        if type(axis.get_major_formatter()) is ScalarFormatter:
            axis.set_major_formatter(_Ticks(words))
