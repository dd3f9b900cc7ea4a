"""The samples of a recording on disk: named columns of equal length in Parquet or CSV, read as an untrusted file.

Rows are counted from 1, the first sample. Columns that the format does not know are left alone.
"""

from __future__ import annotations

import gzip
import io
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any, Literal, NamedTuple, NoReturn, TypeAlias

import numpy as np
import pyarrow as pa
import pyarrow.csv as pa_csv
import pyarrow.parquet as pq
from numpy.typing import NDArray

from core.array import Array
from core.errors import BadRecording
from core.files.jail import find_inside
from core.recording.cut_text import cut_text
from core.words.message import Message

Column: TypeAlias = "pa.ChunkedArray[Any]"

FILES = ("samples.parquet", "samples.csv", "samples.csv.gz")
MAX_SAMPLES = 3_000_000  # 50 minutes at 1 kHz
MAX_BYTES = 2_000_000_000
BUFFER_BYTES = 1_000_000
"""Of each column of a Parquet file that are read at a time."""


class Samples:
    """Columns of a samples file, all of its rows or some.

    Args:
        table: the columns. where: the file. first_row: which row of the file the first one is.

    Raises:
        BadRecording: two columns of one name.
    """

    def __init__(self, table: pa.Table, where: str, *, first_row: int = 1) -> None:
        self.table, self.where, self._first_row = table, where, first_row
        names = table.column_names
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise BadRecording(name_column(where, cut_text(twice[0])), "recording-column-repeated", count=names.count(twice[0]))

    def row(self, k: int) -> int:
        """Of the file, counted from 1, for the k-th row of these, counted from 0."""
        return self._first_row + k

    def __contains__(self, name: str) -> bool:
        return name in self.table.column_names

    def __len__(self) -> int:
        return len(self.table)

    def any_of(self, names: Iterable[str]) -> bool:
        """Whether at least one of the columns is there."""
        return any(name in self for name in names)

    def numbers(self, *names: str) -> Array:
        """The columns side by side, (N, len(names)), finite.

        Raises:
            BadRecording: a column is missing, holds text, or a value is missing, NaN or infinite.
        """
        return np.column_stack([self._number_column(name) for name in names])

    def texts(self, name: str) -> NDArray[np.str_]:
        """A column of text, (N,).

        Raises:
            BadRecording: the column is missing, is not text, or a value is missing.
        """
        column = self._column(name)
        if pa.types.is_dictionary(column.type):
            column = column.cast(column.type.value_type)
        if not (pa.types.is_string(column.type) or pa.types.is_large_string(column.type)):
            raise BadRecording(name_column(self.where, name), "recording-no-texts", type=str(column.type))
        if column.null_count:
            raise BadRecording(name_column(self.where, name, self.row(_first_null(column))), "recording-no-text")
        return np.asarray(column.to_pylist(), dtype=np.str_)

    def _column(self, name: str) -> Column:
        if name not in self:
            columns = [cut_text(each) for each in self.table.column_names]
            raise BadRecording(name_column(self.where, name), "recording-no-column", columns=columns)
        return self.table.column(name)

    def _number_column(self, name: str) -> Array:
        column = self._column(name)
        if pa.types.is_string(column.type) or pa.types.is_large_string(column.type) or pa.types.is_dictionary(column.type):
            self._refuse_text(name, column)
        if not (pa.types.is_floating(column.type) or pa.types.is_integer(column.type)):
            raise BadRecording(name_column(self.where, name), "recording-no-numbers", type=str(column.type))
        if column.null_count:
            raise BadRecording(name_column(self.where, name, self.row(_first_null(column))), "recording-no-number")
        values = np.asarray(column.to_numpy(), dtype=float)
        bad = np.flatnonzero(~np.isfinite(values))
        if len(bad):
            raise BadRecording(name_column(self.where, name, self.row(int(bad[0]))), "recording-not-finite", value=str(values[bad[0]]))
        return values

    def _refuse_text(self, name: str, column: Column) -> NoReturn:
        for row, value in enumerate(column.to_pylist(), start=self.row(0)):
            try:
                float(str(value))
            except ValueError:
                raise BadRecording(name_column(self.where, name, row), "recording-text-for-number", text=cut_text(value, 40)) from None
        raise BadRecording(name_column(self.where, name), "recording-numbers-as-text")


