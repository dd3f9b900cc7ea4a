"""Creep that slows down without an end, as glue and plastics do: by a power of time after each step of load, and still from before."""

from __future__ import annotations

import math

import numpy as np

from core.array import Array
from core.effects.channels import amplitudes, expand_to_channels, shares
from core.effects.effect import Parameter
from core.effects.filters import low_pass
from core.effects.scene import Scene
from core.effects.sensor_creep import SensorCreep
from core.words.message import Message

TIME_CONSTANTS_S = np.geomspace(0.02, 2000.0, 13)
"""Of the first-order lags that stand for the power: 2.4 of them for each decade."""
UNIT_S = 60.0
"""Shares are what has crept after so long."""
EXPONENTS = (0.15, 0.35)
"""To start from; of glued strain gauges, 0.1 to 0.4."""


class CreepByPowerOfTime(SensorCreep):
    """`W = w + K (f * w') + A (1 - g)`, `f = (t / 60 s)^n` (Findley's law), as a sum of first-order lags whose weights go as their time
    constants to the n; what still creeps from a load before the first row follows the same law from there on, to A after a minute."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Shares of the load that have crept after a minute (6), how many times as much after ten, `10^n`, and what creeps from before (6),
        N and N m."""
        return (
            *shares("creep_share", lower=-0.2, upper=0.2, scale=0.005),
            Parameter("ten_minutes_ratio", "1", 10.0**0.25, 10.0**0.03, 10.0**0.9, 0.6),
            *amplitudes("remaining", bound=expand_to_channels(20.0, 1.0), scale=expand_to_channels(0.3, 0.015)),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus what has crept by then."""
        weights = _weigh_lags(math.log10(theta[6]))
        crept, before = np.zeros_like(w), np.zeros(len(w))
        for k, (weight, tau) in enumerate(zip(weights, TIME_CONSTANTS_S, strict=True)):
            crept += weight * low_pass(w, tau, scene.period, scene.past(f"creep {k}"))
            before -= weight * np.expm1(-scene.elapsed / tau)
        return np.asarray(w + theta[:6] * crept + np.multiply.outer(before, theta[7:]))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Creep of 0.2 % after a minute in all channels, two exponents, nothing from before."""
        return [np.concatenate((np.full(6, 0.002), [10.0**exponent], np.zeros(6))) for exponent in EXPONENTS]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """As of one time constant: of what has crept after ten minutes half came within the first."""
        return super().advice(scene, np.append(theta[:6], UNIT_S))


def _weigh_lags(exponent: float) -> Array:
    """Of the lags: `t^n` is `n / Gamma(1 - n)` times the integral of `T^n (1 - exp(-t / T))` over the logarithm of T; what is quicker than
    the first of them is a gain."""
    between = np.log(TIME_CONSTANTS_S[1] / TIME_CONSTANTS_S[0])
    return np.asarray(exponent / math.gamma(1.0 - exponent) * between * (TIME_CONSTANTS_S / UNIT_S) ** exponent)
