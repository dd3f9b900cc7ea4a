"""What the sensor reads depends on what was before: hysteresis and creep."""

from __future__ import annotations

import numpy as np
from scipy.signal import lfilter

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import follow_dahl, lag

RELAYS_EVERY, DAHL_EVERY = 40, 10
"""Steps of the grid."""


def hyst_preisach(_: np.random.Generator, rig: Rig) -> Fault:
    """Relays, most of them narrow."""
    most = np.maximum(np.abs(rig.load).max(0) * 1.1, 1e-6)
    share = np.array([1, 1, 1, 0.8, 0.8, 0.8])
    memory = np.zeros_like(rig.load)
    for i in range(6):
        y = _switch_relays(rig.load[::RELAYS_EVERY, i] / most[i])
        y = lfilter([0.3], [1, -0.7], y - y[0])
        memory[:, i] = np.interp(rig.t, rig.t[::RELAYS_EVERY], y) * most[i]
    return Fault(
        size=lambda scale: Size("Preisach relays: half opening over range", scale, "% of peak load"),
        distort=lambda W, scale: W + 0.01 * scale * memory * share,
    )


def _switch_relays(x: Array) -> Array:
    """(N,), the weighted sum of relays that switch up and down at thresholds between -1 and 1, along a signal (N,)."""
    thresholds = (np.arange(36) + 0.5) / 36 * 2 - 1
    up, down = np.meshgrid(thresholds, thresholds)
    up, down = up[up > down], down[up > down]
    weights = np.exp(-(((up - down) / 0.9) ** 2))
    weights /= weights.sum()
    state = np.where((up + down) > 0, -1.0, 1.0)
    y = np.empty(len(x))
    for i, value in enumerate(x):
        state[value >= up] = 1
        state[value <= down] = -1
        y[i] = weights @ state
    return y


def hyst_dahl(_: np.random.Generator, rig: Rig) -> Fault:
    """A bolted joint of the sensor slips."""
    most = np.maximum(np.abs(rig.load).max(0), 1e-6)
    share = np.array([1, 0.7, 1.2, 0.9, 1, 0.6])
    slip = np.zeros_like(rig.load)
    for i in range(6):
        y = follow_dahl(np.diff(rig.load[::DAHL_EVERY, i] / most[i]), 0.25)
        slip[:, i] = np.interp(rig.t, rig.t[::DAHL_EVERY], y) * most[i]
    return Fault(
        size=lambda scale: Size("Dahl slip in bolted joint of the sensor, half opening", scale, "% of peak load"),
        distort=lambda W, scale: W + 0.01 * scale * slip * share,
    )


def creep_sum(_: np.random.Generator, rig: Rig) -> Fault:
    """With four time constants."""
    lags = zip([0.30, 0.28, 0.24, 0.18], [0.6, 2.5, 9.0, 35.0], strict=True)
    crept = sum((part * lag(rig.load, tau_s) for part, tau_s in lags), np.zeros_like(rig.load))
    share = np.array([1.1, 0.9, 1, 0.8, 1, 1.2])
    return Fault(
        size=lambda scale: Size("creep over four decades-like time constants", scale, "% of load"),
        distort=lambda W, scale: W + 0.01 * scale * share * crept,
    )
