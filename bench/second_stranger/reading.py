"""What is read off the recording beside the wrench: noise, coarse steps, held rows, and a reference that is not the payload."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.signal import lfilter

from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.rotations import find_cross_matrix


class Reading(NamedTuple):
    """The wrench (M, 6) as the converter gives it, N and N m; what a cause on the reading's side has changed in it, and its size."""

    wrench: Array
    changed: Array | None = None
    size: Size | None = None


class Reference(NamedTuple):
    """What the file says of the payload: kg, (3,) kg m, (3, 3) kg m^2 about the sensor's origin; and by how much it is off."""

    mass: float
    first_moment: Array
    inertia: Array
    size: Size | None = None


Reader = Callable[[np.random.Generator, Rig, Array, Array], Reading]
"""Converts a wrench and its noise (M, 6), N and N m."""
Referrer = Callable[[Rig], Reference]


def convert(x: Array, step: Array | float) -> Array:
    """A signal in steps, of its own unit."""
    return np.asarray(np.round(x / step) * step)


def read_plainly(_: np.random.Generator, rig: Rig, wrench: Array, noise: Array) -> Reading:
    """As the manifest says."""
    return Reading(convert(wrench + noise, rig.resolution))


def sensor_noise(rng: np.random.Generator, rig: Rig, wrench: Array, noise: Array) -> Reading:
    """Coloured, and now more, now less of it."""
    a = 0.6
    y = lfilter([np.sqrt(1 - a * a)], [1, -a], rng.normal(size=noise.shape), axis=0)
    breathing = 1 + 0.35 * np.sin(2 * np.pi * rig.times[:, None] / 13 + 1.0)
    added = rig.noise_std * 2.4 * breathing * y
    noise = noise + added
    size = Size("noise factor", float(np.std(noise / rig.noise_std)), "x stated")
    return Reading(convert(wrench + noise, rig.resolution), added, size)


def sensor_quantization(_: np.random.Generator, rig: Rig, wrench: Array, noise: Array) -> Reading:
    """Codes that stick until the wrench is past the middle of the next."""
    step, x = 4 * rig.noise_std, wrench + noise
    coarse = np.empty_like(x)
    code = np.round(x[0] / step) * step
    for i, row in enumerate(x):
        code = np.where(np.abs(row - code) > 0.58 * step, np.round(row / step) * step, code)
        coarse[i] = code
    return Reading(coarse, coarse - convert(x, rig.resolution), Size("code width", 4.0, "sigma"))


def sample_dropout(rng: np.random.Generator, rig: Rig, wrench: Array, noise: Array) -> Reading:
    """Rows that are sent again, in bursts."""
    read = convert(wrench + noise, rig.resolution)
    held = np.zeros(len(read), bool)
    for i in range(1, len(read)):
        held[i] = rng.random() > 0.33 if held[i - 1] else rng.random() < 0.125
    sent = np.maximum.accumulate(np.where(held, 0, np.arange(len(read))))
    return Reading(read[sent], read[sent] - read, Size("rows held", float(held.mean()), "share"))


def refer_rightly(rig: Rig) -> Reference:
    """To the payload."""
    return Reference(rig.body.mass, rig.body.first_moment, rig.body.inertia)


def payload_mismatch(rig: Rig) -> Reference:
    """Too heavy, off its centre and too inert."""
    body = rig.body
    mass, com = body.mass * 1.09, body.com + normalise([1, -0.6, 0.5]) * 0.006
    S, true_S = find_cross_matrix(com), find_cross_matrix(body.com)
    inertia = (body.inertia + body.mass * true_S @ true_S) * 1.12 - mass * S @ S
    return Reference(mass, mass * com, inertia, Size("reference mass too high", 9.0, "%"))
