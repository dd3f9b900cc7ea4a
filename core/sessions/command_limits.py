"""Which commands no robot can carry out in one period."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.array import Array
from core.errors import BadState, OutOfLimits, TooFast

TOLERANCE = 1.05
"""A command may ask for this much more than the joint's velocity limit."""


class CommandLimits:
    """The limits of commanded joint positions.

    Args:
        names: of the n joints.
        lower, upper: (n,), rad.
        velocity: (n,), rad/s.
        period: of the control, s.
    """

    def __init__(self, names: Sequence[str], lower: Array, upper: Array, velocity: Array, period: float) -> None:
        self._names, self._lower, self._upper, self._velocity, self._period = tuple(names), lower, upper, velocity, period
        self._step = TOLERANCE * period * velocity

    def check(self, q: Array, now: Array) -> None:
        """Nothing where the joints can come from the present command `now` (n,) to q within a period, rad.

        Raises:
            BadState: q is not n finite numbers.
            OutOfLimits: q is outside the joint limits.
            TooFast: q is too far away.
        """
        if q.shape != now.shape or not np.isfinite(q).all():
            wrong = int(np.count_nonzero(~np.isfinite(q)))
            raise BadState(
                "session-command-not-finite", value=float(wrong), limit=0.0, count=q.size, not_finite=wrong, joints=len(self._names)
            )
        step = np.abs(q - now)
        outside = (q < self._lower) | (q > self._upper)
        if outside.any():
            j = int(np.argmax(outside))
            limit = float(np.clip(q[j], self._lower[j], self._upper[j]))
            raise OutOfLimits("session-command-out-of-limits", value=float(q[j]), limit=limit, joint=self._names[j])
        if (step > self._step).any():
            j = int(np.argmax(step / self._step))
            speed, limit = float(step[j] / self._period), float(self._velocity[j])
            raise TooFast("session-command-too-far", value=speed, limit=limit, joint=self._names[j], step_rad=float(step[j]))
