"""Sensors that stay level, on palletisers, or do not move at all: what can be said is said. Wrenches are Newton's for one point mass."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from core.gap.basis import basis_of
from core.gap.diagnosis import diagnose
from core.gap.effect_fit import fit_nominal
from core.gap.windows import Windows
from core.recording.recording import Recording, SensorDescription

GRAVITY = np.array([0.0, 0.0, -9.81])
MASS, CENTRE = 5.0, np.array([0.03, -0.02, 0.15])
OFFSET = np.array([4.0, -7.0, 20.0, 0.3, 0.1, -0.2])
NOISE_STD = np.repeat([0.1, 0.005], 3)
RATE, LASTS_S, PLACES = 125.0, 50.0, 21


def carried(*, seed: int, tilt_rad: float = 0.0, moves: bool = True) -> Recording:
    """A tool that is carried from place to place, upright and turned about the vertical; or stands where it is."""
    rng = np.random.default_rng(seed)
    t = np.arange(0.0, LASTS_S, 1.0 / RATE)
    knots = np.linspace(0.0, LASTS_S, PLACES)
    places = (
        rng.uniform([0.6, -0.5, 0.3, -2.5], [1.2, 0.5, 0.9, 2.5], size=(PLACES, 4)) if moves else np.tile([0.9, 0.0, 0.5, 0.0], (PLACES, 1))
    )
    way = CubicSpline(knots, places, bc_type="clamped")
    x, yaw = way(t)[:, :3], way(t)[:, 3]
    R = Rotation.from_euler("z", yaw[:, None]).as_matrix() @ Rotation.from_euler("x", [np.pi]).as_matrix()
    turn, turned = np.outer(way(t, 1)[:, 3], [0.0, 0.0, 1.0]), np.outer(way(t, 2)[:, 3], [0.0, 0.0, 1.0])
    r = R @ CENTRE
    a = way(t, 2)[:, :3] + np.cross(turned, r) + np.cross(turn, np.cross(turn, r))
    force = np.einsum("nji,nj->ni", R, MASS * (a - Rotation.from_rotvec([tilt_rad, 0.0, 0.0]).apply(GRAVITY)))
    read = np.hstack((force, np.cross(CENTRE, force))) + OFFSET + NOISE_STD * rng.normal(size=(len(t), 6))
    return Recording(t, GRAVITY, wrench=read, orientation=R, position=x, sensor=SensorDescription(noise_std=NOISE_STD))


def test_a_sound_palletiser_has_no_gap_and_its_accelerations_show_the_mass() -> None:
    told = diagnose(carried(seed=1))
    assert told.verdict == "no_gap"
    assert told.payload is not None
    assert told.payload.after.phi[0] == pytest.approx(MASS, abs=3.0 * told.payload.after.std[0])
    assert told.payload.after.std[0] < 0.02 * MASS
    assert "gap-hardly-turns" in [limit.code for limit in told.limits]


def test_a_base_that_is_not_level_shows_where_the_sensor_turns_about_the_vertical_alone() -> None:
    told = diagnose(carried(seed=2, tilt_rad=0.03))
    assert (told.verdict, told.effects[0].id) == ("explained", "base_tilt")
    assert abs(told.effects[0].parameters["about_x_rad"].value) == pytest.approx(0.03, abs=0.003)


def test_what_never_rests_is_left_out_in_pieces_and_predicted_from_the_others() -> None:
    tilted = carried(seed=2, tilt_rad=0.03)
    tilted.wrench[tilted.t > 0.5 * LASTS_S] += [3.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    windows = Windows(basis_of(tilted))
    assert 10 <= len(np.unique(windows.group)) <= 12
    assert set(windows.phase) == {"transfer"}
    nominal = fit_nominal(windows)
    assert float(nominal.held_out.sum()) == pytest.approx(float(np.square(nominal.residual).sum()), rel=0.15)


def test_a_zero_that_jumps_shows_while_nothing_moves_but_no_payload_does() -> None:
    still = carried(seed=3, moves=False)
    still.wrench[still.t > 0.4 * LASTS_S] += [2.0, 1.0, -1.5, 0.05, 0.02, 0.0]
    told = diagnose(still)
    assert (told.verdict, told.effects[0].id) == ("explained", "sensor_offset_step")
    assert told.effects[0].parameters["step_time_s"].value == pytest.approx(0.4 * LASTS_S, abs=0.1)
    assert told.payload is not None
    assert told.payload.after.determined == [False] * 10
    reasons = {str(limit.parameters["effect"]): limit.parameters["reason"].code for limit in told.limits if limit.code == "gap-not-shown"}
    assert reasons["sensor_creep"] == "effect-nothing-moves"


def test_nothing_is_wrong_with_a_sensor_that_stands_still() -> None:
    assert diagnose(carried(seed=4, moves=False)).verdict == "no_gap"
