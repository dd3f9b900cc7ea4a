"""A motion that was logged so slowly that nobody knows how it went between two rows: those at rest are used alone.

Rows more than a fiftieth of a second apart are taken for poses by themselves. Where they were logged on the way, the wrench has an
acceleration that they do not show. A row between two neighbours that are where it is has none.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from core.estimation.estimate import Identification
from core.estimation.kinematics import Poses, poses_of
from core.estimation.segments import segments_of_phase
from core.recording.recording import Recording, take_rows
from core.words.message import Message

SLOW_RAD_S, SLOW_M_S = 0.01, 0.005
"""Speeds from a row to its neighbours below which it is at rest, as in a faster recording."""
SAME_RAD, SAME_M = 1e-3, 1e-3
"""By which they may be turned and moved against it at most."""
FEWEST_SHARE = 0.1
"""Of the rows, that are at rest where somebody held still on purpose."""

Identify = Callable[[Recording], Identification]


def identify_at_rest(recording: Recording, identify: Identify, answer: Identification) -> Identification:
    """The better of the answer from all rows of a slow log and that from its rows at rest, which is said."""
    poses = poses_of(recording)
    if poses is None or not poses.apart or recording.phase is not None or _fits(answer):
        return answer
    resting = find_resting(poses)
    if resting.all() or resting.mean() < FEWEST_SHARE:
        return answer
    found = identify(take_rows(recording, resting))
    if found.estimate is None or not found.estimate.determined[0] or not _fits(found):
        return answer
    said = Message.of("estimation-rows-at-rest", used=int(resting.sum()), rows=len(resting), period_s=poses.period)
    segments = segments_of_phase(np.where(resting, "hold:free", "transfer"))
    return replace(found, segments=segments, warnings=(said, *found.warnings))


def find_resting(poses: Poses) -> NDArray[np.bool_]:
    """(N,), rows between two neighbours of the same pose."""
    R = poses.rotation
    turned = np.linalg.norm(R[1:] - R[:-1], axis=(1, 2)) / np.sqrt(2.0)
    step = np.diff(poses.t)
    same = turned < np.minimum(SAME_RAD, SLOW_RAD_S * step)
    if poses.position is not None:
        same &= np.linalg.norm(np.diff(poses.position, axis=0), axis=1) < np.minimum(SAME_M, SLOW_M_S * step)
    return np.concatenate(([False], same)) & np.concatenate((same, [False]))


def _fits(answer: Identification) -> bool:
    estimate = answer.estimate
    known = estimate is not None and bool(estimate.determined[0])
    return known and all(said.code != "estimation-residual-above-noise" for said in answer.warnings)
