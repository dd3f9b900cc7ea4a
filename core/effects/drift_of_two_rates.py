"""The offset drifts in two ways at once: electronics that warm up within seconds, a body that does within minutes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_drift import SensorDrift, settling
from core.effects.vectors import add_course

RATES = ((0.02, 0.3), (0.05, 0.6), (0.005, 0.1))
"""Pairs of settling rates to start from, 1/s."""


class DriftOfTwoRates(SensorDrift):
    """`W = w + sum_k A_k (1 - exp(-k t)) / (1 - exp(-k 60 s))` with two rates, beside what goes with the temperature."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of the drift, then six amplitudes and the rate of the second."""
        one = super().parameters(scene)
        second = (replace(p, name=_name_second(p.name)) for p in one[:7])
        return (*one, *second)

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus both drifts."""
        one, second = theta[:-7], theta[-7:]
        return np.asarray(add_course(super().wrench(scene, w, one), settling(scene.elapsed, second[6]), second[:6]))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Amplitudes by the signs of the residual's change, as for one drift, with some pairs of rates."""
        one = SensorDrift().starts(scene, residual)[0]
        return [np.concatenate((one[:6], [slow], one[7:], np.zeros(6), [fast])) for slow, fast in RATES]

    def find_drift(self, scene: Scene, theta: Array) -> Array:
        """Of both rates together."""
        seconds = np.array([float(scene.t[-1] - scene.t[0])])
        return super().find_drift(scene, theta[:-7]) + theta[-7:-1] * settling(seconds, theta[-1])


def _name_second(name: str) -> str:
    """`fx_first_minute_n` becomes `mode_2_first_minute_fx_n`."""
    if name == "settling_rate_per_s":
        return f"mode_2_{name}"
    channel, what, unit = name.split("_", 1)[0], *name.split("_", 1)[1].rsplit("_", 1)
    return f"mode_2_{what}_{channel}_{unit}"
