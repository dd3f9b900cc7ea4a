"""`heft identify` of a long recording: own processor time and largest memory, `python -m bench.long_recording`.

An hour at 1 kHz is made by a generator without the engine's code (`tests.foreign_recordings`), written piece by piece, and identified by
the command in a process of its own. `--seconds 60 --rate 500` measures an ordinary one.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from core.array import Array

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from core.payload.channels import CHANNELS
from core.recording.folder import write_recording
from core.recording.recording import Recording
from tests.foreign_recordings import LongRun, make_long


def write_long(run: LongRun, folder: Path) -> None:
    """Writes a run as a recording, without holding more than a piece of it."""
    first = next(run.pieces)
    write_recording(first, folder)
    samples = folder / "samples.parquet"
    table = _table_of(first)
    with pq.ParquetWriter(samples, table.schema, compression="zstd") as writer:
        writer.write_table(table)
        for piece in run.pieces:
            writer.write_table(_table_of(piece))


def _table_of(piece: Recording) -> pa.Table:
    assert piece.q is not None
    assert piece.wrench is not None
    columns = {"t": piece.t} | {f"q_{k + 1}": x for k, x in enumerate(piece.q.T)} | dict(zip(CHANNELS, piece.wrench.T, strict=True))
    return pa.table({name: pa.array(np.ascontiguousarray(x)) for name, x in columns.items()})


def measure(folder: Path) -> tuple[float, float, Array, Array]:
    """Own processor time, s, largest memory, MB, of the command; the parameters that it found (10,) and their standard uncertainty."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    answer = folder.parent / "answer.json"
    command = [sys.executable, "-m", "core.cli", "identify", str(folder), "--json", str(answer)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    own = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    found = json.loads(answer.read_text())["estimate"]
    return own, after.ru_maxrss / 1024.0, np.array(found["phi"], dtype=float), np.array(found["std"], dtype=float)


def main() -> None:
    """Prints both figures, and by how much the answer is off."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=3600.0)
    parser.add_argument("--rate", type=float, default=1000.0, help="Hz")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=Path, default=None, help="folder that the recording is written to, or taken from")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or Path(temporary) / "long"
        run = make_long(arguments.seconds, arguments.rate, arguments.seed)
        if not folder.exists():
            write_long(run, folder)
        own_s, memory_mb, phi, std = measure(folder)
    off = np.abs(phi - run.phi) / std
    print(
        f"{arguments.seconds:.0f} s at {arguments.rate:.0f} Hz: {own_s:.1f} s of processor time, {memory_mb:.0f} MB at most; "
        f"mass off by {phi[0] - run.phi[0]:+.6f} kg, largest error {off.max():.1f} standard uncertainties"
    )


if __name__ == "__main__":
    main()
