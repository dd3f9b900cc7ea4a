"""The wrench comes in coarser steps than stated."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import SUFFIXES, expand_to_channels, say_load
from core.effects.effect import Finding, Parameter, Symptom, View
from core.payload.channels import CHANNELS, UNITS
from core.recording.held_readings import find_dead_bands
from core.recording.recording import Recording
from core.words.message import Message

COARSER = 1.4
"""Times the stated resolution; less is a question of rounding."""
MATERIAL = 1.0
"""Steps, in standard deviations of a sample's noise."""
HOLES = 20
"""Fewer holes between values do not tell missing codes."""
OFTEN = 5
"""Times that a value has to be reached to say that its neighbour would have been, too."""
AS_LARGE = 0.9
"""Of holes of one size the smallest is at least this share of the largest."""


class SensorQuantization(Symptom):
    """`round(W / d) d`: the step `d` read off the distinct values of each channel, over the run or in the hold in which they are coarsest
    (a number with few digits is coarse where it is large). A channel that rests until it has moved by `d` (a dead band) has steps as well,
    and so has a converter that never gives some of its codes.

    Material where `d` is coarser than stated and larger than the noise of a sample: finer steps are dithered away by the noise itself.
    """

    id = "sensor_quantization"
    title = Message.of("effect-sensor-quantization-title")
    stage = "sensor"
    side = "reading"
    explains = ("sensor_noise",)

    def parameters(self, recording: Recording) -> tuple[Parameter, ...]:
        """Step of each channel, N and N m."""
        return tuple(
            Parameter(f"{channel}_step_{suffix}", unit, 0.0, 0.0, float(100 * scale), float(scale))
            for channel, suffix, unit, scale in zip(CHANNELS, SUFFIXES, UNITS, expand_to_channels(0.5, 0.02), strict=True)
        )

    def observe(self, recording: Recording, view: View) -> Finding | None:
        """Compares all steps with the stated resolution; None without a wrench, or where none is coarser and shows beside the noise."""
        if recording.wrench is None:
            return None
        sensor = recording.sensor
        step = np.maximum([_coarsest(channel, view.holds) for channel in recording.wrench.T], find_dead_bands(recording.wrench))
        stated = np.zeros(6) if sensor.resolution is None else np.asarray(sensor.resolution)
        noise = _noise(view.noise_std, sensor.noise_std, step)
        rounding = step / np.sqrt(12)
        coarse = step > COARSER * stated
        if not (coarse & (rounding > 0.1 * noise)).any():
            return None
        k = int((coarse * rounding / noise).argmax())
        levels = np.array([len(np.unique(channel)) for channel in recording.wrench.T])
        std = np.maximum(stated, 1e-9) / np.sqrt(levels)
        times = float(step[k] / noise[k])
        size, usual = say_load(step[k], k), say_load(stated[k], k)
        if stated[k]:
            seen = Message.of("symptom-coarser-steps", channel=CHANNELS[k], step=size, stated=usual, times=times)
        else:
            seen = Message.of("symptom-steps", channel=CHANNELS[k], step=size, times=times)
        sigma = float(rounding[k] / noise[k] * np.sqrt(len(recording)))
        return Finding(step, std, sigma, bool((coarse & (step > MATERIAL * noise)).any()), times, seen)

    def advice(self, finding: Finding) -> Message:
        """Advises the finest resolution or a smaller range, with the coarsest step, N or N m."""
        k = int((finding.theta / expand_to_channels(1.0, 0.05)).argmax())
        return Message.of("advice-sensor-quantization", channel=CHANNELS[k], step=say_load(finding.theta[k], k))


def _coarsest(channel: Array, holds: tuple[slice, ...]) -> float:
    """The largest of the steps between values of a channel (N,); 0 where none was seen."""
    parts = (channel, *(channel[hold] for hold in holds))
    return max(find_hole(channel), *(step_of(part) or 0.0 for part in parts))


def find_hole(channel: Array) -> float:
    """The largest hole between values of a channel (N,) that it never enters though it often comes to both its ends, of those that are as
    large as many others; 0 where there are none."""
    rounded = np.round(channel, 9)
    values, times = np.unique(rounded[np.diff(rounded, prepend=np.nan) != 0], return_counts=True)
    often = times >= OFTEN
    holes = np.sort(np.diff(values)[often[1:] & often[:-1]])
    alike = holes[: max(0, len(holes) - HOLES + 1)]
    alike = alike[alike >= AS_LARGE * holes[HOLES - 1 :]]
    return float(alike[-1]) if len(alike) else 0.0


def step_of(channel: Array) -> float | None:
    """The step between neighbouring values of a channel (N,); None where its values are not repeated enough to tell.

    The small gaps between distinct values, since larger ones are values that never came up. A channel that was rounded twice has small
    gaps of two sizes, whose mean is the coarser step.
    """
    values = np.unique(np.round(channel, 9))
    if len(values) < 3 or len(values) > len(channel) / 3:
        return None
    gaps = np.diff(values)
    smallest = float(np.quantile(gaps, 0.1, method="nearest"))  # a stray value beside the steps does not count
    return float(gaps[np.abs(gaps / smallest - 1.3) < 0.5].mean())


def _noise(seen: Array, stated: Array | None, step: Array) -> Array:
    """(6,), noise before rounding: stated, else as seen in the holds without the share of the rounding."""
    if stated is not None:
        return np.asarray(stated)
    return np.sqrt(np.maximum(seen**2 - step**2 / 12, (0.05 * seen) ** 2 + np.finfo(float).tiny))
