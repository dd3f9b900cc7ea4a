"""What the sensor reads depends on what was before: bolts that slip sideways, a creep that goes faster than it comes."""

from __future__ import annotations

import numpy as np

from bench.fourth_stranger.draws import spread_over_grid, step_of
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig

EVERY, COARSE = 10, 50
"""Steps of the grid."""
COMING_S, GOING_S = 34.0, 15.0


def hyst_bolts(_: np.random.Generator, rig: Rig) -> Fault:
    """The sensor's bolts are not tight: its face slips sideways, whichever way it is pulled, and bends what hangs on it a little."""
    most = float(np.max(np.linalg.norm(rig.load[:, :2] - rig.load[:, :2].mean(0), axis=1)))
    reach, stuck = 0.3, np.zeros(2)
    steps = np.diff(rig.load[::EVERY, :2] / most, axis=0, prepend=rig.load[:1, :2] / most)
    kept = np.empty_like(steps)
    for i, step in enumerate(steps):
        stuck = stuck + step
        stuck = stuck * min(1.0, reach / max(float(np.hypot(*stuck)), 1e-9))
        kept[i] = stuck
    memory = most * spread_over_grid(rig, kept, EVERY)
    lever = 2 * rig.noise_std[3] / rig.noise_std[0]
    loops = np.zeros((len(rig.t), 6))
    loops[:, :2] = memory
    loops[:, 3], loops[:, 4] = lever * memory[:, 1], -lever * memory[:, 0]
    return Fault(
        size=lambda scale: Size("face slips sideways, half opening of the loop", 1.0 * scale * reach, "% of peak lateral force"),
        distort=lambda W, scale: W - 0.01 * scale * loops,
    )


def creep_lopsided(_: np.random.Generator, rig: Rig) -> Fault:
    """The gauges' carrier creeps slowly under a load that grows, and back faster where it gets less."""
    share = np.array([1.0, 0.9, 0.7, 1.1, 1.0, 0.6])
    load = rig.load[::COARSE]
    z, crept = load[0].copy(), np.empty_like(load)
    for i, w in enumerate(load):
        z = z + step_of(COARSE) * (w - z) / np.where(np.abs(w) > np.abs(z), COMING_S, GOING_S)
        crept[i] = z
    late = share * spread_over_grid(rig, crept, COARSE)
    return Fault(
        size=lambda scale: Size(f"creep with {COMING_S:g} s under load and {GOING_S:g} s off it, share of load", scale, "%"),
        distort=lambda W, scale: W + 0.01 * scale * late,
    )
