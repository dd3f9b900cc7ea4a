"""The diagnosis of lists of poses: what they can show is found, and what they cannot is said. Wrenches are worked out here, by statics."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.gap.answer import Diagnosis
from core.gap.diagnosis import diagnose
from core.payload.inertia import InertialParameters
from core.recording.folder import read_recording
from core.recording.recording import Recording, SensorDescription

REAL = Path(__file__).parents[4] / "shared" / "real"
GRAVITY = np.array([0.0, 0.0, -9.81])
MASS, CENTRE = 2.4, np.array([0.02, -0.01, 0.09])
FORCE_STD, TORQUE_STD = 0.02, 0.001
POSES, EVERY_S = 30, 4.0


def poses(*, seed: int, tilt_rad: float = 0.0, matrix: np.ndarray | None = None, drift: float = 0.0, count: int = POSES) -> Recording:
    """A body held still in random attitudes; its base may be tilted about x, its sensor be any linear one and drift, N in the whole."""
    rng = np.random.default_rng(seed)
    R = Rotation.random(count, random_state=rng).as_matrix()
    g = (Rotation.from_rotvec([tilt_rad, 0.0, 0.0]).as_matrix() @ GRAVITY) @ R
    load = np.hstack((-MASS * g, -MASS * np.cross(CENTRE, g)))
    t = EVERY_S * np.arange(count)
    offset = np.array([1.0, -2.0, 0.5, 0.02, 0.0, -0.03])
    read = offset + (load if matrix is None else load @ matrix.T) + np.outer(t / t[-1], [drift, 0.0, -drift, 0.0, 0.0, 0.0])
    read += rng.normal(size=(count, 6)) * np.repeat([FORCE_STD, TORQUE_STD], 3)
    return Recording(t=t, gravity=GRAVITY, wrench=read, orientation=R)


def best(diagnosis: Diagnosis) -> str:
    """What is named."""
    assert diagnosis.verdict in ("explained", "ambiguous"), diagnosis.summary.text
    return diagnosis.effects[0].id


@pytest.mark.parametrize("seed", range(6))
def test_poses_of_a_sound_set_up_have_no_gap_and_show_the_payload(seed):
    diagnosis = diagnose(poses(seed=seed))
    assert diagnosis.verdict == "no_gap"
    mass, *moment = diagnosis.payload.after.phi[:4]
    assert mass == pytest.approx(MASS, rel=0.005)
    np.testing.assert_allclose(moment, MASS * CENTRE, atol=0.002)


def test_a_base_that_is_not_level_is_named_and_sized():
    diagnosis = diagnose(poses(seed=1, tilt_rad=0.03))
    assert best(diagnosis) == "base_tilt"
    found = diagnosis.effects[0].parameters["about_x_rad"]
    assert abs(found.value - 0.03) < 3.0 * found.std + 1e-3
    assert diagnosis.effects[0].closure > 0.9
    assert diagnosis.where.stage == "mounting"
    assert diagnosis.payload.after.determined == [True] * 4 + [False] * 6
    assert diagnosis.consequence.code == "gap-payload-changed-but-inertia"


def test_of_a_slow_stream_with_labels_the_holds_count():
    held = poses(seed=3, count=120, tilt_rad=0.03)
    moving = np.arange(120) % 3 == 2
    read = held.wrench + np.where(moving, 5.0, 0.0)[:, None]  # what the arm's acceleration adds
    diagnosis = diagnose(replace(held, wrench=read, phase=np.where(moving, "move", "hold")))
    assert best(diagnosis) == "base_tilt"
    assert abs(diagnosis.effects[0].parameters["about_x_rad"].value - 0.03) < 2e-3


def test_a_drift_over_the_poses_is_named():
    assert best(diagnose(poses(seed=2, drift=1.0))) == "sensor_drift"


def test_a_channel_that_shows_in_another_is_named():
    matrix = np.eye(6)
    matrix[0, 2], matrix[1, 0] = 0.04, -0.03
    assert best(diagnose(poses(seed=3, matrix=matrix))) == "sensor_crosstalk"


def test_what_happens_between_poses_is_said_to_be_out_of_sight():
    limits = diagnose(poses(seed=1)).limits
    assert [limit.code for limit in limits[:2]] == ["gap-of-poses", "gap-noise-of-poses"]
    assert {"sensor_hysteresis", "time_delay", "tool_flexibility", "cable_drag"} <= {limit.parameters.get("effect") for limit in limits}


def test_so_few_poses_that_noise_is_not_told_from_a_gap_are_not_enough():
    diagnosis = diagnose(poses(seed=1, count=15))
    assert (diagnosis.verdict, diagnosis.lacking.code) == ("not_enough", "gap-too-few-poses")


def test_a_stated_noise_holds_where_no_linear_sensor_leaves_so_little():
    recording = poses(seed=4)
    recording.wrench[:, 0] += 0.4 * np.sign(recording.wrench[:, 0])  # nothing linear
    stated = np.repeat([FORCE_STD, TORQUE_STD], 3)
    told = diagnose(Recording(**{**vars(recording), "sensor": SensorDescription(noise_std=stated)}))
    silent = diagnose(recording)
    assert told.gap.before > 2.0 * silent.gap.before


def test_real_poses_get_the_mass_that_their_authors_state_and_no_name_for_attitudes_that_are_a_degree_off():
    """Residual force and torque go together as if gravity turned by about 1 deg from pose to pose: the attitudes are commanded ones."""
    diagnosis = diagnose(read_recording(REAL / "kuka-med14-static"))
    assert diagnosis.verdict == "unknown"
    assert diagnosis.gap.before < 3.0
    assert diagnosis.where.stage is None
    assert diagnosis.payload.after.phi[0] == pytest.approx(0.932, rel=0.005)


def test_real_poses_with_gravity_turned_by_9_degrees_are_those_of_a_tilted_base():
    recording = read_recording(REAL / "kuka-med14-static")
    turned = Rotation.from_rotvec([0.164, 0.0, 0.0]).as_matrix()
    diagnosis = diagnose(Recording(**{**vars(recording), "orientation": turned @ recording.orientation}))
    assert best(diagnosis) == "base_tilt"
    assert abs(diagnosis.effects[0].parameters["about_x_rad"].value) == pytest.approx(0.164, abs=0.01)
    assert diagnosis.payload.after.phi[0] == pytest.approx(0.932, rel=0.01)


def test_a_list_with_a_reference_says_beside_the_verdict_how_far_it_is_off():
    heavier = InertialParameters.from_com(1.1 * MASS, CENTRE, 0.01 * np.eye(3))
    diagnosis = diagnose(Recording(**{**vars(poses(seed=5)), "reference": heavier, "reference_source": "CAD"}))
    assert diagnosis.verdict == "no_gap"
    assert [it.id for it in diagnosis.also if it.material] == ["payload_mismatch"]
