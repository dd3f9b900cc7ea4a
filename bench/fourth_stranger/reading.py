"""From the wrench to the numbers in the file: noise of a colour and steps; and what is planted beside the wrench."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.signal import lfilter

from bench.fourth_stranger.scene import Scene
from bench.second_stranger.array import Array
from bench.second_stranger.fault import Size
from bench.second_stranger.reading import Reading, Reference, convert
from bench.second_stranger.rig import Rig
from bench.second_stranger.rotations import find_cross_matrix

Reader = Callable[[np.random.Generator, Scene, Array], Reading]
"""Converts a wrench (M, 6), N and N m, with its noise and offset."""
OTHER_ORIGIN_M = np.array([0.0, 0.0, 0.014])


def draw_noise(rng: np.random.Generator, scene: Scene) -> Array:
    """(M, 6), N and N m, each channel of its own colour and as strong as the rig says."""
    white = rng.normal(size=(len(scene.rig.times), 6))
    columns = [lfilter([np.sqrt(1 - a * a)], [1, -a], white[:, i], zi=[a * white[0, i]])[0] for i, a in enumerate(scene.colours)]
    return np.asarray(scene.rig.noise_std * np.stack(columns, 1))


def find_steps(scene: Scene) -> Array:
    """(6,), N and N m, in which the wrench is recorded."""
    return np.asarray(scene.form.step * scene.rig.noise_std)


def read_in_form(_: np.random.Generator, scene: Scene, wrench: Array) -> Reading:
    """As the form has it."""
    return Reading(convert(wrench, find_steps(scene)))


def sensor_interference(rng: np.random.Generator, scene: Scene, wrench: Array) -> Reading:
    """Two fans of the cabinet that turn nearly alike: two lines close together that beat, in the torques more than in the forces."""
    t = scene.rig.times
    amplitudes = np.array([0.8, 1.2, 0.6, 3.4, 3.0, 2.2]) * rng.choice([-1, 1], 6) * scene.rig.noise_std
    beat = np.sin(2 * np.pi * 43.1 * t) + 0.7 * np.sin(2 * np.pi * 43.5 * t + 0.6)
    hum = np.outer(beat, amplitudes)
    size = Size("two fans beat at 43.1 and 43.5 Hz, amplitude tx of the first", 3.4, "x noise")
    return Reading(convert(wrench + hum, find_steps(scene)), hum, size)


def payload_mismatch(rig: Rig) -> Reference:
    """The CAD has its origin on the mounting face, 14 mm before the sensor's: the mass is right, and all that depends on where is not."""
    body = rig.body
    com = body.com + OTHER_ORIGIN_M
    S, true_S = find_cross_matrix(com), find_cross_matrix(body.com)
    inertia = body.inertia + body.mass * true_S @ true_S - body.mass * S @ S
    return Reference(body.mass, body.mass * com, inertia, Size("origin of the CAD before the sensor's", 14.0, "mm"))
