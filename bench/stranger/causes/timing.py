"""Wrench and joints are not of the same time: delays and filters of either."""

from __future__ import annotations

import numpy as np
from scipy import signal

from bench.stranger.array import Array
from bench.stranger.draws import draw_log
from bench.stranger.fault import Fault
from bench.stranger.rig import Rig
from bench.stranger.signals import STEP_S, draw_wander, filter_from_rest, lag_once, lag_twice


def delay(rng: np.random.Generator, _: Rig) -> Fault:
    """By 12 to 35 ms."""
    by_s = draw_log(rng, 0.012, 0.035)
    return Fault(
        family="time_delay",
        variant="constant transport delay",
        size=lambda scale: {"delay_s": by_s * scale},
        shift_times=lambda times, scale: times - by_s * scale,
        limits=(0.3, 3),
    )


def delay_unsteadily(rng: np.random.Generator, rig: Rig) -> Fault:
    """By a time that wanders and jumps back."""
    by_s = draw_log(rng, 0.015, 0.03)
    wander = draw_wander(rng, rig.t, rig.seconds, 1, 1.0)[:, 0]
    wander = (wander - wander.mean()) / np.ptp(wander)
    saw = signal.sawtooth(2 * np.pi * rig.t / rng.uniform(7, 13))

    def shift(times: Array, scale: float) -> Array:
        share = 1 + 0.5 * np.interp(times, rig.t, wander) + 0.2 * np.interp(times, rig.t, saw)
        return np.asarray(times - by_s * scale * share)

    return Fault(
        family="time_delay",
        variant="delay that wanders and has a saw-tooth of two unsynchronised clocks",
        size=lambda scale: {"mean_s": by_s * scale, "range_s": by_s * scale * 0.9},
        shift_times=shift,
        limits=(0.3, 3),
    )


def filter_by_bessel(rng: np.random.Generator, _: Rig) -> Fault:
    """Of fourth order."""
    corner_hz = draw_log(rng, 3.0, 6)

    def smooth(W: Array, scale: float) -> Array:
        b, a = signal.bessel(4, min(corner_hz / scale, 200), fs=1 / STEP_S, norm="mag")
        return filter_from_rest(b, a, W)

    return Fault(
        family="sensor_lowpass",
        variant="4th order Bessel filter in the sensor's electronics",
        size=lambda scale: {"fc_hz": corner_hz / scale},
        put_out=smooth,
        limits=(0.3, 4),
    )


def average(rng: np.random.Generator, _: Rig) -> Fault:
    """Over the last 60 to 120 ms."""
    window_s = draw_log(rng, 0.06, 0.12)

    def smooth(W: Array, scale: float) -> Array:
        n = max(3, int(window_s * scale / STEP_S))
        total = np.vstack([np.repeat(W[:1], n, 0), W]).cumsum(0)
        return np.asarray((total[n:] - total[:-n]) / n)

    return Fault(
        family="sensor_lowpass",
        variant="moving average in the sensor (causal box)",
        size=lambda scale: {"window_s": window_s * scale},
        put_out=smooth,
        limits=(0.3, 4),
    )


def filter_torques_more(rng: np.random.Generator, _: Rig) -> Fault:
    """Two lags behind each other."""
    first_s, second_s = draw_log(rng, 0.015, 0.03), draw_log(rng, 0.01, 0.02)

    def smooth(W: Array, scale: float) -> Array:
        force = lag_once(lag_once(W[:, :3], first_s * scale), second_s * scale)
        torque = lag_once(lag_once(W[:, 3:], 1.4 * first_s * scale), second_s * scale)
        return np.hstack([force, torque])

    return Fault(
        family="sensor_lowpass",
        variant="two cascaded first-order filters, torques slower than forces",
        size=lambda scale: {
            "tau_force_s": [first_s * scale, second_s * scale],
            "tau_torque_s": [1.4 * first_s * scale, second_s * scale],
        },
        put_out=smooth,
        limits=(0.3, 4),
    )


def observe_joints_late(rng: np.random.Generator, rig: Rig) -> Fault:
    """The joints are reported through an observer."""
    tau_s = draw_log(rng, 0.02, 0.035)
    return Fault(
        family="kinematic_lag",
        variant="joint positions reported through a second-order observer (critically damped)",
        size=lambda scale: {"tau_s": tau_s * scale, "note": "delay about tau_s"},
        report_joints=lambda scale: lag_twice(rig.q, 2 / (2 * np.pi * tau_s * scale)),
        limits=(0.3, 3),
    )
