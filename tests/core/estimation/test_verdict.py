"""The verdict says the mass with two digits of its uncertainty, and what is determined."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.estimation.budget import Budget
from core.estimation.estimate import DriftEstimate, Estimate
from core.estimation.verdict import verdict_of
from core.payload.inertia import PHI_NAMES
from core.words.message import Message

NONE = np.zeros(6)
STANDING = Message.of("estimation-standing")


def estimate(mass: float = 2.5, std: float = 0.001, undetermined: str = "") -> Estimate:
    determined = np.array([name not in undetermined.split() for name in PHI_NAMES])
    phi, covariance = np.array([mass, *[0.0] * 9]), std**2 * np.eye(10)
    reasons = dict.fromkeys(undetermined.split(), STANDING)
    drift = DriftEstimate(np.zeros(0), np.zeros((0, 6)), NONE)
    return Estimate(phi, covariance, determined, reasons, NONE, NONE, True, NONE, NONE, drift, Budget(covariance))


@given(st.floats(0.01, 50.0), st.floats(1e-6, 5.0))
def test_the_mass_has_the_decimals_of_two_digits_of_its_half_width(mass: float, std: float) -> None:
    half = 1.96 * std
    places = min(6, max(0, 1 - math.floor(math.log10(half))))
    said = str(verdict_of(estimate(mass, std), static=False))
    assert said == f"The payload has {mass:.{places}f} kg (±{half:.{places}f} kg, 95 %); all ten inertial parameters are determined."


@pytest.mark.parametrize(
    ("undetermined", "static", "words"),
    [
        ("Ixx Ixy Ixz Iyy Iyz Izz", True, "the inertia is not (static poses only: the inertia is not excited)."),
        ("Ixx Ixy Ixz Iyy Iyz Izz", False, "the inertia is not (the motion does not excite the inertia enough)."),
        ("Iyy Iyz", False, "; not determined: Iyy, Iyz."),
        ("mc_x Ixx Ixy Ixz Iyy Iyz Izz", False, "; not determined: mc_x, Ixx, Ixy, Ixz, Iyy, Iyz, Izz."),
        (" ".join(PHI_NAMES), True, "The payload is not determined: static poses only: the inertia is not excited."),
    ],
)
def test_what_is_not_determined_is_named(undetermined: str, static: bool, words: str) -> None:
    assert str(verdict_of(estimate(undetermined=undetermined), static=static)).endswith(words)


def test_it_is_said_in_german() -> None:
    said = verdict_of(estimate(), static=False).say("de")
    assert said == "Die Last hat 2,5000 kg (±0,0020 kg, 95 %); alle zehn Trägheitsparameter sind bestimmt."
