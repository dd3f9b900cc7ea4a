"""In which form a recording is written: how often, in how many parts, with joints or without, and what its protocol rounds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from bench.second_stranger.array import Array

Log = Literal["joints", "poses", "attitude"]
"""What is recorded of the motion: joints, the sensor's pose, or its orientation alone."""
DECIMALS = (1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001, 5e-4, 2e-4, 1e-4)
"""N or N m: the steps that a protocol sends."""
OF_NOISE = 0.8
"""Share of the noise that no step of a protocol exceeds."""


@dataclass(frozen=True)
class Form:
    """One form.

    Attributes:
        rate: of the samples, Hz.
        pauses: of several seconds that the recorder makes.
        is_moved: whether the arm is elsewhere after each of these.
        poses: how many static ones are all that is recorded, each averaged; 0 for a stream.
        joint_step_deg: to which the joints are rounded; as an encoder does for None.
        is_rounded: whether the wrench is sent in the largest decimal steps that the noise hides.
        polled: how often the sensor is asked, Hz, with every answer repeated until the next; for each row anew for None.
        lowpass: corner of the sensor's own filter, Hz, of second order.
    """

    rate: float = 125.0
    pauses: int = 0
    is_moved: bool = False
    poses: int = 0
    log: Log = "joints"
    joint_step_deg: float | None = None
    is_rounded: bool = False
    polled: float | None = None
    lowpass: float | None = None

    @property
    def is_hard(self) -> bool:
        """Whether it tells less than an ordinary stream of joints does, or tells it more slowly."""
        return self.rate <= 20 or self.poses > 0 or self.log != "joints" or self.pauses > 0

    @property
    def name(self) -> str:
        """In a few words."""
        if self.poses:
            return f"{self.poses} averaged poses, {self.log}"
        words = [f"{self.rate:g} Hz", self.log]
        words += [f"{self.pauses + 1} parts"] if self.pauses else []
        words += [f"joints to {self.joint_step_deg:g} deg"] if self.joint_step_deg else []
        words += ["wrench rounded"] if self.is_rounded else []
        words += [f"polled at {self.polled:g} Hz"] if self.polled else []
        words += [f"own filter {self.lowpass:g} Hz"] if self.lowpass else []
        return ", ".join(words)


def choose_steps(noise_std: Array, is_rounded: bool) -> Array:
    """(6,), N and N m, in which the wrench is recorded."""
    if not is_rounded:
        return np.asarray(noise_std * 0.12)
    return np.array([max(step for step in DECIMALS if step <= max(OF_NOISE * each, DECIMALS[-1])) for each in noise_std])
