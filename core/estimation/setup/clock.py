"""Whether a recording's clock can be right: speeds that no robot has, velocities that are not the positions' derivative."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.estimation.setup.units import TIME_UNITS
from core.recording.recording import Recording
from core.words.message import Message

FASTEST_RAD_S = 40.0
SLOWEST_RAD_S = 2e-3
"""A path that is sampled finely and is never faster than this takes hours: no robot's."""
SHORTEST_PERIOD_S = 2e-5
LIKELY_PERIOD_S = (2e-4, 0.2)
FEWEST_ROWS = 200
FINE_RAD = 0.05
SMALLEST_STRETCH = 1.2
CLOSE = 0.06
SLOW_RATE_S = 0.15
"""Longest period at which accelerations can still be told."""


def check_clock(recording: Recording) -> Message | None:
    """What contradicts the clock, with the unit that would not."""
    angles = _angles(recording)
    if angles is None or len(recording) < FEWEST_ROWS:
        return None
    dt = np.diff(recording.t)
    period = float(np.median(dt))
    if period < SHORTEST_PERIOD_S:
        return Message.of("setup-clock-too-fine", rate_hz=1.0 / period)
    steps = np.abs(np.diff(angles, axis=0)).max(axis=1)
    fast = float(np.percentile(steps / dt, 99))
    moving = steps[steps > 1e-3 * steps.max(initial=0.0)]
    fine = len(moving) > 0 and float(np.median(moving)) < FINE_RAD
    if fine and fast > FASTEST_RAD_S:
        return Message.of("setup-speeds-too-high", speed_rad_s=fast)
    if fine and fast < SLOWEST_RAD_S and period > LIKELY_PERIOD_S[1] and float(np.ptp(angles, axis=0).max()) > 0.2:
        units = [unit for unit, k in TIME_UNITS.items() if LIKELY_PERIOD_S[0] < period / k < LIKELY_PERIOD_S[1] and k > 1.0]
        return Message.of("setup-speeds-too-low", speed_rad_s=fast, lasts_s=float(recording.t[-1] - recording.t[0]), units=units)
    return _check_velocities(recording)


def _angles(recording: Recording) -> Array | None:
    """What changes by radians: joints, or entries of the rotation, which change by as much at most."""
    if recording.q is not None:
        return recording.q
    return None if recording.orientation is None else recording.orientation.reshape(len(recording), 9)


def _check_velocities(recording: Recording) -> Message | None:
    """Recorded velocities against differences of the positions: their ratio is the clock's."""
    if recording.q is None or recording.dq is None:
        return None
    half = np.diff(recording.q, axis=0) / np.diff(recording.t)[:, None]
    meant = 0.5 * (recording.dq[1:] + recording.dq[:-1])
    power = float((meant * meant).sum())
    if power == 0.0 or float(np.abs(meant).max()) < 0.01:
        return None
    ratio = float((half * meant).sum()) / power
    left = float(((half - ratio * meant) ** 2).sum()) / max(float((half**2).sum()), 1e-300)
    if ratio <= 0.0 or left > 0.1 or 1.0 / SMALLEST_STRETCH < ratio < SMALLEST_STRETCH:
        return None
    if abs(ratio * np.degrees(1.0) - 1.0) < CLOSE:
        return None  # velocities in degrees, which nothing here uses
    unit = next((name for name, k in TIME_UNITS.items() if abs(ratio * k - 1.0) < CLOSE), None)
    if unit is not None:
        return Message.of("setup-velocities-say", slip=Message.of("setup-time-in", unit=unit))
    code = "setup-clock-slow" if ratio > 1.0 else "setup-clock-fast"
    return Message.of("setup-velocities-say", slip=Message.of(code, times=max(ratio, 1.0 / ratio)))


def remark_on_rate(recording: Recording) -> Message | None:
    """A motion that is sampled too slowly to show accelerations."""
    if recording.phase is None or len(recording) < 5:
        return None
    period = float(np.median(np.diff(recording.t)))
    moving = ~np.char.startswith(recording.phase, "hold")
    if period < SLOW_RATE_S or float(moving.mean()) < 0.2:
        return None
    return Message.of("setup-sampled-slowly", rate_hz=1.0 / period)
