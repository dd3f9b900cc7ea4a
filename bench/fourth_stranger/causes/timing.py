"""Wrench and motion are not of one instant: a queue that traffic fills, a filter with ripple, joints that are smoothed by their speed."""

from __future__ import annotations

import numpy as np
from scipy.signal import cheby1, lfilter, lfilter_zi

from bench.fourth_stranger.draws import find_speed_of_joints
from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import STEP_S, derive, lag


def delay_traffic(_: np.random.Generator, rig: Rig) -> Fault:
    """The wrench waits in a queue that is fuller while the arm moves and everybody talks."""
    traffic = lag(find_speed_of_joints(rig)[:, None], 0.6)[:, 0]
    traffic = traffic / traffic.max()
    return Fault(
        size=lambda scale: Size("delay at rest, up to four tenths more in the traffic of quick moves", 16 * scale, "ms"),
        delay=lambda t, scale: 0.016 * scale * (1 + 0.4 * np.interp(t, rig.t, traffic)),
    )


def lp_chebyshev(_: np.random.Generator, __: Rig) -> Fault:
    """The sensor's filter is a Chebyshev one of third order, with 2 dB of ripple."""

    def follow(W: Array, scale: float) -> Array:
        b, a = cheby1(3, 2, min(6 / scale, 0.3 / STEP_S), fs=1 / STEP_S)
        state = lfilter_zi(b, a)[:, None] * W[0]
        return np.asarray(lfilter(b, a, W, axis=0, zi=state)[0])

    return Fault(size=lambda scale: Size("Chebyshev filter of third order, 2 dB, edge", 6 / scale, "Hz"), distort=follow)


def kin_oneeuro(_: np.random.Generator, __: Rig) -> Fault:
    """The joints are smoothed by a 1-euro filter before they are recorded: the slower a joint turns, the later it is."""

    def smooth(q: Array, scale: float) -> Array:
        corners = (5.0 + 4.0 * np.abs(lag(derive(q), 0.03))) / scale
        y, smoothed = q[0].copy(), np.empty_like(q)
        for i, share in enumerate(1 - np.exp(-2 * np.pi * corners * STEP_S)):
            y = y + share * (q[i] - y)
            smoothed[i] = y
        return smoothed

    return Fault(size=lambda scale: Size("joints by a 1-euro filter, corner at rest", 5 / scale, "Hz"), report_joints=smooth)
