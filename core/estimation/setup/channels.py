"""Channels that say nothing: dead ones, a wrench that never changes, rows that are copies."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.setup.stances import FORCE, Stances
from core.payload.channels import CHANNELS
from core.recording.recording import Recording
from core.words.message import Message

MOST_COPIES = 0.3
"""Share of the rows of a motion that may repeat the row before."""
FEWEST_ROWS = 5
FELT = 4.0
"""Times its resolution or noise that a change has to have to be missed."""


def find_dead_wrench(recording: Recording) -> Message | None:
    """A wrench that is zero, or one that never changes."""
    wrench = recording.wrench
    if wrench is None or len(wrench) < FEWEST_ROWS or np.ptp(wrench, axis=0).any():
        return None
    return Message.of("setup-wrench-zero") if not wrench.any() else Message.of("setup-wrench-constant", rows=len(wrench))


def find_dead_channel(recording: Recording, stances: Stances) -> Message | None:
    """A channel that never changes although what the others feel should change it."""
    assert recording.wrench is not None
    still: NDArray[np.bool_] = np.asarray(np.ptp(recording.wrench, axis=0) == 0.0)
    if not still.any() or stances.distinct < FEWEST_ROWS:
        return None
    expected = _expect_change(stances)
    sensor = recording.sensor
    least = np.max([np.zeros(6) if each is None else each for each in (sensor.resolution, sensor.noise_std)], axis=0)
    missing: NDArray[np.bool_] = np.asarray(
        still & (expected > FELT * least) & (expected > 0.05 * np.repeat([expected[:3].max(), expected[3:].max()], 3))
    )
    return Message.of("setup-channel-dead", channel=CHANNELS[int(np.argmax(missing))]) if missing.any() else None


def _expect_change(stances: Stances) -> Array:
    """(6,), from the weight that the channels that do change have felt."""
    g = stances.base @ stances.gravity
    changes = np.ptp(g, axis=0)
    felt = np.ptp(stances.wrench, axis=0)
    mass = max((felt[i] / changes[i] for i in range(3) if changes[i] > 1.0), default=0.0)
    return np.concatenate((mass * changes, np.full(3, 0.0)))


def remarks_on_rows(recording: Recording) -> Iterator[Message]:
    """Rows that repeat the row before while the robot moves."""
    poses = recording.q if recording.q is not None else recording.orientation
    if recording.wrench is None or poses is None or len(recording) < 100:
        return
    x = poses.reshape(len(poses), -1)
    same = np.asarray(~np.diff(x, axis=0).any(axis=1) & ~np.diff(recording.wrench, axis=0).any(axis=1))
    around = np.linalg.norm(x[10:] - x[:-10], axis=1)
    moving = around > 0.05 * around.max(initial=0.0)
    share = float(same[4:-5][moving].mean()) if moving.any() and around.max() > 0.0 else 0.0
    if share > MOST_COPIES:
        yield Message.of("setup-rows-repeated", share=share)


def remarks_on_force(stances: Stances) -> Iterator[Message]:
    """A force that changes from pose to pose by no more than its noise, where a payload's would."""
    g = stances.base @ stances.gravity
    if stances.distinct < FEWEST_ROWS or np.ptp(g, axis=0).max() < 0.5 * np.linalg.norm(stances.gravity):
        return
    change, noise = stances.wrench[:, FORCE].std(axis=0), stances.noise[:, FORCE].max(axis=0)
    if noise.any() and (change < 2.0 * noise).all():
        yield Message.of("setup-nothing-felt", change_n=float(change.max()))
