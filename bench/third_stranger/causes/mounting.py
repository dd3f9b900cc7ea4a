"""The sensor does not sit, or the base does not stand, as the cell says."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.rotations import tilt_vectors
from bench.third_stranger.draws import list_pauses


def rot_gasket(rng: np.random.Generator, rig: Rig) -> Fault:
    """A gasket under the sensor is thicker on one side, and gives a little under the bending moment."""
    angle = rng.uniform(0, 2 * np.pi)
    x, y = np.radians([np.cos(angle), np.sin(angle)])
    soft = np.radians(0.12) / np.maximum(np.abs(rig.load[:, 3:5]).max(), 1e-6)

    def turn(W: Array, scale: float) -> Array:
        about = -scale * (x + soft * W[:, 3]), -scale * (y + soft * W[:, 4])
        return np.hstack([tilt_vectors(W[:, :3], *about), tilt_vectors(W[:, 3:], *about)])

    what = f"sensor tipped about ({np.cos(angle):.2f}, {np.sin(angle):.2f}, 0), an eighth more by the moment"
    return Fault(size=lambda scale: Size(what, scale, "deg"), distort=turn)


def trans_spacer(rng: np.random.Generator, _: Rig) -> Fault:
    """A spacer that nobody entered, a little eccentric."""
    d = normalise([rng.normal() * 0.3, rng.normal() * 0.3, 1])
    return Fault(
        size=lambda scale: Size("spacer under the sensor, its origin is farther out by", 12 * scale, "mm"),
        move_sensor=lambda scale: 0.012 * scale * d,
    )


def tilt_cart(rng: np.random.Generator, rig: Rig) -> Fault:
    """The robot stands on a cart that is not level, and is pushed to where the floor is a little otherwise in each pause."""
    d, after = np.radians(normalise(rng.normal(size=2))), np.zeros(2)
    about = np.tile(d, (len(rig.t), 1))
    for at_s in list_pauses(rig):
        after = after + 0.15 * np.radians(rng.normal(size=2))
        about[rig.t > at_s] = d + after
    return Fault(
        size=lambda scale: Size("tilt of a cart in the first part, about 15 % otherwise in each part", scale, "deg"),
        turn_gravity=lambda g, scale: tilt_vectors(g, scale * about[:, 0], scale * about[:, 1]),
    )


def tilt_plate(rng: np.random.Generator, rig: Rig) -> Fault:
    """A base plate that bends: a tilt, and some more about the axis that the first joint turns away from."""
    d = np.radians(normalise(rng.normal(size=2)))
    azimuth = rig.q[:, 0]

    def tilt(g: Array, scale: float) -> Array:
        return tilt_vectors(g, scale * (d[0] - 0.0012 * np.sin(azimuth)), scale * (d[1] + 0.0012 * np.cos(azimuth)))

    return Fault(size=lambda scale: Size("tilt, with 7 % that follows the first joint", scale, "deg"), turn_gravity=tilt)


def tilt_shim(rng: np.random.Generator, rig: Rig) -> Fault:
    """Shims under one edge."""
    d = np.radians(normalise(rng.normal(size=2)))
    return Fault(
        size=lambda scale: Size("tilt", scale, "deg"),
        turn_gravity=lambda g, scale: tilt_vectors(g, scale * d[0] + 0 * rig.t, scale * d[1] + 0 * rig.t),
    )
