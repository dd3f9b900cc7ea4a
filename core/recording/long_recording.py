"""A recording too long to be held row by row: means of neighbouring rows, made while it is read.

Pose and wrench go through the same mean, so what is lost is motion faster than the means, and nothing is late. A pose is not linear in the
joints and the wrench not in the pose; over `LONGEST_PERIOD_S` that is a hundred-thousandth.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.errors import BadRecording
from core.recording.folder import RecordingFolder
from core.recording.recording import COLUMNS, Recording, SensorDescription
from core.recording.samples import MAX_SAMPLES, name_column
from core.words.message import Message

MOST_ROWS = 400_000
"""Nearly 7 minutes at 1 kHz: a recording with more rows is condensed."""
LONGEST_PERIOD_S = 0.01
"""Of the means: short beside the windows that the estimate of a long recording averages over."""
BATCH_ROWS = 50_000
"""That are in memory at a time."""
GAP = 3.5
"""Periods; rows on both sides of a longer step are not averaged together."""
FEWEST_MEANS = 50
"""From which the noise of a mean is told from that of a row."""


def read_condensed(folder: Path) -> tuple[Recording, tuple[Message, ...]]:
    """Reads a recording folder, a long one as means of some rows each, and what has to be known of that.

    Raises:
        BadRecording, BadRobot: as for `core.recording.folder.read_recording`.
    """
    opened = RecordingFolder(folder)
    every = _find_every(opened.samples.find_spacing())
    if every == 1:
        return opened.recording_of(opened.samples.read()), ()
    found = _join([condense(piece, every) for piece in _read_pieces(opened, every)])
    return found, (Message.of("recording-condensed", rows=every, means=len(found)),)


def _find_every(spacing: tuple[int, float] | None) -> int:
    """How many rows make one, for so many with a mean spacing in s."""
    if spacing is None or spacing[0] <= MOST_ROWS or not spacing[1] > 0.0:
        return 1
    return max(1, min(-(-spacing[0] // MOST_ROWS), int(LONGEST_PERIOD_S / spacing[1] * (1.0 + 1e-6))))


def _read_pieces(opened: RecordingFolder, every: int) -> Iterator[Recording]:
    last = -np.inf
    for samples in opened.samples.batches(every * (BATCH_ROWS // every), most=every * MAX_SAMPLES):
        piece = opened.recording_of(samples)
        if piece.t[0] <= last:
            where = name_column(samples.where, "t", samples.row(0))
            raise BadRecording(where, "recording-time-not-increasing", time_s=float(piece.t[0]), before_s=float(last))
        last = piece.t[-1]
        yield piece


def condense(recording: Recording, every: int) -> Recording:
    """Means of `every` rows each, of one phase and without a gap between them; what is left over at their ends is left out.

    Noise and resolution of sensor and encoders become those of the means.
    """
    first = _first_rows(recording, every)
    rows = first[:, None] + np.arange(every)
    columns: dict[str, Any] = {}
    for name in COLUMNS:
        x = getattr(recording, name)
        if x is None:
            continue
        if name == "phase":
            columns[name] = x[first]
        elif name in ("q", "q_cmd"):
            columns[name] = _mean_angle(x[rows])
        elif name == "orientation":
            columns[name] = _mean_rotation(x[rows])
        else:
            columns[name] = x[rows].mean(axis=1)
    encoder = recording.encoder_std_rad
    return replace(
        recording,
        t=recording.t[rows].mean(axis=1),
        sensor=_of_means(recording.sensor, None if recording.wrench is None else recording.wrench[rows], every),
        encoder_std_rad=None if encoder is None else encoder / float(np.sqrt(every)),
        **columns,
    )


def _first_rows(recording: Recording, every: int) -> NDArray[np.intp]:
    t = recording.t
    steps = np.diff(t)
    cut = steps > GAP * np.median(steps) if len(steps) else np.zeros(0, dtype=bool)
    if recording.phase is not None:
        cut |= recording.phase[1:] != recording.phase[:-1]
    edges = [0, *(np.flatnonzero(cut) + 1).tolist(), len(t)]
    return np.concatenate([np.arange(a, b - every + 1, every) for a, b in pairwise(edges)]).astype(np.intp)


def _mean_angle(q: Array) -> Array:
    """(M, n) of (M, k, n), across a turn where a log wraps its angles."""
    off = q - q[:, :1]
    return np.asarray(q[:, 0] + (off - 2.0 * np.pi * np.round(off / (2.0 * np.pi))).mean(axis=1))


def _mean_rotation(rotation: Array) -> Array:
    """(M, 3, 3) of (M, k, 3, 3)."""
    from scipy.spatial.transform import Rotation  # noqa: PLC0415 - half of SciPy, for long recordings of attitudes

    mean = rotation.mean(axis=1)
    return np.asarray(Rotation.from_matrix(mean).as_matrix()) if len(mean) else mean


def _of_means(sensor: SensorDescription, wrench: Array | None, every: int) -> SensorDescription:
    """What is stated of single rows, for means of a wrench (M, k, 6)."""
    noise, step = sensor.noise_std, sensor.resolution
    return replace(
        sensor,
        noise_std=None if noise is None or wrench is None else noise * np.sqrt(_share_of_means(wrench)),
        resolution=None if step is None else step / every,
    )


def _share_of_means(x: Array) -> Array:
    """(n,), share of the noise's variance that means of rows (M, k, n) keep: 1 / k where it is white, up to 1 where it is slow."""
    means, least = x.mean(axis=1), 1.0 / x.shape[1]
    if len(means) < FEWEST_MEANS:
        return np.full(x.shape[2], least)
    between = _median_variance(np.diff(means, 2, axis=0)) / 6.0
    total = between + _median_variance((x - means[:, None]).reshape(-1, x.shape[2]))
    return np.asarray(np.clip(np.divide(between, total, out=np.full(len(total), least), where=total > 0.0), least, 1.0))


def _median_variance(x: Array) -> Array:
    """Of noise (N, n), by the median of its size, which a motion's parts do not move."""
    return np.asarray((1.4826 * np.median(np.abs(x), axis=0)) ** 2)


def _join(pieces: list[Recording]) -> Recording:
    """Pieces of one recording as one."""
    columns: dict[str, Any] = {
        name: np.concatenate([getattr(piece, name) for piece in pieces]) for name in ("t", *COLUMNS) if getattr(pieces[0], name) is not None
    }
    return replace(pieces[0], **columns)
