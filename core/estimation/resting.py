"""A motion that was logged so slowly that nobody knows how it went between two rows: those at rest are used alone.

Rows more than a fiftieth of a second apart are taken for poses by themselves. Where they were logged on the way, the wrench has an
acceleration that they do not show. A row between two neighbours that are where it is has none; unless the wrench comes late, or early:
then those are left that have nothing but rest about them for longer.
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
SETTLED_S = 0.35
"""About a row on both sides, where a neighbour does not do."""
FEWEST_ROWS = 6
"""That tell anything of a payload."""
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
    for rows in (resting, find_resting(poses, SETTLED_S)):
        if int(rows.sum()) < FEWEST_ROWS:
            break
        found = identify(take_rows(recording, rows))
        if _fits(found):
            said = Message.of("estimation-rows-at-rest", used=int(rows.sum()), rows=len(rows), period_s=poses.period)
            segments = segments_of_phase(np.where(rows, "hold:free", "transfer"))
            return replace(found, segments=segments, warnings=(said, *found.warnings))
    return answer


def find_resting(poses: Poses, about_s: float = 0.0) -> NDArray[np.bool_]:
    """(N,), rows between two neighbours of the same pose, and all the others so far away in time."""
    R = poses.rotation
    turned = np.linalg.norm(R[1:] - R[:-1], axis=(1, 2)) / np.sqrt(2.0)
    step = np.diff(poses.t)
    same = turned < np.minimum(SAME_RAD, SLOW_RAD_S * step)
    if poses.position is not None:
        same &= np.linalg.norm(np.diff(poses.position, axis=0), axis=1) < np.minimum(SAME_M, SLOW_M_S * step)
    resting = np.concatenate(([False], same)) & np.concatenate((same, [False]))
    moves = np.append(0, np.cumsum(~same))
    first, last = (np.minimum(np.searchsorted(poses.t, poses.t + s), len(R) - 1) for s in (-about_s, about_s))
    return np.asarray(resting & (moves[last] == moves[first]))


def _fits(answer: Identification) -> bool:
    estimate = answer.estimate
    known = estimate is not None and bool(estimate.determined[0])
    return known and all(said.code != "estimation-residual-above-noise" for said in answer.warnings)
