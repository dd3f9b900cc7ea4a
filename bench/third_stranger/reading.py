"""From the wrench to the numbers in the file: noise of a colour, polling, rounding; and what is planted beside the wrench."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.signal import lfilter

from bench.second_stranger.array import Array
from bench.second_stranger.draws import normalise
from bench.second_stranger.fault import Size
from bench.second_stranger.reading import Reading, Reference, convert
from bench.second_stranger.rig import Rig
from bench.second_stranger.rotations import find_cross_matrix
from bench.third_stranger.forms import choose_steps
from bench.third_stranger.scene import Scene

Reader = Callable[[np.random.Generator, Scene, Array], Reading]
"""Converts a wrench (M, 6), N and N m, with its noise and offset."""
ASKED = 100.0
"""Hz, how often a sensor answers whose log is five times as fast."""


def draw_noise(rng: np.random.Generator, scene: Scene) -> Array:
    """(M, 6), N and N m, each channel of its own colour and as strong as the rig says."""
    white = rng.normal(size=(len(scene.rig.times), 6))
    columns = [lfilter([np.sqrt(1 - a * a)], [1, -a], white[:, i], zi=[a * white[0, i]])[0] for i, a in enumerate(scene.colours)]
    return np.asarray(scene.row_noise * np.stack(columns, 1))


def find_steps(scene: Scene) -> Array:
    """(6,), N and N m, in which the wrench is recorded."""
    return choose_steps(scene.row_noise, scene.form.is_rounded)


def poll(times: Array, hz: float) -> Array:
    """(M,), places of the rows whose answers stand in the rows at times (M,), s, of a sensor that is asked so often."""
    turn = np.floor((times - times[0]) * hz + 1e-6)
    is_new = np.diff(turn, prepend=-1) > 0
    return np.maximum.accumulate(np.where(is_new, np.arange(len(times)), 0))


def read_in_form(_: np.random.Generator, scene: Scene, wrench: Array) -> Reading:
    """As the form has it."""
    if scene.form.polled is not None:
        wrench = wrench[poll(scene.rig.times, scene.form.polled)]
    return Reading(convert(wrench, find_steps(scene)))


def sensor_interference(rng: np.random.Generator, scene: Scene, wrench: Array) -> Reading:
    """A pump beside shakes the cable: a line that hardly wanders, with its double, in all channels and not alike."""
    t = scene.rig.times
    angle = 2 * np.pi * (36.7 * t + 0.15 * np.sin(2 * np.pi * t / 21))
    first, second = rng.uniform(1.4, 3.2, 6) * rng.choice([-1, 1], 6), rng.uniform(0.3, 0.8, 6)
    hum = scene.row_noise * (np.outer(np.sin(angle), first) + np.outer(np.sin(2 * angle + 1), second))
    size = Size("line at 36.7 Hz with its double, amplitude fx", float(abs(first[0])), "x noise")
    return Reading(convert(wrench + hum, find_steps(scene)), hum, size)


def sample_dropout(_: np.random.Generator, scene: Scene, wrench: Array) -> Reading:
    """The log is faster than the sensor, and repeats each answer until the next."""
    read = convert(wrench, find_steps(scene))
    held = read[poll(scene.rig.times, ASKED)]
    share = float(np.mean(np.all(np.diff(held, axis=0) == 0, axis=1)))
    return Reading(held, held - read, Size(f"sensor asked at {ASKED:g} Hz, rows held", share, "share"))


def payload_mismatch(rig: Rig) -> Reference:
    """To other fingers of the gripper: lighter, nearer, and less inert."""
    body = rig.body
    mass, com = body.mass * 0.955, body.com + normalise([-0.6, 0.7, -0.9]) * 0.005
    S, true_S = find_cross_matrix(com), find_cross_matrix(body.com)
    inertia = 0.88 * (body.inertia + body.mass * true_S @ true_S) - mass * S @ S
    return Reference(mass, mass * com, inertia, Size("reference mass too low", 4.5, "%"))
