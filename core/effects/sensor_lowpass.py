"""A filter inside the sensor or its amplifier smooths the wrench."""

from __future__ import annotations

import cmath
import math

import numpy as np

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.excitation import stillness
from core.effects.filters import low_pass
from core.effects.scene import Scene
from core.words.message import Message


class SensorLowpass(Effect):
    """`W = w / (1 + tau s + kappa (tau s)^2)`.

    `kappa = 0` is the first order with corner frequency `1 / (2 pi tau)`, 1/4 two equal poles, 1/2 a Butterworth filter of second order;
    slow signals are late by `tau` whatever `kappa` is. Computed as two poles in a row, complex ones for `kappa > 1/4`.
    """

    id = "sensor_lowpass"
    title = Message.of("effect-sensor-lowpass-title")
    stage = "timing"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Time constant tau, s, and kappa, the share of second order."""
        return (Parameter("time_constant_s", "s", 0.0, 0.0, 0.2, 0.03), Parameter("second_order_share", "1", 0.0, 0.0, 0.7, 0.3))

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w / (1 + tau s + kappa (tau s)^2)`, as two poles in a row."""
        tau, kappa = theta
        root = cmath.sqrt(1 - 4 * kappa)
        slow, fast = tau * (1 + root) / 2, tau * (1 - root) / 2
        if not root.imag:
            slow, fast = slow.real, fast.real
        once = low_pass(w, slow, scene.period, scene.past("slow pole"))
        return np.ascontiguousarray(low_pass(once, fast, scene.period, scene.past("fast pole")).real)

    def explain_absence(self, scene: Scene) -> Message | None:
        """A reason where the sensor stays still: a filter shows only while loads change."""
        return stillness(scene)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Corners of 8, 20 and 3 Hz nearly of first order, and of 8 Hz nearly as Butterworth's."""
        return [
            np.array([1 / (2 * math.pi * cutoff_hz), kappa]) for cutoff_hz, kappa in ((8.0, 0.05), (20.0, 0.05), (3.0, 0.05), (8.0, 0.45))
        ]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises switching the filter off or raising it above its corner, Hz, with its delay in ms."""
        cutoff_hz = 1 / (2 * math.pi * max(float(theta[0]), 1e-6))
        return Message.of("advice-sensor-lowpass", cutoff_hz=cutoff_hz, delay_s=theta[0])
