"""A recording with a planted fault, small enough to be diagnosed within seconds."""

from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np

from core.recording.folder import write_recording
from tests.synthetic import Imperfections, payload, record, run_of

TILT_RAD = 0.02
"""Of the base, about x: 1.15 degrees."""


def tilted_recording(folder: Path) -> Path:
    """A short run on a base that is not level: the zip of the folder `recording` beside it."""
    tilted = Imperfections(tilt_rad=(TILT_RAD, 0.0))
    write_recording(record(run_of(repetitions=1), payload("steel_block"), np.random.default_rng(1), tilted), folder / "recording")
    with zipfile.ZipFile(folder / "recording.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        for file in (folder / "recording").iterdir():
            archive.write(file, file.name)
    return folder / "recording.zip"
