"""Motions that are logged slowly, of a generator that shares no code with the engine."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.estimation.kinematics import poses_of
from core.gap.answer import Diagnosis
from core.gap.basis import RESOLVED, STREAM, find_way_off
from core.gap.diagnosis import examine
from core.gap.fit_all import one_by_one
from core.recording.recording import Recording
from core.robot.model import RobotModel
from tests.foreign_recordings import Condition, make


def attitudes_alone(recording: Recording) -> Recording:
    """Without joints and places."""
    assert recording.robot is not None and recording.q is not None
    orientation = RobotModel(recording.robot).sensor_poses(recording.q).rotation
    return replace(recording, q=None, robot=None, dq=None, orientation=orientation)


def diagnose(recording: Recording) -> Diagnosis:
    return examine(recording, fit_all=one_by_one)[0]


@pytest.mark.parametrize("rate_hz", [10.0, 20.0])
@pytest.mark.parametrize("with_joints", [True, False])
def test_a_sound_one_has_no_gap(rate_hz: float, with_joints: bool) -> None:
    recording = make(Condition(rate_hz=rate_hz), 3).recording
    assert diagnose(recording if with_joints else attitudes_alone(recording)).verdict == "no_gap"


@pytest.mark.parametrize("with_joints", [True, False])
def test_a_drift_is_named(with_joints: bool) -> None:
    recording = make(Condition(rate_hz=20.0, drift_n=2.0), 4).recording
    told = diagnose(recording if with_joints else attitudes_alone(recording))
    assert (told.verdict, told.effects[0].id) == ("explained", "sensor_drift")


def test_what_shows_how_it_went_is_told_from_what_does_not_and_from_a_list_of_poses() -> None:
    off = []
    for rate_hz in (10.0, 30.0):
        poses = poses_of(make(Condition(rate_hz=rate_hz), 3).recording)
        assert poses is not None
        off.append(find_way_off(poses))
        shuffled = poses.take(np.random.default_rng(0).permutation(len(poses.t)))
        assert find_way_off(shuffled) > 10.0 * STREAM
    assert off[1] < RESOLVED < off[0] < STREAM
