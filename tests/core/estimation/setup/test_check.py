"""Slips of other people's loggers are named, and sound recordings are left alone."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.estimation.identification import identify_recording
from core.estimation.setup.check import check_setup
from core.gap.diagnosis import diagnose
from core.recording.folder import read_recording
from core.recording.recording import Recording, SensorDescription
from core.words.message import Message
from tests.independent_logs import SLIPS, SOUND, Log, Setting, make_log, slipped_log, sound_log

REAL = Path(__file__).resolve().parents[5] / "shared" / "real"
NAMES = {
    "sign": "the opposite sign of the wrench",
    "frame": "the wrench in the base's axes",
    "inverse": "the orientations inverted",
    "quaternion": "the quaternions in the order w, x, y, z",
    "force unit": "the force in",
    "torque unit": "the torque in",
    "time unit": "the time in",
    "angle unit": "the joint angles in degrees",
    "gravity": "gravity",
    "joints": ("the columns of", "the opposite sign of"),
    "millimetres": "the positions in mm",
    "axes": "the columns of force and torque",
    "torque point": "the torque about another point",
    "rate": "a clock that runs",
}


def read(log: Log, folder: Path) -> Recording:
    return read_recording(log.write(folder / "log"))


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Recording:
    """A motion of joints, 250 Hz, nothing wrong."""
    return read(make_log("motion", np.random.default_rng(3), Setting()), tmp_path_factory.mktemp("sound"))


@pytest.mark.parametrize("name", SLIPS)
def test_a_slip_is_named(name: str, tmp_path: Path) -> None:
    found = check_setup(read(slipped_log(name, 1), tmp_path)).contradiction
    assert found is not None
    wanted = NAMES[name]
    assert any(part in found.text for part in ([wanted] if isinstance(wanted, str) else wanted)), found.text
    assert found.say("de") != found.text


@pytest.mark.parametrize("seed", range(len(SOUND)), ids=SOUND)
def test_a_sound_recording_is_left_alone(seed: int, tmp_path: Path) -> None:
    found = check_setup(read(sound_log(seed), tmp_path))
    assert found.contradiction is None and found.remarks == ()


@pytest.mark.skipif(not REAL.exists(), reason="the real recordings are not at hand")
def test_real_recordings_are_sound_and_the_med14_s_tool_weighs_what_its_authors_say() -> None:
    for manifest in REAL.glob("*/recording.json"):
        found = check_setup(read_recording(manifest.parent))
        assert found.contradiction is None and found.remarks == ()
        if manifest.parent.name == "kuka-med14-static":
            assert found.weighed is not None and abs(found.weighed.mass - 0.932) < 0.01


def test_a_contradiction_is_an_answer_without_numbers_and_a_diagnosis_without_a_verdict(sound: Recording) -> None:
    assert sound.wrench is not None
    wrong = replace(sound, wrench=-sound.wrench)
    found = identify_recording(wrong)
    assert found.estimate is None
    assert "the opposite sign of the wrench" in found.verdict.text and "not determined" in found.verdict.text
    told = diagnose(wrong)
    assert told.verdict == "not_enough" and told.lacking is not None and told.lacking.code == "setup-mass-negative"


def contradiction(recording: Recording) -> Message:
    found = check_setup(recording).contradiction
    assert found is not None
    return found


def test_a_dead_sensor_and_a_dead_channel_are_refused_in_words(sound: Recording) -> None:
    assert sound.wrench is not None
    zero = replace(sound, wrench=np.zeros_like(sound.wrench))
    assert contradiction(zero).code == "setup-wrench-zero"
    assert identify_recording(zero).estimate is None
    assert contradiction(replace(sound, wrench=np.ones_like(sound.wrench))).code == "setup-wrench-constant"
    dead = sound.wrench.copy()
    dead[:, 1] = 2.5
    assert contradiction(replace(sound, wrench=dead)).parameters == {"channel": "fy"}


def test_newton_millimetres_without_any_motion_are_seen_by_the_lever(tmp_path: Path) -> None:
    log = make_log("averaged", np.random.default_rng(4), Setting(stated=False))
    log.put(("tx", "ty", "tz"), 1e3 * log.block("tx", "ty", "tz"))
    found = contradiction(read(log, tmp_path))
    assert found.code == "setup-lever-too-long" and "N mm" in found.parameters["units"]


@pytest.mark.parametrize("scale", [1.0 / 9.80665, 1.0 / 4.4482216])
def test_force_and_torque_in_the_same_other_system_are_seen_by_the_steps_of_the_sensor(sound: Recording, scale: float) -> None:
    """Nothing in the motion can tell: everything is as if the payload were lighter."""
    assert sound.wrench is not None
    force = sound.wrench * np.repeat([scale, 1.0], 3)
    assert contradiction(replace(sound, wrench=force)).text.count("the force in") == 1
    both = replace(sound, wrench=sound.wrench / 9.80665)
    assert contradiction(both).code == "setup-figures-agree"
    assert "the force in kgf and the torque in kgf m" in contradiction(both).text
    assert check_setup(replace(both, sensor=SensorDescription())).contradiction is None


def test_velocities_tell_a_wrong_clock_where_the_payload_cannot(sound: Recording) -> None:
    assert sound.q is not None
    dq = np.gradient(sound.q, sound.t, axis=0)
    light = replace(sound, dq=dq, wrench=1e-3 * np.random.default_rng(0).normal(size=(len(sound), 6)))
    assert check_setup(light).contradiction is None
    assert "4 times" in contradiction(replace(light, t=4.0 * light.t)).text


def test_rows_that_repeat_the_one_before_are_remarked_on(sound: Recording) -> None:
    assert sound.wrench is not None and sound.q is not None
    held = 3 * (np.arange(len(sound)) // 3)
    found = check_setup(replace(sound, wrench=sound.wrench[held], q=sound.q[held]))
    assert [each.code for each in found.remarks] == ["setup-rows-repeated"]
    assert abs(found.remarks[0].parameters["share"] - 2 / 3) < 0.02
