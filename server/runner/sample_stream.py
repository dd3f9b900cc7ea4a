"""A run's samples on disk as they come, so that whatever ends the run leaves a recording: an Arrow stream that may end anywhere."""

from __future__ import annotations

import logging
from collections.abc import Iterator
from contextlib import suppress
from io import IOBase
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO, Self, cast

import numpy as np
import pyarrow as pa

from core.recording.folder import write_recording
from core.sessions.sample_log import SampleLog
from core.sessions.session import RobotState
from server.runner.run_folder import SAMPLES

logger = logging.getLogger("heft.samples")

FIELDS = ("q", "dq", "q_cmd", "wrench", "tau")


class SampleStream:
    """Appends batches of samples to `samples.arrows`; each is with the operating system when `append` returns.

    Raises:
        OSError: the disk is full or gone.
    """

    def __init__(self, folder: Path) -> None:
        self._file = (folder / SAMPLES).open("wb")
        self._writer: pa.RecordBatchStreamWriter | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self._file.close()

    def append(self, states: list[RobotState], phases: list[str]) -> None:
        """Samples of one batch with the phase of each."""
        columns = {"t": pa.array([state.t for state in states]), "phase": pa.array(phases)}
        for name in FIELDS:
            if getattr(states[0], name) is not None:
                rows = np.array([getattr(state, name) for state in states])
                columns[name] = pa.FixedSizeListArray.from_arrays(pa.array(rows.ravel()), rows.shape[1])
        batch = pa.record_batch(columns)
        if self._writer is None:
            self._writer = pa.ipc.new_stream(self._file, batch.schema)
        self._writer.write_batch(batch)
        self._file.flush()


def recover_recording(folder: Path, log: SampleLog, out: Path) -> int:
    """Writes the recording of a run that ended without closing one, and returns how many samples there were.

    Args:
        folder: of the run, with its `samples.arrows`; a batch that was cut short is left out.
        log: empty, of the run's cell.
        out: folder to make for the recording; nothing is written where there are no samples.
    """
    read_samples(folder, log)
    if len(log):
        write_recording(log.recording(), out)
    return len(log)


def read_samples(folder: Path, log: SampleLog) -> None:
    """Appends to a log what is on disk of a run's samples by now; nothing where there are none yet."""
    with suppress(FileNotFoundError), (folder / SAMPLES).open("rb") as file:
        _read(cast("BinaryIO", file), log)


def _read(file: BinaryIO, log: SampleLog) -> None:
    for batch in _batches(file):
        names = [name for name in FIELDS if name in batch.schema.names]
        columns = {name: np.array(batch.column(name).flatten()).reshape(len(batch), -1) for name in names}
        for k, (t, phase) in enumerate(zip(batch.column("t").to_pylist(), batch.column("phase").to_pylist(), strict=True)):
            log.extend([RobotState(t=t, **{name: rows[k] for name, rows in columns.items()})], phase)


def _batches(file: BinaryIO) -> Iterator[Any]:
    """Batches of the stream up to its end, or to where it was cut short."""
    try:
        yield from pa.ipc.open_stream(cast("IOBase", file))
    except (pa.ArrowInvalid, OSError) as cut:
        logger.info("%s was cut short: %s", SAMPLES, cut)
