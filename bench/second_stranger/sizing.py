"""How much of a cause is to be seen beside the noise once the best rigid payload is taken off, and the scale at which that is as wanted."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Planted
from bench.second_stranger.kinematics import Kinematics
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import find_body_wrench, find_regressor
from bench.second_stranger.sensing import Samples, sample

TRIES = 5
NEAR = 0.12
"""Of the logarithm of what is seen to what is wanted."""


LEAST_SIZE = 1e-3
"""Noise standard deviations per unit: of a parameter below this nothing is to be seen, as of an inertia in static poses."""


class Remainder:
    """Takes off what ten payload parameters and six offsets can make over a motion, in noise standard deviations."""

    def __init__(self, noise_std: Array, motion: Kinematics) -> None:
        Y = find_regressor(motion) / noise_std[None, :, None]
        A = np.concatenate([Y, np.tile(np.eye(6), (len(Y), 1, 1))], 2).reshape(-1, 16)
        self._noise_std = noise_std
        size = np.linalg.norm(A, axis=0)
        if np.any(size < LEAST_SIZE):
            A, size = A[:, size >= LEAST_SIZE], size[size >= LEAST_SIZE]
        self._explained = np.linalg.qr(A / size)[0]

    def find(self, difference: Array) -> Array:
        """(6 M,), what is left of a difference (M, 6), N and N m."""
        y = (difference / self._noise_std).ravel()
        return np.asarray(y - self._explained @ (self._explained.T @ y))


class Yardstick:
    """Measures how a rig's wrench differs from that of its payload alone, by the joints as they are recorded."""

    def __init__(self, rig: Rig, always: Sequence[Planted] = ()) -> None:
        """Of a rig as it is without a cause, but for what is `always` there and belongs to the background."""
        self.rig = rig
        self._always = tuple(always)
        sound = sample(rig, self._always)
        self._of_background = sound.wrench - find_body_wrench(sound.motion, rig.body)
        self._remainder = Remainder(rig.noise_std, sound.motion)
        self.background = find_length(self._remainder.find(self._of_background))
        """What the background leaves, in noise standard deviations over the whole recording."""

    @property
    def root_count(self) -> float:
        """Of all values: by which a length over the recording is divided to be one value's rms."""
        return float(np.sqrt(6 * len(self.rig.times)))

    def subtract(self, samples: Samples) -> Array:
        """(M, 6), N and N m, what the samples have beyond payload and background."""
        return np.asarray(samples.wrench - find_body_wrench(samples.motion, self.rig.body) - self._of_background)

    def measure(self, planted: Sequence[Planted]) -> float:
        """What causes leave beyond the background, in noise standard deviations over the whole recording."""
        samples = sample(self.rig, [*planted, *self._always])
        reports = any(fault.report_joints is not None for fault, _ in planted)
        remainder = Remainder(self.rig.noise_std, samples.motion) if reports else self._remainder
        return find_length(remainder.find(self.subtract(samples)))

    def measure_reading(self, changed: Array) -> float:
        """The same of what the reading (M, 6), N and N m, has changed."""
        return find_length(self._remainder.find(changed))

    def find_scale(self, fault: Fault, wanted: float) -> tuple[float, float]:
        """The scale with which a cause leaves an rms nearest to what is wanted of those tried, and this rms, noise standard deviations."""
        scale, tried = 1.0, []
        for place in range(TRIES):
            rms = self.measure([Planted(fault, scale)]) / self.root_count
            off = abs(np.log(max(rms, 1e-9) / wanted))
            tried.append((off, scale, rms))
            if off < NEAR:
                break
            scale *= np.clip((wanted / max(rms, 1e-9)) ** (1.0 if place < 2 else 0.6), 0.05, 20)
        _, scale, rms = min(tried, key=lambda each: each[0])
        return scale, rms


def find_length(x: Array) -> float:
    """Of a vector."""
    return float(np.linalg.norm(x))
