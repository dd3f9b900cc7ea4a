"""Readings of a sensor that is asked less often than they are recorded: how many repeat the one before, and which are fresh."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from core.array import Array
from core.recording.recording import Recording, take_rows

SIGNIFICANT = 5.0
"""Standard deviations."""
CHANCE = 0.01
"""A block tells nothing when fresh rows would repeat all channels with more than this chance."""
BLOCK = 200
"""Samples over which the channels' own chance to repeat a value is taken as constant."""
RESTING = 0.5
"""Share of rows that repeat the one before; noise on a grid as fine as half of its usual step repeats itself less often."""
ALONE, JUMPS = 2, 20
"""Most channels that change in a row in which no reading of all of them has come; fewer changes do not tell a dead band."""
SHARP, WIDER = 0.8, 2.5
"""A dead band's changes begin at this share of their median at least, and at so many times the channel's smallest change."""
LEAST = 0.15
"""Share of held rows from which a recording is looked at through its fresh readings alone."""


class Fresh(NamedTuple):
    """Where the fresh readings lie.

    Args:
        rows: (M,), the fresh ones.
        between: (N, N), from samples to the straight lines between those at fresh rows; what goes through it is known at no other row.
        every: how many rows from one fresh reading to the next, in the mean.
    """

    rows: NDArray[np.intp]
    between: csr_array
    every: float


def find_fresh(wrench: Array) -> Fresh | None:
    """The fresh rows of readings (N, 6), of which the others repeat the row before in all channels; None where hardly any does."""
    if find_held_share(wrench)[0] < LEAST:
        return None
    n = len(wrench)
    fresh = np.flatnonzero(~_repeats(wrench))
    rows = np.arange(n)
    after = np.clip(np.searchsorted(fresh, rows, side="right"), 1, len(fresh) - 1)
    first, last = fresh[after - 1], fresh[after]
    share = np.clip((rows - first) / (last - first), 0.0, 1.0)
    weights, columns = np.concatenate((1.0 - share, share)), np.concatenate((first, last))
    return Fresh(fresh, csr_array((weights, (np.tile(rows, 2), columns)), shape=(n, n)), n / len(fresh))


def drop_repeated_rows(recording: Recording) -> Recording:
    """The recording without the rows of a recorder that wrote the last one again, pose and wrench alike, where at least `LEAST` of them are
    that: they say where the robot was, not where it is, and are lost rather than held."""
    poses = recording.q if recording.q is not None else recording.orientation
    if recording.wrench is None or poses is None:
        return recording
    repeated = _repeats(recording.wrench)
    if repeated.mean() >= LEAST:  # of hardly any recording, so the poses are seldom looked at
        repeated &= _repeats(poses.reshape(len(poses), -1))
    if repeated.mean() < LEAST or find_held_share(recording.wrench)[0] < LEAST:
        return recording
    return take_rows(recording, ~repeated)


def _repeats(x: Array) -> NDArray[np.bool_]:
    """(N,), which rows of x (N, m) are those before them once more."""
    return np.concatenate(([False], (x[1:] == x[:-1]).all(axis=1)))


def find_held_share(wrench: Array) -> tuple[float, int, int]:
    """Share of held rows in `wrench` (N, 6), the number of rows that it is based on, and the longest run of equal rows.

    Blocks in which all channels would rest on their values anyway (coarse steps, nothing moving) cannot tell and are left out.
    """
    same = np.diff(wrench, axis=0) == 0
    every = same.all(axis=1)
    blocks = len(same) // BLOCK
    if blocks == 0:
        return 0.0, 0, 0
    e = same[: blocks * BLOCK].reshape(blocks, BLOCK, 6).mean(axis=1)
    joint = every[: blocks * BLOCK].reshape(blocks, BLOCK).mean(axis=1)
    shares = np.array([_solve_held_share(joint[b], e[b]) for b in range(blocks)])
    told = np.isfinite(shares)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], every.astype(int), [0]])))
    longest = int(np.max(edges[1::2] - edges[::2], initial=0))
    by_chance = e.prod(axis=1)
    if BLOCK * float((joint - by_chance).sum()) < SIGNIFICANT * math.sqrt(BLOCK * float(by_chance.sum()) + 1):
        shares[told] = 0.0
    if told.mean() < 0.5:  # the few blocks that seem to tell are then those in which chance did
        return 0.0, 0, longest
    shares[joint == 1.0] = 1.0  # where noise is seen elsewhere, a wrench that stands still altogether is held
    told |= joint == 1.0
    return float(shares[told].mean()), int(told.sum()) * BLOCK, longest


def find_dead_bands(wrench: Array) -> Array:
    """(6,), what each channel of `wrench` (N, 6) has to change by before it is seen to; 0 where it does not rest between its changes.

    It never changes by less, while noise makes small changes as well. A bus may send all channels now and then, changed or not: then those
    count that change by themselves, and much more than at other times, since rounded readings that are held seem to do that by a step.
    """
    in_turn = find_held_share(wrench)[0] > 0.0
    rows = (wrench[1:] != wrench[:-1]).sum(axis=1) <= (ALONE if in_turn else wrench.shape[1])
    return np.array([_find_dead_band(channel, rows, WIDER if in_turn else 0.0) for channel in wrench.T])


def _find_dead_band(channel: Array, rows: NDArray[np.bool_], wider: float) -> float:
    """Of changes in these rows; at the ends of its range, where it may be clipped, they do not count."""
    inside = (channel > channel.min()) & (channel < channel.max())
    changes = np.where(inside[1:] & inside[:-1], np.abs(np.diff(channel)), 0.0)
    jumps = changes[rows][changes[rows] > 0]
    if not JUMPS <= len(jumps) < (1.0 - RESTING) * len(changes):
        return 0.0
    least, median = np.quantile(jumps, (0.1, 0.5))
    return float(least) if least >= max(SHARP * median, wider * changes[changes > 0].min()) else 0.0


def _solve_held_share(joint: float, e: Array) -> float:
    """p with `joint = p + (1 - p) prod((e - p)/(1 - p))`, the smallest; NaN where p could be anything."""
    if joint == 0:
        return 0.0
    low, high = 0.0, float(e.min())
    if _by_chance(min(joint, high), e) > CHANCE or joint == 1.0:
        return math.nan
    if _by_chance(0.0, e) >= joint:
        return 0.0
    for _ in range(40):
        p = 0.5 * (low + high)
        low, high = (p, high) if p + (1 - p) * _by_chance(p, e) < joint else (low, p)
    return 0.5 * (low + high)


def _by_chance(p: float, e: Array) -> float:
    """Chance that all channels repeat without being held, given that share p is."""
    return float(np.prod(np.clip((e - p) / max(1 - p, 1e-12), 0.0, 1.0)))
