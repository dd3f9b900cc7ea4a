"""A timed sequence of joint positions, sampled at the control period."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class JointTrajectory:
    """Joint positions at constant period, starting and ending at rest.

    Args:
        period: s.
        q: (N, n), rad; row k is the position at `k * period`.
    """

    period: float
    q: NDArray[np.float64]

    @property
    def duration(self) -> float:
        """s."""
        return self.period * (len(self.q) - 1)

    @property
    def t(self) -> NDArray[np.float64]:
        """(N,), s."""
        return np.asarray(self.period * np.arange(len(self.q)), dtype=np.float64)

    def __len__(self) -> int:
        return len(self.q)


AT_START = 1e-9
"""rad and rad/s: what rounding may leave of a profile that is back where it began."""


@dataclass(frozen=True)
class AngularProfile:
    """The task of a decoupling motion: rotation about one sensor axis through the sensor origin, at constant period.

    Args:
        period: s.
        angle: (N,), rad, relative to the start configuration; starts at 0.
        rate: (N,), rad/s, derivative of `angle`; starts and ends at 0.
    """

    period: float
    angle: NDArray[np.float64]
    rate: NDArray[np.float64]

    @property
    def duration(self) -> float:
        """s."""
        return self.period * (len(self.angle) - 1)

    @property
    def rests(self) -> NDArray[np.intp]:
        """Samples at which it has come back to where it began, at rest, the last one included: where a repetition ends."""
        back = (np.abs(self.angle) < AT_START) & (np.abs(self.rate) < AT_START)
        return np.flatnonzero(back[1:]) + 1

    def cut(self, samples: int) -> AngularProfile:
        """The profile up to one of its `rests`."""
        angle, rate = self.angle[: samples + 1].copy(), self.rate[: samples + 1].copy()
        angle[-1] = rate[-1] = 0.0  # what rounding leaves
        return AngularProfile(self.period, angle, rate)

    def repeat(self, times: int) -> AngularProfile:
        """The profile that often, one after the other."""
        angle, rate = (np.concatenate((np.tile(each[:-1], times), each[-1:])) for each in (self.angle, self.rate))
        return AngularProfile(self.period, angle, rate)
