"""`core.estimation.joint_torques.identification` on recordings of a generator that shares no code with it, and on those of a real arm."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import permutations
from pathlib import Path

import numpy as np
import pytest

from core.errors import BadRecording
from core.estimation.estimate import Estimate, Identification
from core.estimation.joint_torques.identification import identify_by_torques
from core.recording.folder import read_recording
from tests.torque_recordings import Made, make

REAL = Path(__file__).resolve().parents[5] / "shared" / "real"
GAINS = np.array([0.1, -0.08, 0.05, -0.1, 0.06, -0.05])
"""Wrong current constants, of which nothing is stated."""


@pytest.fixture(scope="module")
def pair() -> Made:
    return make(3, mass_kg=2.8, gains=GAINS)


def estimate_of(found: Identification) -> Estimate:
    assert found.estimate is not None, found.verdict.text
    return found.estimate


def assert_holds(found: Identification, truth: np.ndarray, *, determined: int) -> Estimate:
    estimate = estimate_of(found)
    off = np.abs(estimate.phi - truth) / estimate.std
    assert estimate.determined.sum() >= determined
    assert np.nanmax(off) < 3.0
    return estimate


def test_with_and_without_a_payload_all_ten_are_found_though_every_current_constant_is_wrong(pair: Made) -> None:
    found = identify_by_torques(pair.loaded, pair.empty)
    estimate = assert_holds(found, pair.phi, determined=10)
    assert estimate.std[0] < 0.06 * pair.phi[0]
    assert estimate.budget.largest[0] == "torque_gain"
    assert any("8 %" in each.text for each in estimate.budget.assumptions(estimate.determined))
    assert estimate.consistent
    off = np.array([each.gain for each in found.joints]) - GAINS
    assert (np.abs(off) < 3.0 * np.array([each.gain_std for each in found.joints])).all()
    assert all(each.coulomb_n_m > 0.0 and each.windows > 300 for each in found.joints[:3])


def test_the_arms_model_alone_holds_the_truth_too_and_is_less_sure(pair: Made) -> None:
    alone, both = (identify_by_torques(pair.loaded, empty) for empty in (None, pair.empty))
    estimate = assert_holds(alone, pair.phi, determined=4)
    assert estimate.std[0] > estimate_of(both).std[0]
    assert "torques-arm-by-urdf" in {warning.code for warning in alone.warnings}


def test_a_gain_that_is_stated_better_makes_a_better_answer(pair: Made) -> None:
    good = make(3, mass_kg=2.8, gain_std=0.005)
    estimate = assert_holds(identify_by_torques(good.loaded, good.empty), good.phi, determined=10)
    assert estimate.std[0] < 0.5 * estimate_of(identify_by_torques(pair.loaded, pair.empty)).std[0]


def test_what_carries_nothing_is_said_to_carry_nothing(pair: Made) -> None:
    again = make(3, mass_kg=1e-9, gains=GAINS)
    found = identify_by_torques(again.loaded, pair.empty)
    estimate = estimate_of(found)
    assert found.verdict.code == "torques-no-payload-seen"
    assert (np.abs(estimate.phi[:4]) < 3.0 * estimate.std[:4]).all()
    assert not estimate.determined[4:].any()


def test_joints_that_stand_say_nothing(pair: Made) -> None:
    assert pair.loaded.q is not None
    still = replace(pair.loaded, q=np.repeat(pair.loaded.q[:1], len(pair.loaded), axis=0))
    found = identify_by_torques(still)
    assert found.estimate is None
    assert "no joint turns" in found.verdict.text


def test_an_arm_of_unknown_masses_needs_a_recording_without_payload(pair: Made) -> None:
    robot = pair.loaded.robot
    assert robot is not None
    bare = replace(robot, urdf=re.sub(r"<inertial>.*?</inertial>", "", robot.urdf))
    loaded, empty = (replace(each, robot=bare) for each in (pair.loaded, pair.empty))
    assert "states no mass" in identify_by_torques(loaded).verdict.text
    assert_holds(identify_by_torques(loaded, empty), pair.phi, determined=4)


@pytest.mark.parametrize("factor", [0.03, -1.0, 30.0])
@pytest.mark.parametrize("both", [True, False])
def test_torques_in_another_unit_or_of_the_other_sign_are_named(pair: Made, factor: float, both: bool) -> None:
    assert pair.loaded.tau is not None and pair.empty.tau is not None
    loaded, empty = (replace(each, tau=factor * each.tau) for each in (pair.loaded, pair.empty) if each.tau is not None)
    found = identify_by_torques(loaded, empty if both else None)
    assert found.estimate is None
    assert "times what the motion of the arm asks for" in found.verdict.text


def test_another_robot_is_refused(pair: Made) -> None:
    with pytest.raises(BadRecording, match="robot"):
        identify_by_torques(pair.loaded, make(4).empty)


@pytest.mark.parametrize("number", [1, *(pytest.param(number, marks=pytest.mark.thorough) for number in (2, 3))])
def test_on_a_real_arm_without_payload_none_is_seen(number: int) -> None:
    found = identify_by_torques(read_recording(REAL / f"kuka-lwr4-torques-{number}"))
    assert_no_payload(found)


@pytest.mark.parametrize(
    ("loaded", "empty"),
    [(2, 1), *(pytest.param(*pair, marks=pytest.mark.thorough) for pair in permutations((1, 2, 3), 2) if pair != (2, 1))],
)
def test_two_recordings_of_a_real_arm_without_payload_differ_by_none(loaded: int, empty: int) -> None:
    first, second = (read_recording(REAL / f"kuka-lwr4-torques-{number}") for number in (loaded, empty))
    assert_no_payload(identify_by_torques(first, second))


def assert_no_payload(found: Identification) -> None:
    estimate = estimate_of(found)
    assert found.verdict.code == "torques-no-payload-seen"
    assert (np.abs(estimate.phi[:4]) <= 1.96 * estimate.std[:4]).all()