class CsvForm(NamedTuple):
    """How a CSV is written.

    Args:
        skipped: lines before the columns begin.
        names: of the columns; None where the first line that is read has them.
    """

    delimiter: str = ","
    decimal_point: str = "."
    skipped: int = 0
    names: list[str] | None = None


PLAIN_CSV = CsvForm()


class SamplesFile:
    """A file of columns.

    Args:
        file: CSV, CSV with gzip, or Parquet.
        where: what messages call it.
        form: of a CSV.
    """

    def __init__(self, file: Path, where: str, form: CsvForm = PLAIN_CSV) -> None:
        self._file, self.where, self._form = file, where, form
        self._is_parquet = file.name.lower().endswith("parquet")

    @classmethod
    def of_folder(cls, folder: Path) -> SamplesFile:
        """The samples file of a recording.

        Raises:
            BadRecording: none or several samples files, or one that is too large.
        """
        present = [name for name in FILES if (folder / name).exists() or (folder / name).is_symlink()]
        if not present:
            raise BadRecording(str(folder), "recording-no-samples", files=FILES)
        if len(present) > 1:
            raise BadRecording(str(folder), "recording-several-samples", present=present, files=FILES)
        return cls(find_inside(folder, present[0], BadRecording, max_bytes=MAX_BYTES), str(folder / present[0]))

    def read(self) -> Samples:
        """All rows.

        Raises:
            BadRecording: truncated, malformed, empty or too long.
        """
        table = self._read_parquet() if self._is_parquet else self._read_csv()
        self._check_length(len(table), MAX_SAMPLES)
        return Samples(table, self.where)

    def find_spacing(self) -> tuple[int, float] | None:
        """How many rows there are, and the mean time between them, s; None where only reading them all would tell."""
        if not self._is_parquet:
            return None
        with self._parquet() as parquet:
            rows = parquet.metadata.num_rows
            if rows < 2 or "t" not in parquet.schema_arrow.names:
                return None
            ends = [parquet.read_row_group(k, columns=["t"]).column("t") for k in (0, parquet.num_row_groups - 1)]
        try:
            lasts = float(ends[1][-1].as_py()) - float(ends[0][0].as_py())
        except (TypeError, ValueError, IndexError):
            return None  # reading it will say what is wrong with it
        return rows, lasts / (rows - 1)

    def batches(self, rows: int, *, most: int) -> Iterator[Samples]:
        """So many rows at a time, of a Parquet file with no more than `most`.

        Raises:
            BadRecording: truncated, malformed or too long.
        """
        with self._parquet() as parquet:
            self._check_length(parquet.metadata.num_rows, most)
            first_row, kept = 1, parquet.schema_arrow.empty_table()
            for group in range(parquet.num_row_groups):  # asked for all of them, Arrow would hold the whole file
                for batch in parquet.iter_batches(batch_size=rows, row_groups=[group], use_threads=False):
                    kept = pa.concat_tables([kept, pa.Table.from_batches([batch])])
                    if len(kept) >= rows:
                        yield self._check_texts(kept.slice(0, rows), first_row)
                        first_row, kept = first_row + rows, kept.slice(rows)
            if len(kept):
                yield self._check_texts(kept, first_row)
        pa.default_memory_pool().release_unused()

    def _check_texts(self, table: pa.Table, first_row: int) -> Samples:
        table.validate(full=True)  # whether texts are UTF-8
        return Samples(table, self.where, first_row=first_row)

    def _check_length(self, rows: int, most: int) -> None:
        if not 2 <= rows <= most:
            raise BadRecording(self.where, "recording-rows", rows=rows, most=most)

    @contextmanager
    def _parquet(self) -> Iterator[pq.ParquetFile]:
        try:
            with pq.ParquetFile(self._file, buffer_size=BUFFER_BYTES) as parquet:
                yield parquet
        except (pa.ArrowException, OSError, UnicodeDecodeError) as error:  # the last comes of a column's name
            raise BadRecording(self.where, "recording-broken-parquet", reason=_one_line(error)) from error

    def _read_parquet(self) -> pa.Table:
        with self._parquet() as parquet:
            self._check_length(parquet.metadata.num_rows, MAX_SAMPLES)
            table = parquet.read()
            table.validate(full=True)  # whether texts are UTF-8
            return table

    def _read_csv(self) -> pa.Table:
        wrong_rows: list[pa_csv.InvalidRow] = []
        form = self._form

        def keep(row: pa_csv.InvalidRow) -> Literal["skip"]:
            wrong_rows.append(row)
            return "skip"

        try:
            content = read_csv_bytes(self._file, self.where)
            table = pa_csv.read_csv(
                io.BytesIO(content),
                # one block: a column's type is that of all its rows, not of those in the first megabyte
                read_options=pa_csv.ReadOptions(
                    use_threads=False, block_size=len(content) + 1, skip_rows=form.skipped, column_names=form.names
                ),
                parse_options=pa_csv.ParseOptions(delimiter=form.delimiter, invalid_row_handler=keep),
                convert_options=pa_csv.ConvertOptions(null_values=[""], strings_can_be_null=True, decimal_point=form.decimal_point),
            )
        except (pa.ArrowException, OSError, EOFError, ValueError) as error:
            raise BadRecording(self.where, "recording-broken-csv", reason=_one_line(error)) from error
        if wrong_rows:
            row = wrong_rows[0]
            where = Message.of("recording-row", file=self.where, row=row.number - 1) if row.number else self.where
            raise BadRecording(where, "recording-values-of-row", count=row.actual_columns, columns=row.expected_columns)
        return table


