"""A sheet of A4 that is written from top to bottom, in millimetres, as PDF with text that can be selected.

What is written is kept and drawn at the end, so that a sheet that came out too long can be written again in smaller letters.
"""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import Literal

import matplotlib as mpl
from matplotlib.backends.backend_pdf import FigureCanvasPdf
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties, get_font
from matplotlib.ft2font import FT2Font, LoadFlags
from matplotlib.lines import Line2D

WIDTH_MM, HEIGHT_MM = 210.0, 297.0
MARGIN_MM = 18.0
POINT_MM = 25.4 / 72.0
LEADING = 1.32
"""From line to line, in heights of the letters."""
MEASURED_AT = 100.0
"""pt; widths are proportional."""
FONTS = {"plain": "DejaVuSans.ttf", "bold": "DejaVuSans-Bold.ttf", "digits": "DejaVuSansMono.ttf"}
Face = Literal["plain", "bold", "digits"]
Side = Literal["left", "right"]


@dataclass(frozen=True)
class Text:
    """A line of text; `y_mm` from the top edge to its baseline."""

    x_mm: float
    y_mm: float
    text: str
    size_pt: float
    face: Face
    grey: float


@dataclass(frozen=True)
class HorizontalLine:
    """A horizontal line; `y_mm` from the top edge."""

    x_mm: float
    y_mm: float
    length_mm: float
    grey: float


@dataclass(frozen=True)
class Column:
    """Of a table: where its text begins or, on the right, ends."""

    width_mm: float
    side: Side = "left"
    face: Face = "plain"


@dataclass
class Sheet:
    """What stands on the page.

    Args:
        scale: of all letters.
        y_mm: how far down it is written, from the top edge.
    """

    scale: float = 1.0
    y_mm: float = MARGIN_MM
    marks: list[Text | HorizontalLine] = field(default_factory=list)

    @property
    def width_mm(self) -> float:
        """Between the margins."""
        return WIDTH_MM - 2.0 * MARGIN_MM

    def skip(self, height_mm: float) -> None:
        """Leaves room."""
        self.y_mm += self.scale * height_mm

    def rule(self, *, x_mm: float = 0.0, length_mm: float | None = None, grey: float = 0.6) -> None:
        """A line across, or from `x_mm` beside the margin on."""
        self.marks.append(HorizontalLine(MARGIN_MM + x_mm, self.y_mm, self.width_mm - x_mm if length_mm is None else length_mm, grey))

    def write(
        self, text: str, size_pt: float = 8.0, *, x_mm: float = 0.0, width_mm: float | None = None, face: Face = "plain", grey: float = 0.0
    ) -> None:
        """A paragraph, broken into lines; the sheet goes on below it."""
        size = self.scale * size_pt
        for line in break_lines(text, size, face, self.width_mm - x_mm if width_mm is None else width_mm):
            self.y_mm += LEADING * size * POINT_MM
            self.marks.append(Text(MARGIN_MM + x_mm, self.y_mm, line, size, face, grey))

    def row(self, columns: Sequence[Column], cells: Sequence[str], size_pt: float = 8.0, *, grey: float = 0.0) -> None:
        """Cells beside each other, each broken into lines within its column; the sheet goes on below the longest."""
        size, top, bottom, x_mm = self.scale * size_pt, self.y_mm, self.y_mm, MARGIN_MM
        for column, cell in zip(columns, cells, strict=True):
            self.y_mm = top
            for line in break_lines(cell, size, column.face, column.width_mm):
                self.y_mm += LEADING * size * POINT_MM
                indent = column.width_mm - measure_mm(line, size, column.face) if column.side == "right" else 0.0
                self.marks.append(Text(x_mm + indent, self.y_mm, line, size, column.face, grey))
            bottom, x_mm = max(bottom, self.y_mm), x_mm + column.width_mm
        self.y_mm = bottom

    def render(self, *, title: str, subject: str) -> bytes:
        """The PDF; without the time of its making, so that the same sheet gives the same bytes."""
        figure = Figure(figsize=(WIDTH_MM / 25.4, HEIGHT_MM / 25.4))
        FigureCanvasPdf(figure)
        for mark in self.marks:
            x, y = mark.x_mm / WIDTH_MM, 1.0 - mark.y_mm / HEIGHT_MM
            if isinstance(mark, Text):
                font = FontProperties(fname=find_font_file(mark.face), size=mark.size_pt)
                figure.text(x, y, mark.text, fontproperties=font, color=str(mark.grey), va="baseline", parse_math=False)
            else:
                ends = [x, x + mark.length_mm / WIDTH_MM]
                figure.add_artist(Line2D(ends, [y, y], linewidth=0.5, color=str(mark.grey), transform=figure.transFigure))
        file = io.BytesIO()
        with mpl.rc_context({"pdf.fonttype": 42, "pdf.compression": 6}):  # TrueType, whose text is found and copied
            figure.savefig(file, format="pdf", metadata={"Title": title, "Subject": subject, "Creator": "Heft", "CreationDate": None})
        return file.getvalue()


def break_lines(text: str, size_pt: float, face: Face, width_mm: float) -> list[str]:
    """Lines no wider than that, kept together at no-break spaces; a word that is wider is broken anywhere. One empty line without text."""
    lines = [""]
    for word in re.split(r"[ \t\r\n]+", spell_out(text, face).strip()):
        longer = f"{lines[-1]} {word}".lstrip()
        if measure_mm(longer, size_pt, face) <= width_mm:
            lines[-1] = longer
            continue
        if lines[-1]:
            lines.append("")
        for letter in word:
            if lines[-1] and measure_mm(lines[-1] + letter, size_pt, face) > width_mm:
                lines.append("")
            lines[-1] += letter
    return lines


def spell_out(text: str, face: Face) -> str:
    """Letters that the font does not have as their code points: nothing is left out."""
    font = _read_font(face)
    return "".join(c if c.isspace() or font.get_char_index(ord(c)) else c.encode("unicode_escape").decode() for c in text)


def measure_mm(text: str, size_pt: float, face: Face) -> float:
    """Width of a line."""
    return _measure_pt(text, face) * size_pt / MEASURED_AT * POINT_MM


@lru_cache(maxsize=4096)
def _measure_pt(text: str, face: Face) -> float:
    font = _read_font(face)
    font.set_text(text, 0.0, flags=LoadFlags.NO_HINTING)
    return float(font.get_width_height()[0]) / 64.0


def _read_font(face: Face) -> FT2Font:
    font = get_font(find_font_file(face))
    font.set_size(MEASURED_AT, 72)
    return font


def find_font_file(face: Face) -> Path:
    """Of a font that comes with the library, so that the page looks the same everywhere."""
    return Path(mpl.get_data_path()) / "fonts" / "ttf" / FONTS[face]
