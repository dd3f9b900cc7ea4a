"""Turns about one place, attitudes alone, from point masses by Newton's law: nothing of the engine makes the recordings."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.estimation.identification import identify_recording
from core.estimation.turning import find_turning_place
from core.recording.recording import Recording

G = np.array([0.0, 0.0, -9.81])
MASSES = np.array([0.5, 0.3, 0.2])
PLACES = np.array([[0.02, 0.0, 0.08], [-0.03, 0.04, 0.05], [0.0, -0.02, 0.12]])
"""Of point masses, sensor frame, kg and m."""
R_TO_SENSOR = np.array([0.05, 0.0, 0.6])
RATE_HZ = 250.0
PERIOD = 1.0 / RATE_HZ


def turn(seed: int, *, angle: float = np.pi, arm: np.ndarray = R_TO_SENSOR, seconds: float = 6.0) -> Recording:
    """A smooth turn about an axis that is nearly the sensor's y, without its rests; the sensor is `arm` from the place."""
    rng = np.random.default_rng(seed)
    t = np.arange(-2, round((seconds + 1.0) * RATE_HZ) + 2) * PERIOD
    s = np.clip((t - 0.5) / seconds, 0.0, 1.0)
    shape = s**4 * (35.0 - 84.0 * s + 70.0 * s**2 - 20.0 * s**3)
    axis = np.array([0.1, 1.0, -0.05])
    R = Rotation.from_rotvec(angle * shape[:, None] * axis / np.linalg.norm(axis)).as_matrix()
    force, torque = np.zeros((len(t) - 2, 3)), np.zeros((len(t) - 2, 3))
    origin = R @ arm
    for mass, place in zip(MASSES, PLACES, strict=True):
        x = origin + R @ place
        f = mass * ((x[2:] - 2.0 * x[1:-1] + x[:-2]) / PERIOD**2 - G)
        force += f
        torque += np.cross(x[1:-1] - origin[1:-1], f)
    inside = R[1:-1]
    wrench = np.concatenate([np.einsum("nji,nj->ni", inside, each) for each in (force, torque)], axis=1)
    wrench += np.array([3.0, -2.0, 5.0, 0.1, -0.2, 0.05]) + rng.normal(size=wrench.shape) * [0.06, 0.06, 0.06, 0.003, 0.003, 0.003]
    moving = (s[1:-1] > 0.2) & (s[1:-1] < 0.8)
    return Recording(t=t[1:-1][moving] - t[1:-1][moving][0], gravity=G, wrench=wrench[moving], orientation=inside[moving])


def test_a_turn_about_one_axis_without_positions_tells_the_weight_and_where_it_is():
    found = [identify_recording(turn(seed)) for seed in range(3)]
    for answer in found:
        estimate = answer.estimate
        assert estimate is not None and estimate.determined[0]
        assert answer.warnings[0].code == "estimation-turned-about"
        std = np.sqrt(np.diag(estimate.covariance))
        assert abs(estimate.phi[0] - MASSES.sum()) < 3.0 * std[0] < 0.1 * MASSES.sum()
        truth = MASSES @ PLACES
        known = estimate.determined[1:4]
        assert known.any()
        assert (np.abs(estimate.phi[1:4] - truth)[known] < 3.5 * std[1:4][known]).all()


def test_the_place_is_found_to_within_its_uncertainty():
    for seed in range(4):
        place = find_turning_place(turn(seed))
        assert place is not None
        off = place.r - R_TO_SENSOR
        assert off @ np.linalg.solve(place.covariance, off) < 16.3  # chi-square of three, one in a thousand


@pytest.mark.parametrize("angle", [0.05, 0.3])
def test_a_sensor_that_is_hardly_turned_tells_nothing_of_the_weight(angle):
    assert find_turning_place(turn(0, angle=angle)) is None
    answer = identify_recording(turn(0, angle=angle))
    assert answer.estimate is None or not answer.estimate.determined.any()


def test_positions_that_are_known_are_used_as_they_are():
    made = turn(0)
    placed = Recording(t=made.t, gravity=G, wrench=made.wrench, orientation=made.orientation, position=made.orientation @ R_TO_SENSOR)
    assert find_turning_place(placed) is None


@pytest.mark.parametrize(("every", "seconds"), [(125, 30.0), (50, 30.0), (1, 0.6)], ids=["2 Hz", "5 Hz", "too short"])
def test_slow_and_short_turns_are_no_error(every: int, seconds: float):
    made = turn(0, seconds=seconds)
    assert made.wrench is not None and made.orientation is not None
    thin = Recording(t=made.t[::every], gravity=G, wrench=made.wrench[::every], orientation=made.orientation[::every])
    place = find_turning_place(thin)
    assert place is None or np.isfinite(place.covariance).all()
