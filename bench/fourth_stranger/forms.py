"""In which form a recording is written: how often and how evenly, what is recorded of the motion, what is stated and what is left out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Log = Literal["joints", "poses", "attitude"]
"""What is recorded of the motion: joints, the sensor's pose, or its orientation alone."""
Extras = Literal["", "speeds", "commands", "drives"]
"""What stands beside the joints: nothing, their speeds, what was commanded, or that and the torques of the drives."""


@dataclass(frozen=True)
class Form:
    """One form.

    Attributes:
        rate: of the samples on the average, Hz.
        uneven: share of the interval by which intervals differ, as where nobody keeps time.
        is_halved: whether only every other row was kept from some time on.
        is_epoch: whether time is that of a clock that began in 1970.
        stated: the noise that the file states, as share of what there is; none where 0.
        step: in which the wrench is recorded, in noise standard deviations.
        is_labelled: whether phases are.
        has_range: whether a range of the sensor is stated.
        is_direction: whether gravity is a direction with a site.
        is_single: whether the wrench is in single precision.
    """

    rate: float = 200.0
    log: Log = "joints"
    extras: Extras = ""
    uneven: float = 0.0
    is_halved: bool = False
    is_epoch: bool = False
    stated: float = 1.0
    step: float = 0.1
    is_labelled: bool = False
    has_range: bool = True
    is_direction: bool = False
    is_single: bool = False

    @property
    def words(self) -> list[str]:
        """What is odd about it."""
        said = {
            "poses without joints": self.log == "poses",
            "orientations alone": self.log == "attitude",
            "uneven": self.uneven > 0,
            "every other row from some time on": self.is_halved,
            "epoch time": self.is_epoch,
            "noise not stated": self.stated == 0,
            f"stated noise {self.stated:g} of what there is": 0 < self.stated < 1,
            f"wrench in steps of {self.step:g} sigma": self.step > 0.5,
            "gravity a direction with a site": self.is_direction,
            "single precision": self.is_single,
        }
        return [words for words, is_so in said.items() if is_so]

    @property
    def name(self) -> str:
        """In a few words."""
        return ", ".join([f"{self.rate:g} Hz", self.log, *([self.extras] if self.extras else []), *self.words])
