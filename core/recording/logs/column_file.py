"""Files of columns as programs write them: other separators, decimal commas, no names, and the CSV of ATI's demonstration program."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import numpy as np
import pyarrow as pa

from core.errors import BadRecording
from core.recording.samples import CsvForm, Samples, SamplesFile, name_column, read_csv_bytes
from core.words.message import Message

HEAD_BYTES = 65_536
SEPARATORS = ",;\t "
DECIMAL_COMMA = re.compile(r"-?\d+,\d+(;|$)")
ATI_LINES = ("Start Time", "RDT Sample Rate", "Force Units", "Counts per Unit Force", "Torque Units", "Counts per Unit Torque")
ATI_FORCES = {"n": 1.0, "kn": 1e3, "lbf": 4.4482216152605, "lb": 4.4482216152605, "klbf": 4448.2216152605, "kg": 9.80665, "kgf": 9.80665}
ATI_TORQUES = {
    "nm": 1.0, "nmm": 1e-3, "knm": 1e3, "lbfin": 0.1129848290276167, "inlb": 0.1129848290276167, "inlbf": 0.1129848290276167,
    "lbin": 0.1129848290276167, "lbfft": 1.3558179483314004, "ftlb": 1.3558179483314004, "ftlbf": 1.3558179483314004,
    "lbft": 1.3558179483314004, "kgcm": 0.0980665, "kgfcm": 0.0980665,
}  # fmt: skip
"""Units as the sensor's configuration page names them, without case, spaces and signs: in N and N m."""


def read_column_file(file: Path, where: str) -> Samples:
    """The columns of a CSV or a Parquet file; those of a CSV without names are called 1, 2, 3 ...

    Raises:
        BadRecording: it cannot be read, with the reason.
    """
    if file.name.lower().endswith("parquet"):
        return SamplesFile(file, where).read()
    head = _read_head(file, where)
    if head[0].partition(",")[0].strip('" ') == ATI_LINES[0]:
        return _read_ati(file, where, head)
    return SamplesFile(file, where, _find_form(head)).read()


def _read_head(file: Path, where: str) -> list[str]:
    """The first lines, at least one."""
    try:
        content = read_csv_bytes(file, where)[:HEAD_BYTES]
    except (OSError, EOFError) as error:
        raise BadRecording(where, "recording-broken-csv", reason=str(error)[:160]) from error
    return content.decode("utf-8-sig", errors="replace").splitlines() or [""]


def _find_form(lines: list[str]) -> CsvForm:
    """Separator, decimal sign and names, from the first two lines."""
    first = lines[0].strip()
    counts = [first.count(separator) for separator in SEPARATORS]
    separator = SEPARATORS[int(np.argmax([count > 0 for count in counts]))]
    last = lines[1] if len(lines) > 1 else first
    if ";" in first and DECIMAL_COMMA.search(last):
        return CsvForm(";", ",", names=_number_columns(first.replace(",", "."), ";"))
    return CsvForm(separator, names=_number_columns(first, separator))


def _number_columns(first: str, separator: str) -> list[str] | None:
    """Names for the columns of a file that begins with a row of numbers; None where it begins with names."""
    values = first.split(separator)
    try:
        [float(value) for value in values]
    except ValueError:
        return None
    return [str(k) for k in range(1, len(values) + 1)]


def _read_ati(file: Path, where: str, head: list[str]) -> Samples:
    """Counts as N and N m, and the time from the sequence: the packets count from 1 at the stated rate (ATI 9610-05-1022, Section 7.4)."""
    stated = {row[0].strip(): row[1].strip() for row in csv.reader(head[: len(ATI_LINES)]) if len(row) > 1}
    missing = [name for name in ATI_LINES if name not in stated]
    if missing:
        raise BadRecording(where, "import-ati-line", line=missing[0])
    rate = _read_positive(where, "RDT Sample Rate", stated)
    force = _find_unit(where, "Force Units", stated, ATI_FORCES) / _read_positive(where, "Counts per Unit Force", stated)
    torque = _find_unit(where, "Torque Units", stated, ATI_TORQUES) / _read_positive(where, "Counts per Unit Torque", stated)
    samples = SamplesFile(file, where, CsvForm(skipped=len(ATI_LINES))).read()
    named = {name.strip().casefold(): name for name in samples.table.column_names}
    scales = dict.fromkeys(("fx", "fy", "fz"), force) | dict.fromkeys(("tx", "ty", "tz"), torque)
    lacking = [name for name in ("rdt sequence", *scales) if name not in named]
    if lacking:
        raise BadRecording(name_column(where, lacking[0]), "recording-no-column", columns=list(named)[:20])
    columns = {"t": samples.numbers(named["rdt sequence"])[:, 0] / rate}
    columns |= {name: samples.numbers(named[name])[:, 0] * scale for name, scale in scales.items()}
    return Samples(pa.table(columns), where)


def _read_positive(where: str, name: str, stated: dict[str, str]) -> float:
    try:
        value = float(stated[name])
    except ValueError:
        value = 0.0
    if not 0.0 < value < np.inf:
        raise BadRecording(Message.of("import-key", file=where, key=name), "import-ati-number", value=stated[name][:40])
    return value


def _find_unit(where: str, name: str, stated: dict[str, str], units: dict[str, float]) -> float:
    unit = re.sub(r"[^a-z]", "", stated[name].casefold())
    if unit not in units:
        raise BadRecording(Message.of("import-key", file=where, key=name), "import-ati-unit", unit=stated[name][:40], known=sorted(units))
    return units[unit]
