"""Readings are clipped where load and offset come to a limit together: with a large offset that may be far from it with the load alone."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import SUFFIXES, say_load
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_saturation import SensorSaturation, find_limits
from core.payload.channels import CHANNELS, UNITS
from core.words.message import Message

CUTS = np.linspace(0.02, 0.92, 16)
"""Shares of a channel's whole change of load in a run, behind which limits are looked at before a fit."""
MOST, FAR = 0.97, 0.5
"""Of them that may be cut off, and how far off a limit is that no load reaches: what is clipped hides how far the load really goes."""
SIGN = 0.1
"""Share of the residual that the first limit has to explain."""


class SaturationWithOffset(SensorSaturation):
    """`W = clip(w, low, high)` for each channel, the limits anywhere in what the load goes through: a channel that an offset brings near
    the end of its range may be clipped before its load is zero."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Six upper limits of the load, then six lower ones, N and N m, each absent far beyond what this run goes through."""
        high, low = scene.nominal.max(axis=0), scene.nominal.min(axis=0)
        span = np.maximum(high - low, 1e-6)
        upper, lower = (high - MOST * span, high + FAR * span), (low - FAR * span, low + MOST * span)
        limits = [("upper", *each) for each in zip(CHANNELS, SUFFIXES, UNITS, upper[1], *upper, span, strict=True)]
        limits += [("lower", *each) for each in zip(CHANNELS, SUFFIXES, UNITS, lower[0], *lower, span, strict=True)]
        return tuple(
            Parameter(f"{channel}_{side}_limit_{suffix}", unit, float(absent), float(least), float(most), float(FAR * size))
            for side, channel, suffix, unit, absent, least, most, size in limits
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`clip(w, low, high)`."""
        return np.clip(w, theta[6:], theta[:6])

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The limits whose missing load looks most like the residual; none where no load is missing."""
        seen = find_limits(scene, residual, lambda x: float(x.max()) - CUTS * float(np.ptp(x)), SIGN)
        theta = np.array([p.absent for p in self.parameters(scene)])
        for k, limit in seen:
            theta[k] = limit if k < 6 else -limit
        return [theta] if seen else []

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises a larger range or a lighter payload, with the limit behind which most is cut off and the load of the run, N or N m."""
        high, low = scene.nominal.max(axis=0), scene.nominal.min(axis=0)
        cut = np.concatenate((high - theta[:6], theta[6:] - low)) / np.tile(np.maximum(high - low, 1e-9), 2)
        k = int(cut.argmax())
        channel, limit = k % 6, say_load(float(theta[k]), k % 6)
        needed = say_load(float(np.abs(scene.nominal[:, channel]).max()), channel)
        if k < 6:
            return Message.of("advice-sensor-saturation-above", channel=CHANNELS[channel], clipped_at=limit, needed=needed)
        return Message.of("advice-sensor-saturation-below", channel=CHANNELS[channel], clipped_at=limit, needed=needed)
