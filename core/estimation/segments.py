"""The motionless, rotating and other parts of a recording, from its `phase` column or from the motion itself."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from core.array import Array

Bools = NDArray[np.bool_]

SETTLING_S = 0.15
"""A hold's first moments, in which an arm still swings, are not called motionless."""
LEAVING_S = 0.06
"""A hold's last moments, in which an arm that speeds up is slow and yet accelerates, are not called so either."""
SHORTEST_HOLD_S = 0.3
GAP_S = 0.04
"""Longer than what holds and lost samples leave open; what lies on both sides of a longer gap is not averaged together."""
ALONG_AXIS = 0.995
"""Cosine from which a sensor axis counts as along gravity, or a rotation as about that axis (5.7 deg)."""


@dataclass(frozen=True)
class Segment:
    """Rows `start` to `stop` (exclusive) of one phase: `transfer`, `hold:x+`, `hold:free`, `rotate:x`."""

    start: int
    stop: int
    phase: str

    @property
    def rows(self) -> slice:
        """The rows."""
        return slice(self.start, self.stop)

    @property
    def is_hold(self) -> bool:
        """Whether the robot is motionless."""
        return self.phase.startswith("hold")

    @property
    def axis(self) -> str | None:
        """`x`, `y` or `z` of a rotation or of a hold along gravity; None otherwise."""
        tail = self.phase.partition(":")[2]
        return tail[0] if tail[:1] in ("x", "y", "z") else None

    @property
    def sign(self) -> int:
        """+1 where the axis points along gravity, -1 against it, 0 for anything but such a hold."""
        return {"+": 1, "-": -1}.get(self.phase[-1:], 0) if self.is_hold else 0


def stretches(t: Array) -> tuple[slice, ...]:
    """Rows without a gap in the times t (N,): runs in which no sample is later than the one before by 5 periods and `GAP_S`."""
    step = np.diff(t)
    late = step > max(GAP_S, 5.0 * float(np.median(step))) if len(step) else np.zeros(0, dtype=bool)
    edges = [0, *(np.flatnonzero(late) + 1).tolist(), len(t)]
    return tuple(slice(a, b) for a, b in pairwise(edges))


def cut_at_gaps(segments: tuple[Segment, ...], t: Array) -> tuple[Segment, ...]:
    """The segments of a recording with times t (N,), cut where it has a gap: no motion goes on across one."""
    edges = [part.start for part in stretches(t)[1:]]
    cuts = [sorted({part.start, part.stop, *(k for k in edges if part.start < k < part.stop)}) for part in segments]
    return tuple(Segment(a, b, part.phase) for part, rows in zip(segments, cuts, strict=True) for a, b in pairwise(rows))


def segments_of_phase(phase: NDArray[np.str_]) -> tuple[Segment, ...]:
    """Runs of equal labels (N,)."""
    changes = np.flatnonzero(phase[1:] != phase[:-1]) + 1
    edges = [0, *changes.tolist(), len(phase)]
    return tuple(Segment(a, b, str(phase[a])) for a, b in pairwise(edges) if b > a)


def segments_of_motion(t: Array, omega: Array, speed: Array, g: Array, *, threshold: Array) -> tuple[Segment, ...]:
    """Segments of a recording without labels.

    Args:
        t: (N,), s.
        omega: (N, 3), angular velocity in the sensor frame, rad/s.
        speed: (N,), m/s, of the sensor origin.
        g: (N, 3), gravity in the sensor frame.
        threshold: (2,), angular (rad/s) and linear (m/s) velocity below which the robot counts as motionless (epsilon_s).
    """
    still = (np.linalg.norm(omega, axis=1) < threshold[0]) & (speed < threshold[1])
    label = np.where(still, "hold", "transfer").astype("<U10")
    kept = [
        Segment(part.start, part.stop, hold_label(g[part.rows]) if part.is_hold else _motion_label(omega[part.rows], speed[part.rows]))
        if not part.is_hold or t[part.stop - 1] - t[part.start] >= SHORTEST_HOLD_S
        else Segment(part.start, part.stop, "transfer")
        for part in segments_of_phase(label)
    ]
    labels = np.concatenate([np.full(part.stop - part.start, part.phase, dtype="<U10") for part in kept])
    return segments_of_phase(labels)


def motionless(t: Array, segments: tuple[Segment, ...]) -> Bools:
    """(N,), rows of the holds without their first and last moments."""
    mask = np.zeros(len(t), dtype=bool)
    for part in segments:
        if part.is_hold:
            first, last = t[part.start], t[part.stop - 1]
            settled = t[part.rows] - first >= min(SETTLING_S, 0.25 * (last - first))
            mask[part.rows] = settled & (last - t[part.rows] >= min(LEAVING_S, 0.1 * (last - first)))
    return mask


def smooth_by_average(x: Array, samples: int) -> Array:
    """Centred moving average along the first axis, as if the first and the last sample had been there for ever."""
    samples = max(1, samples)
    before, after = samples // 2, samples - 1 - samples // 2
    total = np.cumsum(np.pad(x, [(before + 1, after)] + [(0, 0)] * (x.ndim - 1), mode="edge"), axis=0)
    return np.asarray((total[samples:] - total[:-samples]) / samples)


def hold_label(g: Array) -> str:
    """Of a hold with gravity (N, 3) or (3,) in the sensor frame."""
    mean = np.atleast_2d(g).mean(axis=0)
    direction = mean / np.linalg.norm(mean)
    axis = int(np.argmax(np.abs(direction)))
    if abs(direction[axis]) < ALONG_AXIS:
        return "hold:free"
    return f"hold:{'xyz'[axis]}{'+' if direction[axis] > 0 else '-'}"


def _motion_label(omega: Array, speed: Array) -> str:
    power = (omega**2).sum(axis=0)
    axis = int(np.argmax(power))
    pure = power[axis] >= ALONG_AXIS**2 * power.sum()
    in_place = speed.max() < 0.02
    return f"rotate:{'xyz'[axis]}" if pure and in_place else "transfer"
