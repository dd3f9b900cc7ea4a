"""Recordings of the joints alone: torques by Newton and Euler with LuGre friction, and what is planted in them by numpy."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import lfilter

from core.gap.diagnosis import diagnose
from core.recording.recording import Recording
from tests.torque_recordings import EFFORT, RATE_HZ, make

Array = np.ndarray


@pytest.fixture(scope="module")
def made() -> Recording:
    return make(3).loaded


def late_velocities(q: Array, tau_s: float) -> Array:
    """As a first-order low-pass of a controller at 200 Hz leaves them."""
    a = np.exp(-1.0 / (RATE_HZ * tau_s))
    raw = np.gradient(q, 1.0 / RATE_HZ, axis=0)
    return np.asarray(lfilter([1.0 - a], [1.0, -a], raw, axis=0))


def test_a_torque_that_is_off_and_late_velocities_are_told_with_their_sizes_and_what_is_carried(made: Recording) -> None:
    off = np.zeros(6)
    off[1] = 0.06 * EFFORT[1]
    diagnosis = diagnose(replace(made, tau=made.tau + off, dq=late_velocities(made.q, 0.02)))
    assert (diagnosis.verdict, diagnosis.lacking.code) == ("not_enough", "gap-no-wrench")
    beside = {each.id: each for each in diagnosis.also}
    assert beside["velocity_lag"].material
    assert beside["velocity_lag"].parameters["lag_s"].value == pytest.approx(0.02, abs=0.003)
    assert beside["torque_offset"].material
    assert beside["torque_offset"].parameters["joint_2_torque_offset_nm"].value == pytest.approx(off[1], abs=0.02 * EFFORT[1])
    assert beside["joint_friction"].side == "joints"
    assert diagnosis.summary.code == "gap-joints-alone"
    assert "kg" in diagnosis.summary.text
    assert "joint 2" in diagnosis.summary.text
    assert diagnosis.instruction.sentence.code != "instruction-record-again"


def test_velocities_of_the_moment_are_not_named() -> None:
    exact = make(4).loaded
    diagnosis = diagnose(replace(exact, dq=np.gradient(exact.q, 1.0 / RATE_HZ, axis=0)))
    assert not [each.id for each in diagnosis.also if each.material and each.id == "velocity_lag"]


def test_without_torques_and_commands_there_is_nothing_to_say(made: Recording) -> None:
    diagnosis = diagnose(replace(made, tau=None))
    assert (diagnosis.verdict, diagnosis.summary.code, diagnosis.also) == ("not_enough", "gap-nothing-to-say", [])
