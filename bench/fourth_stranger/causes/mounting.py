"""The sensor does not sit, or the base does not stand, as the cell says."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.rotations import tilt_vectors
from bench.second_stranger.signals import lag


def rot_slack(_: np.random.Generator, rig: Rig) -> Fault:
    """A dowel has play: the sensor is turned about its axis, and a seventh of it goes over with the twist."""
    over = np.tanh((rig.load[:, 5] - np.median(rig.load[:, 5])) / (0.15 * np.ptp(rig.load[:, 5])))

    def turn(W: Array, scale: float) -> Array:
        angle = np.radians(scale) * (1 + 0.14 * over)
        c, s = np.cos(angle), np.sin(angle)
        x, y = W[:, [0, 3]], W[:, [1, 4]]
        turned = W.copy()
        turned[:, [0, 3]], turned[:, [1, 4]] = c[:, None] * x + s[:, None] * y, c[:, None] * y - s[:, None] * x
        return turned

    return Fault(size=lambda scale: Size("sensor turned about its axis, a seventh of it with the twist", scale, "deg"), distort=turn)


def trans_cover(rng: np.random.Generator, _: Rig) -> Fault:
    """The origin was measured from the edge of a cover: it is off sideways."""
    d = normalise([rng.normal(), rng.normal(), 0.3 * rng.normal()])
    return Fault(size=lambda scale: Size("origin off sideways", 6 * scale, "mm"), move_sensor=lambda scale: 0.006 * scale * d)


def tilt_rocking(rng: np.random.Generator, rig: Rig) -> Fault:
    """A platform on four wheels of which three touch: it leans, and rocks over to the other wheel when the arm is on that side."""
    d, other = np.radians(normalise(rng.normal(size=2))), np.radians(normalise(rng.normal(size=2)))
    across = rig.nominal.p[:, :2] @ np.array([other[1], -other[0]]) / np.linalg.norm(other)
    across = across - np.median(across)
    least = 0.2 * np.std(across)
    last = np.maximum.accumulate(np.where(np.abs(across) > least, np.arange(len(across)), 0))
    rocks = lag(lag(np.sign(across[last])[:, None], 0.06), 0.06)
    about = d + 0.13 * rocks * other
    return Fault(
        size=lambda scale: Size("tilt of a platform, with an eighth of it either way as it rocks", scale, "deg"),
        turn_gravity=lambda g, scale: tilt_vectors(g, scale * about[:, 0], scale * about[:, 1]),
    )


def tilt_bracket(rng: np.random.Generator, rig: Rig) -> Fault:
    """The bracket was welded askew, across gravity, and gives a little with the time that it is loaded."""
    is_level = abs(rig.gravity[2]) > 1
    d = np.radians(normalise(rng.normal(size=2) if is_level else [-rig.gravity[1], rig.gravity[0]]))
    given = 1 + 0.05 * np.sqrt(rig.t / rig.seconds)
    return Fault(
        size=lambda scale: Size("tilt of a bracket, a twentieth more in the end", scale, "deg"),
        turn_gravity=lambda g, scale: tilt_vectors(g, scale * d[0] * given, scale * d[1] * given),
    )
