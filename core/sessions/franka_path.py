"""Joint positions as Franka's motion generator takes them: what it refuses, how lost commands are made up for, how to brake.

A controller differentiates the commanded positions by backward differences over its period of 1 ms and ends the motion where speed,
acceleration or jerk is beyond its limits. In the place of a command that it has not in time it puts one of the same acceleration, and
tells in its next state where it has come to (the maker's documentation of libfranka: overview, interface specifications).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.errors import TooFast
from core.sessions.franka_messages import PERIOD

PANDA, RESEARCH_3 = "Panda", "Franka Research 3"
ACCELERATION = {PANDA: (15.0, 7.5, 10.0, 12.5, 15.0, 20.0, 20.0), RESEARCH_3: (10.0,) * 7}
"""Limits of the joint motion generator, rad/s2."""
JERK = {PANDA: (7500.0, 3750.0, 5000.0, 6250.0, 7500.0, 10000.0, 10000.0), RESEARCH_3: (5000.0,) * 7}
"""rad/s3."""
SHARE = 0.9
"""Of the limits that braking uses."""
BACK_PER_S = 20.0
"""How fast a difference from the path goes back: it halves some eight times a second, without a swing."""
NOTHING_RAD = 1e-9
"""A difference from the path that is none."""


def make_of(version: int) -> str:
    """Whose limits hold: up to version 5 the server is a Panda's (libfranka's table of compatible versions)."""
    return PANDA if version <= 5 else RESEARCH_3


class Steps:
    """The last positions of a path, as backward differences.

    Args:
        q, dq, ddq: (n,), rad, rad/s, rad/s2.
    """

    def __init__(self, q: Array, dq: Array | None = None, ddq: Array | None = None) -> None:
        self.q = q
        self.dq = np.zeros(len(q)) if dq is None else dq
        self.ddq = np.zeros(len(q)) if ddq is None else ddq

    def next(self, q: Array) -> Steps:
        """One period later at q."""
        dq = (q - self.q) / PERIOD
        return Steps(q, dq, (dq - self.dq) / PERIOD)

    @property
    def rests(self) -> bool:
        """Whether it moves no more."""
        return bool(np.abs(self.dq).max() < 1e-9 and np.abs(self.ddq).max() < 1e-6)


class Envelope(NamedTuple):
    """Joint limits of a controller, (7,) each: where the arm comes near the end of a joint it may go only so fast as it can still brake
    (`position_based_velocity_limits` of its description).

    Args:
        lower, upper: rad. velocity: rad/s.
        offset, deceleration: rad/s and rad/s2; None where the speed may be the same everywhere.
    """

    lower: Array
    upper: Array
    velocity: Array
    offset: Array | None
    deceleration: Array | None

    def fastest(self, q: Array) -> tuple[Array, Array]:
        """Speeds (7,) at joint positions q (7,), down and up, rad/s; both positive."""
        if self.offset is None or self.deceleration is None:
            return self.velocity, self.velocity
        down, up = (
            np.clip(np.sqrt(2.0 * self.deceleration * np.maximum(left, 0.0)) - self.offset, 0.0, self.velocity)
            for left in (q - self.lower, self.upper - q)
        )
        return down, up


class Smoothness:
    """What the joint motion generator takes, beside positions.

    Args:
        names: of the joints. make: see `make_of`. envelope: None where the controller does not say.
    """

    def __init__(self, names: Sequence[str], make: str, envelope: Envelope | None) -> None:
        self._names, self._envelope = tuple(names), envelope
        self.acceleration, self.jerk = np.array(ACCELERATION[make]), np.array(JERK[make])

    def check(self, before: Steps, now: Steps) -> None:
        """Nothing where the controller takes the step from one to the other: what it does not it would end the motion for.

        Raises:
            TooFast: it does not.
        """
        jerk = np.abs(now.ddq - before.ddq) / PERIOD
        checks = [("franka-acceleration", np.abs(now.ddq), self.acceleration), ("franka-jerk", jerk, self.jerk)]
        if self._envelope is not None:
            down, up = self._envelope.fastest(before.q)
            checks.insert(0, ("franka-speed", np.abs(now.dq), np.where(now.dq < 0.0, down, up)))
        for code, found, limit in checks:
            j = int(np.argmax(found - limit))
            if found[j] > limit[j]:
                raise TooFast(code, value=float(found[j]), limit=float(limit[j]), joint=self._names[j])


class Difference:
    """What the arm is beside the path, because its controller went on by itself: it goes back to zero smoothly.

    Third order with one triple pole, integrated as the controller differentiates: position, speed and acceleration have no step.
    """

    def __init__(self, n: int) -> None:
        self._o, self._v, self._a = np.zeros((3, n))
        self.any = False
        """Whether there is one."""

    def set(self, sent: Steps, path: Steps) -> None:
        """From now on what lies between the two."""
        self._o, self._v, self._a = sent.q - path.q, sent.dq - path.dq, sent.ddq - path.ddq
        self.any = True

    def next(self) -> Array | float:
        """(n,), rad, a period later; 0 where there is none."""
        if not self.any:
            return 0.0
        w = BACK_PER_S
        self._a = self._a - PERIOD * (3.0 * w * self._a + 3.0 * w**2 * self._v + w**3 * self._o)
        self._v = self._v + PERIOD * self._a
        self._o = self._o + PERIOD * self._v
        self.any = bool(max(np.abs(self._o).max(), np.abs(self._v).max() * PERIOD, np.abs(self._a).max() * PERIOD**2) > NOTHING_RAD)
        return self._o


def braking_path(begin: Steps, acceleration: Array, jerk: Array) -> Array:
    """Commands that take a moving arm to standstill, all joints at the same time, within limits of acceleration and jerk.

    First the acceleration of now goes to zero, as fast as the jerk allows, then the speed shrinks and keeps its direction, as in
    `core.plant.braking`, with corners rounded over a few periods.

    Args:
        begin: the last command.
        acceleration, jerk: (n,), rad/s2 and rad/s3.

    Returns:
        (K, n), one row per coming period; the last rows are equal.
    """
    ease = max(1, math.ceil(float(np.max(np.abs(begin.ddq) / jerk)) / PERIOD))
    shares = 1.0 - np.arange(1, ease + 1) / ease
    speeds = begin.dq + PERIOD * np.cumsum(shares)[:, None] * begin.ddq
    fastest = speeds[-1]
    if float(np.abs(fastest).max()) > 0.0:
        m = max(1, math.ceil(float(np.max(np.abs(fastest) / acceleration)) / PERIOD))
        # the speed falls by |fastest| / m per period: what that is as an acceleration may change by the jerk in each period
        r = max(1, math.ceil(float(np.max(np.abs(fastest) / (m * PERIOD**2) / jerk))))
        falls = np.convolve(np.full(m, 1.0 / m), np.full(r, 1.0 / r))
        left = 1.0 - np.cumsum(falls)
        left[-1] = 0.0
        speeds = np.concatenate((speeds, left[:, None] * fastest))
    speeds = np.concatenate((speeds, np.zeros((2, speeds.shape[1]))))
    return np.asarray(begin.q + PERIOD * np.cumsum(speeds, axis=0))
