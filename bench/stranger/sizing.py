"""How much of a cause is to be seen beside the noise once the best rigid payload is taken off, and the scale at which that is neither too
little nor too much."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from bench.stranger.array import Array
from bench.stranger.fault import Fault, Planted
from bench.stranger.rig import Rig
from bench.stranger.rigid_body import find_regressor
from bench.stranger.sensing import find_reported_kinematics, predict, sense

TRIES = 4


class Yardstick:
    """Measures differences of a rig's wrench, in noise standard deviations, beside all that ten payload parameters and six offsets make."""

    def __init__(self, rig: Rig) -> None:
        """Of a rig as it is without a cause."""
        self.rig = rig
        self._explained = self._span([])
        self._of_background = sense(rig, []) - predict(rig, [])
        self.background = self.project(self._of_background)
        """(6 M,), what the background leaves."""

    def measure(self, planted: Sequence[Planted]) -> Array:
        """(6 M,), what the causes leave beyond the background."""
        difference = sense(self.rig, planted) - predict(self.rig, planted) - self._of_background
        if all(fault.report_joints is None for fault, _ in planted):
            return self.project(difference)
        return _take_off(self._whiten(difference), self._span(planted))

    def project(self, difference: Array) -> Array:
        """(6 M,), of a difference (M, 6), N and N m."""
        return _take_off(self._whiten(difference), self._explained)

    def _whiten(self, difference: Array) -> Array:
        return np.asarray((difference / self.rig.sensor.noise_std).reshape(-1))

    def _span(self, planted: Sequence[Planted]) -> Array:
        """(6 M, 16), an orthonormal basis of what payload and offsets can make."""
        k = self.rig.feel(find_reported_kinematics(self.rig, planted))
        Y = (find_regressor(k) / self.rig.sensor.noise_std[None, :, None]).reshape(-1, 16)
        return np.asarray(np.linalg.qr(Y / np.linalg.norm(Y, axis=0))[0])


def find_rms(difference: Array) -> float:
    """Of a difference (6 M,)."""
    return float(np.sqrt(np.mean(difference**2)))


def find_scale(yardstick: Yardstick, fault: Fault) -> tuple[float, Array]:
    """The scale, and what is to be seen (6 M,) at it: 1 where that is as wanted, else what brings it there, within the fault's limits."""
    low, high = fault.wanted
    scale = 1.0
    seen = yardstick.measure([Planted(fault, scale)])
    for _ in range(0 if fault.fixed else TRIES):
        rms = find_rms(seen)
        if low <= rms <= high:
            break
        aim = 1.2 * low if rms < low else 0.85 * high
        better = float(np.clip(scale * aim / max(rms, 1e-9), *fault.limits))
        if abs(better - scale) < 1e-6:
            break
        scale = better
        seen = yardstick.measure([Planted(fault, scale)])
    return scale, seen


def _take_off(y: Array, Q: Array) -> Array:
    return np.asarray(y - Q @ (Q.T @ y))
