"""The sensor does not sit, or the base does not stand, as the cell says."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.rotations import tilt_vectors


def rot_wedge(_: np.random.Generator, __: Rig) -> Fault:
    """A wedge under the sensor."""
    axis = normalise([0.75, -0.55, 0.35])
    return Fault(
        size=lambda scale: Size("rotation of sensor about (.75,-.55,.35)", 1.2 * scale, "deg"),
        turn_sensor=lambda scale: np.radians(1.2 * scale) * axis,
    )


def trans_origin(_: np.random.Generator, __: Rig) -> Fault:
    """Its origin is elsewhere."""
    d = normalise([0.8, 0.4, -0.45])
    return Fault(
        size=lambda scale: Size("sensor origin displaced", 6 * scale, "mm"),
        move_sensor=lambda scale: 0.006 * scale * d,
    )


def tilt_settle(_: np.random.Generator, rig: Rig) -> Fault:
    """The base sinks."""
    d = np.radians(normalise([0.8, -0.6]))
    shape = 0.5 + 0.5 * (1 - np.exp(-rig.t / (rig.seconds * 0.25)))
    return Fault(
        size=lambda scale: Size("final tilt; base settles, starts at half", scale, "deg"),
        turn_gravity=lambda g, scale: tilt_vectors(g, scale * shape * d[0], scale * shape * d[1]),
    )


def tilt_floor(_: np.random.Generator, rig: Rig) -> Fault:
    """A soft floor."""
    d, soft = np.radians(normalise([-0.5, 0.85])), np.radians(0.25)
    reach = rig.nominal.p[:, :2]
    reach = reach / np.abs(reach).max()

    def tilt(g: Array, scale: float) -> Array:
        return tilt_vectors(g, scale * (d[0] - soft * reach[:, 1]), scale * (d[1] + soft * reach[:, 0]))

    return Fault(
        size=lambda scale: Size("tilt, of which a quarter follows the arm reach (soft floor)", scale, "deg"),
        turn_gravity=tilt,
    )


def tilt_const(rng: np.random.Generator, rig: Rig) -> Fault:
    """Once and for all."""
    d = np.radians(normalise(rng.normal(size=2)))
    return Fault(
        size=lambda scale: Size("tilt", scale, "deg"),
        turn_gravity=lambda g, scale: tilt_vectors(g, scale * d[0] + 0 * rig.t, scale * d[1] + 0 * rig.t),
    )
