"""Sensor and base are not where the drawing has them: a dowel that is missing, a plate that was left out, feet that sink, a lean."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.rotations import tilt_vectors
from bench.second_stranger.signals import rise


def rot_dowel(rng: np.random.Generator, _: Rig) -> Fault:
    """The dowel is missing: the sensor is turned within the play of its bolts, and sits on a burr besides."""
    by = np.radians(np.array([0.15, -0.1, 0.6]) * rng.choice([-1, 1], 3))
    angle = float(np.degrees(np.linalg.norm(by)))
    return Fault(size=lambda scale: Size("sensor turned, mostly about z", scale * angle, "deg"), turn_sensor=lambda scale: scale * by)


def rot_burr(rng: np.random.Generator, _: Rig) -> Fault:
    """A burr under one edge of the flange tips the sensor."""
    by = np.radians(0.5) * np.append(normalise(rng.normal(size=2)), 0.05)
    return Fault(size=lambda scale: Size("sensor tipped", 0.5 * scale, "deg"), turn_sensor=lambda scale: scale * by)


def trans_plate(rng: np.random.Generator, _: Rig) -> Fault:
    """An adapter was left out of the model: the sensor is farther out, and a little to the side."""
    by = 0.004 * normalise([rng.normal() * 0.3, rng.normal() * 0.3, 1.0])
    return Fault(size=lambda scale: Size("sensor farther out", 4 * scale, "mm"), move_sensor=lambda scale: scale * by)


def _tilt(toward: Array, shape: Array, what: str) -> Fault:
    """By half a degree times a shape (N,), about an axis (2,) in the base's x and y."""
    angle = np.radians(0.5)
    return Fault(
        size=lambda scale: Size(what, 0.5 * scale * float(np.max(np.abs(shape))), "deg"),
        turn_gravity=lambda g, scale: tilt_vectors(g, scale * angle * toward[0] * shape, scale * angle * toward[1] * shape),
    )


def tilt_shims(rng: np.random.Generator, rig: Rig) -> Fault:
    """A shim is missing under the base; it gives a little more where the arm swings over it."""
    over = 1 + 0.15 * np.cos(rig.q[:, 0] - rng.uniform(0, 2 * np.pi))
    return _tilt(normalise(rng.normal(size=2)), over, "base tilted, at most")


def tilt_sinking(rng: np.random.Generator, rig: Rig) -> Fault:
    """A foot of the pedestal sinks into new screed, fast at first; it stood askew by a third from the start."""
    begin = rng.uniform(0.1, 0.3) * rig.seconds
    sunk = 1 / 3 + 2 / 3 * (1 - np.exp(-np.maximum(rig.t - begin, 0) / (0.3 * rig.seconds))) * rise((rig.t - begin) / 2)
    return _tilt(normalise(rng.normal(size=2)), sunk, "base tilted in the end")
