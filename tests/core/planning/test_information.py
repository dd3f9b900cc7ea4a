"""What motions are expected to tell, against the paper's formula and against the exact kinematics of recordings of another make."""

from __future__ import annotations

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.payload.inertia import InertialParameters, Motion, regressor
from core.planning.information import Worth, choose_holds, find_information, find_seconds
from core.planning.plan import Leg
from core.planning.settings import Timing
from core.planning.start_configuration import StartConfiguration
from core.planning.stop import Stop, Swings
from core.planning.transfer import Transfer
from core.requirement.target import Target
from core.robot.decoupling import count_accelerating_samples, decoupling_profile
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile, JointTrajectory
from tests.synthetic import CELLS, GRAVITY, run_of

CELL = load_cell(CELLS / "lwr4_bench")
ROBOT = RobotModel.of_cell(CELL)
NOISE = np.array(CELL.sensor.noise_std)
BLOCK = InertialParameters.from_com(2.0, [0.0, 0.0, 0.05], np.diag([0.003, 0.004, 0.005]))
NO_TIME = Timing(hold_s=0.0, settle_s=0.0)


def leg(q: np.ndarray, profile: AngularProfile | None = None) -> Leg:
    """A way through joint positions q (N, n), a millisecond each, and a rotation about x at its end."""
    start = StartConfiguration("x+", q[-1], 0.0, 1.0, 1.0, "", 0.1, None, 1, "x")
    swings = None if profile is None else Swings(about="x")
    return Leg(Stop(down=(1.0, 0.0, 0.0), swings=swings), start, Transfer(JointTrajectory(0.001, q), 0.1, 0.1, "", 1.0), profile)


def standing(samples: int = 2) -> np.ndarray:
    return np.tile(np.array(CELL.robot.home_rad), (samples, 1))


def test_one_swing_tells_as_much_of_the_moment_about_its_axis_as_the_papers_formula_says():
    profile = decoupling_profile(CELL.payload_box, cartesian_speed=0.2, period=0.001, repetitions=3)
    once = decoupling_profile(CELL.payload_box, cartesian_speed=0.2, period=0.001)
    told = find_information(CELL, ROBOT, [leg(standing(), profile)], NO_TIME)
    acceleration = np.abs(np.diff(once.rate)).max() / once.period
    std = NOISE[3] / (acceleration * np.sqrt(count_accelerating_samples(once)))
    assert told[4, 4] == pytest.approx(std**-2, rel=0.05)


def test_a_transfer_tells_what_its_exact_kinematics_say():
    run = run_of("lwr4_bench", axes="x", rotate=False)
    g = np.einsum("kji,j->ki", run.rotation, GRAVITY)
    a = np.einsum("kji,kj->ki", run.rotation, run.a)
    V = regressor(Motion(g, a, run.omega, run.alpha))
    rows = np.concatenate((V, np.broadcast_to(np.eye(6), (len(V), 6, 6))), axis=2) / NOISE[:, None]
    exact = np.einsum("kci,kcj->ij", rows, rows)
    told = find_information(CELL, ROBOT, [leg(run.q)], NO_TIME)
    size = np.sqrt(np.outer(np.diag(exact), np.diag(exact)))
    assert np.abs((told - exact) / size).max() < 0.03


def test_a_hold_tells_in_proportion_to_its_time_and_nothing_of_the_inertia():
    one, two = (find_information(CELL, ROBOT, [leg(standing())], Timing(hold_s=hold_s)) for hold_s in (1.0, 2.0))
    still = find_information(CELL, ROBOT, [leg(standing())], NO_TIME)
    np.testing.assert_allclose(two - still, 2.0 * (one - still), rtol=1e-9, atol=1e-9 * np.abs(one).max())
    assert (one[4:10] == 0.0).all()
    # a hold of a second has a thousand samples, each of which has the weight on the force's channels
    g = ROBOT.sensor_pose(standing()[0]).rotation.T @ CELL.gravity
    assert (one - still)[0, 0] == pytest.approx(1000.0 * np.sum((g / NOISE[:3]) ** 2), rel=1e-9)


def test_time_counts_what_has_to_be_done_once():
    profile = decoupling_profile(CELL.payload_box, cartesian_speed=0.2, period=0.001, repetitions=4)
    assert find_seconds([leg(standing(1001))], Timing(hold_s=1.5)) == pytest.approx(2.5)
    turned_s = find_seconds([leg(standing(1001), profile)], Timing(hold_s=1.5, settle_s=1.0))
    assert turned_s == pytest.approx(3.5 + profile.duration / 4)


def test_with_a_target_only_what_it_names_is_worth_anything():
    known = np.diag(np.full(16, 1e4))
    more = known.copy()
    more[9, 9] *= 100.0
    mass = Worth(Target(mass_share=0.01), BLOCK)
    assert mass.find_size(more) == pytest.approx(mass.find_size(known), abs=1e-9)
    for worth in (Worth(Target(inertia_share=0.01), BLOCK), Worth(None, BLOCK), Worth(Target(requirement=True), BLOCK)):
        assert worth.find_size(more) < worth.find_size(known)


def test_a_target_that_is_met_is_a_size_of_one_share():
    """One quantity, known exactly as well as is wanted: the squared standard deviation over the target is one."""
    std = 0.01 * BLOCK.mass
    known = np.diag(np.full(16, 1e12))
    known[0, 0] = std**-2
    assert Worth(Target(mass_share=0.01), BLOCK).find_size(known) == pytest.approx(0.0, abs=1e-3)


def test_holds_are_short_where_the_inertia_is_wanted_and_as_stated_where_only_they_tell():
    """The mass shows most where opposite sides point down, so standing there tells more each second than the way between."""
    there = standing()[0] + [0.0, 0.0, 0.0, 0.0, 0.0, np.pi, 0.0]
    way = np.linspace(standing()[0], there, 3001)
    profile = decoupling_profile(CELL.payload_box, cartesian_speed=0.2, period=0.001)
    legs = [leg(standing()), leg(way, profile)]
    inertia, mass = (Worth(target, BLOCK) for target in (Target(inertia_share=0.01), Target(mass_share=0.001)))
    assert choose_holds(CELL, ROBOT, legs, Timing(), inertia) == Timing(hold_s=0.5, settle_s=0.5)
    assert choose_holds(CELL, ROBOT, legs, Timing(), mass) == Timing()
    assert choose_holds(CELL, ROBOT, legs, Timing(hold_s=0.3, settle_s=0.2), inertia) == Timing(hold_s=0.3, settle_s=0.2)
