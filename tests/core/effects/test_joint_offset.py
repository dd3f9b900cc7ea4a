"""Zeros of joints."""

from __future__ import annotations

import numpy as np

from core.effects.joint_offset import JointOffset
from tests.core.effects.mechanical_truth import change, rms


def test_a_zero_of_the_first_joint_changes_nothing_where_that_joint_is_vertical() -> None:
    assert rms(change(JointOffset(), np.array([0.05, *[0.0] * 20]))) < 1e-3