def read_csv_bytes(file: Path, where: str, most_bytes: int = MAX_BYTES) -> bytes:
    """What a CSV holds, unpacked.

    Raises:
        BadRecording: it unpacks to more than `most_bytes`.
        OSError, EOFError: it is no gzip, or a truncated one.
    """
    if file.suffix.lower() != ".gz":
        return file.read_bytes()
    content = io.BytesIO()
    with gzip.open(file) as stream:
        while chunk := stream.read(BUFFER_BYTES):  # asked for all of it, gzip would first make room for what there may be
            content.write(chunk)
            if content.tell() > most_bytes:
                raise BadRecording(where, "recording-unpacks-too-large", most_bytes=most_bytes)
    return content.getvalue()


def name_column(file: str | Message, column: str, row: int | None = None) -> Message:
    """A column of a file or of a recording in memory, or the place in it in that row."""
    if row is None:
        return Message.of("recording-column", file=file, column=column)
    return Message.of("recording-column-row", file=file, column=column, row=row)


class SamplesWriter:
    """Columns as Parquet, block after block: float64 bit for bit, zstd."""

    def __init__(self, file: Path) -> None:
        self.file, self.writer = file, ExitStack()
        self.parquet: pq.ParquetWriter | None = None

    def write(self, columns: Mapping[str, Array | NDArray[np.str_]]) -> None:
        """A block of columns of equal length, each time the same ones."""
        table = pa.table({name: pa.array(values) for name, values in columns.items()})
        if self.parquet is None:
            numbers = [name for name, values in columns.items() if values.dtype.kind == "f"]
            texts = [name for name in columns if name not in numbers]
            encodings: dict[str, Any] = {"use_dictionary": texts or False, "use_byte_stream_split": numbers}
            self.parquet = self.writer.enter_context(pq.ParquetWriter(self.file, table.schema, compression="zstd", **encodings))
        self.parquet.write_table(table)

    def __enter__(self) -> SamplesWriter:
        return self

    def __exit__(self, *_: object) -> None:
        self.writer.close()


def _first_null(column: Column) -> int:
    return int(np.flatnonzero(np.asarray(column.is_null()))[0])


def _one_line(error: BaseException) -> str:
    return " ".join(str(error).split())[:160]
