"""The payload is not one rigid body all the time: lids and trays, a part that is pulled out, a tank that drains, a lance that beats."""

from __future__ import annotations

import numpy as np

from bench.fourth_stranger.draws import draw_direction, find_speed_of_joints, spread_over_grid, step_of
from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import find_moved_part_wrench, find_point_wrench
from bench.second_stranger.signals import lag, resonate, rise

EVERY = 5
"""Steps of the grid."""
FALLS_AT = 0.3
"""Share of gravity at which a lid falls over."""
FRICTION, RIM_SHARE = 0.12, 0.35
"""Of a tray; and how far its rim is, beside the distance of the payload's centre."""


def _measure_out(rig: Rig) -> float:
    """m, how far out the payload's centre is, for parts that are as large as the payload."""
    return max(float(np.linalg.norm(rig.body.com)), 0.03)


def loose_lid(rng: np.random.Generator, rig: Rig) -> Fault:
    """A lid on a hinge falls open or shut when gravity has turned far enough, and bounces once."""
    hinge = draw_direction(rng)
    across = normalise(np.cross(hinge, draw_direction(rng)))
    down = -rig.nominal.u[::EVERY] / np.linalg.norm(rig.nominal.u[::EVERY], axis=1, keepdims=True)
    pulls = down @ across
    last = np.maximum.accumulate(np.where(np.abs(pulls - np.median(pulls)) > FALLS_AT, np.arange(len(pulls)), 0))
    side = np.sign(pulls[last] - np.median(pulls))
    falls = resonate(resonate(spread_over_grid(rig, side[:, None], EVERY), 1.6, 0.6), 7.0, 0.9)
    by = 0.5 * _measure_out(rig) * (falls - falls[0]) * (across + 0.3 * hinge)
    rest, flips = rig.body.com + 0.4 * _measure_out(rig) * hinge, int(np.sum(np.abs(np.diff(side)) > 1))
    return Fault(
        size=lambda scale: Size(f"lid that falls over {flips} times, mass", 0.06 * scale * rig.body.mass, "kg"),
        change_payload=lambda W, k, scale: W + find_moved_part_wrench(k, 0.06 * scale * rig.body.mass, rest, by),
    )


def loose_tray(_: np.random.Generator, rig: Rig) -> Fault:
    """A part lies on a tray with a rim: it sticks, slides in any direction when it is tilted or shaken, and stops dead at the rim."""
    rest, rim, dt = rig.body.com, RIM_SHARE * _measure_out(rig), step_of(EVERY)
    feels = -rig.nominal.feel_at(rest)[::EVERY]
    x, v, slid = np.zeros(2), np.zeros(2), np.empty((len(feels), 2))
    for i, a in enumerate(feels):
        most = FRICTION * abs(float(a[2]))
        speed, pull = float(np.hypot(*v)), float(np.hypot(a[0], a[1]))
        if speed < 1e-6 and pull <= most:
            v = np.zeros(2)
        else:
            along = v / speed if speed >= 1e-6 else a[:2] / pull
            after = v + dt * (a[:2] - most * along)
            v = np.zeros(2) if speed >= 1e-6 and float(after @ v) < 0 else after
        x = x + dt * v
        out = float(np.hypot(*x))
        if out > rim:
            x, v = x * rim / out, np.zeros(2)
        slid[i] = x
    by = np.zeros((len(rig.t), 3))
    by[:, :2] = lag(lag(spread_over_grid(rig, slid, EVERY), 0.025), 0.025)
    by -= by[0]
    return Fault(
        size=lambda scale: Size(f"part that slides on a tray of {1e3 * rim:.0f} mm, mass", 0.06 * scale * rig.body.mass, "kg"),
        change_payload=lambda W, k, scale: W + find_moved_part_wrench(k, 0.06 * scale * rig.body.mass, rest, by),
    )


def shift_pull(rng: np.random.Generator, rig: Rig) -> Fault:
    """A part is drawn out of its clamp where it is pulled hardest along it, turning a little as it comes."""
    along = normalise([0.5, -0.3, 0.8])
    is_then = (rig.t > 0.3 * rig.seconds) & (rig.t < 0.7 * rig.seconds) & (find_speed_of_joints(rig) > 0.2)
    pulls = np.where(is_then, -rig.nominal.u @ along, -np.inf)
    at_s = float(rig.t[int(np.argmax(pulls))])
    aside = normalise(np.cross(along, draw_direction(rng)))
    mass, rest, x = 0.35 * rig.body.mass, rig.body.com + 0.3 * _measure_out(rig) * along, (rig.t - at_s + 0.2) / 0.45
    by = np.outer(rise(x), along) + 0.3 * np.outer(rise(x - 0.4), aside)
    return Fault(
        size=lambda scale: Size(f"35 % of the mass drawn out of its clamp at {at_s:.1f} s, by", 10 * scale, "mm"),
        change_payload=lambda W, k, scale: W + find_moved_part_wrench(k, mass, rest, 0.01 * scale * by),
    )


def mass_drain(rng: np.random.Generator, rig: Rig) -> Fault:
    """A tank drains from some time on, by Torricelli's law: fast first, then slower."""
    at_s, lasting_s = rng.uniform(0.3, 0.5) * rig.seconds, min(rng.uniform(4, 7), 0.2 * rig.seconds)
    at, left = rig.body.com * 1.2, np.clip(1 - (rig.t - at_s) / lasting_s, 0, 1) ** 2
    gone = np.where(rig.t < at_s, 0.0, 1 - left)[:, None]
    return Fault(
        size=lambda scale: Size(f"drained from {at_s:.1f} s on within {lasting_s:.1f} s", -50 * scale * rig.body.mass, "g"),
        change_payload=lambda W, k, scale: W - 0.05 * scale * rig.body.mass * gone * find_point_wrench(k, at),
    )


def flex_beating(rng: np.random.Generator, rig: Rig) -> Fault:
    """A slender lance rings in two directions at nearly the same pitch, so that one takes over from the other."""
    mass, rest = 0.15 * rig.body.mass, rig.body.com + np.array([0, 0, 1.2 * _measure_out(rig)])
    turned = rng.uniform(0, np.pi)
    modes = ((np.array([np.cos(turned), np.sin(turned), 0]), 13.2, 0.008), (np.array([-np.sin(turned), np.cos(turned), 0]), 14.5, 0.012))

    def ring(W: Array, k: Kinematics, scale: float) -> Array:
        pull, by = -k.feel_at(rest), np.zeros((len(rig.t), 3))
        for direction, hz, damping in modes:
            x = resonate((pull @ direction)[:, None], hz, damping)[:, 0] / (2 * np.pi * hz) ** 2
            by += np.outer(x - x[0], direction)
        return W + find_moved_part_wrench(k, mass * scale, rest, by)

    return Fault(
        size=lambda scale: Size("lance rings at 13.2 and 14.5 Hz across, mass that swings", mass * scale, "kg"), change_payload=ring
    )
