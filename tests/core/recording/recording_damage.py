"""What can be done to the files of a recording."""

from __future__ import annotations

import gzip
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.csv as pa_csv
import pyarrow.parquet as pq


def load_samples(folder: Path) -> pa.Table:
    return pq.read_table(folder / "samples.parquet")


def save_samples(folder: Path, table: pa.Table, suffix: str = "parquet") -> None:
    (folder / "samples.parquet").unlink()
    file = folder / f"samples.{suffix}"
    if suffix == "parquet":
        pq.write_table(table, file)
    elif suffix == "csv":
        pa_csv.write_csv(table, file)
    else:
        with gzip.open(file, "wb") as stream:
            pa_csv.write_csv(table, stream)


def change_samples(folder: Path, change: Callable[[pa.Table], pa.Table], suffix: str = "parquet") -> None:
    save_samples(folder, change(load_samples(folder)), suffix)


def scale_columns(table: pa.Table, names: tuple[str, ...], factor: float) -> pa.Table:
    for name in names:
        table = set_column(table, name, factor * table[name].to_numpy())
    return table


def set_column(table: pa.Table, name: str, values: Any) -> pa.Table:
    return table.set_column(table.column_names.index(name), name, pa.array(values))


def change_manifest(folder: Path, change: Callable[[dict[str, Any]], object]) -> None:
    content = json.loads((folder / "recording.json").read_text())
    change(content)
    (folder / "recording.json").write_text(json.dumps(content))


def text_of(folder: Path, change: Callable[[str], str], name: str = "recording.json") -> None:
    (folder / name).write_text(change((folder / name).read_text()))


def cell_of(folder: Path, name: str, row: int, value: Any, suffix: str = "parquet") -> None:
    def change(table: pa.Table) -> pa.Table:
        values = table[name].to_pylist()
        values[row - 1] = value
        if isinstance(value, str) and name != "phase":
            values = [str(v) for v in values]
        return set_column(table, name, values)

    change_samples(folder, change, suffix)


def drop(folder: Path, *names: str) -> None:
    change_samples(folder, lambda table: table.drop_columns(list(names)))


def cut(file: Path, keep: float) -> None:
    content = file.read_bytes()
    file.write_bytes(content[: int(keep * len(content))])


def link_out(folder: Path, name: str) -> None:
    outside = folder.parent / f"outside-{name}"
    (folder / name).rename(outside)
    (folder / name).symlink_to(outside)


def as_csv(folder: Path, change: Callable[[list[str]], list[str]]) -> None:
    save_samples(folder, load_samples(folder), "csv")
    lines = (folder / "samples.csv").read_text().splitlines()
    (folder / "samples.csv").write_text("\n".join(change(lines)) + "\n")


def deep_json(folder: Path) -> None:
    (folder / "recording.json").write_text("[" * 200_000)
