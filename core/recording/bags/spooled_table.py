"""A table that is too long for the memory: rows of float64, kept in a temporary file beyond some megabytes."""

from __future__ import annotations

import tempfile
import weakref
from collections.abc import Sequence

import numpy as np

from core.array import Array
from core.errors import BadRecording
from core.recording.cut_text import cut_text
from core.recording.samples import name_column

MOST_ROWS = 20_000_000  # five and a half hours at 1 kHz
IN_MEMORY_BYTES = 4_000_000
"""Of a table; beyond it is written out."""


class SpooledTable:
    """Columns of one topic; `columns[0]` is `t`, s.

    Args:
        where: what messages call it.
        columns: their names.
        frame: in which the values are, where the messages say so.
    """

    def __init__(self, where: str, columns: Sequence[str], frame: str | None) -> None:
        self.where, self.columns, self.frame = where, list(columns), frame
        self.file = tempfile.SpooledTemporaryFile(max_size=IN_MEMORY_BYTES)  # noqa: SIM115 - it is closed with the table
        weakref.finalize(self, self.file.close)
        self.rows = 0

    def __len__(self) -> int:
        return self.rows

    def append(self, rows: Array) -> None:
        """Further rows (M, columns)."""
        self.rows += len(rows)
        if self.rows > MOST_ROWS:
            raise BadRecording(self.where, "recording-rows", rows=self.rows, most=MOST_ROWS)
        self.file.seek(0, 2)
        self.file.write(np.ascontiguousarray(rows, dtype=float).tobytes())

    def numbers(self, *names: str, rows: slice = slice(None)) -> Array:
        """The columns side by side, (N, len(names)), finite.

        Raises:
            BadRecording: a column is missing, or a value is not finite.
        """
        for name in names:
            if name not in self.columns:
                raise BadRecording(name_column(self.where, name), "recording-no-column", columns=[cut_text(each) for each in self.columns])
        begin, end, _ = rows.indices(self.rows)
        picked = [self.columns.index(name) for name in names]
        values = np.empty((max(end - begin, 0), len(names)))
        for at in range(begin, end, BLOCK):
            part = slice(at - begin, min(at + BLOCK, end) - begin)
            values[part] = self._read(at, part.stop - part.start)[:, picked]
        bad = np.argwhere(~np.isfinite(values))
        if len(bad):
            row, column = bad[0]
            where = name_column(self.where, names[int(column)], begin + int(row) + 1)
            raise BadRecording(where, "recording-not-finite", value=str(values[row, column]))
        return values

    def _read(self, begin: int, count: int) -> Array:
        width = len(self.columns) * 8
        self.file.seek(begin * width)
        return np.frombuffer(self.file.read(count * width)).reshape(count, len(self.columns))


BLOCK = 100_000
"""Rows that are read at once."""
