"""Candidates of next motions: what they ask of the sensor, by kinematics alone, and what they are predicted to tell."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from core.cell.folder import find_cell, load_cell
from core.effects.library import library
from core.estimation.kinematics import Poses, axial, poses_of
from core.estimation.segments import segments_of_phase
from core.gap.basis import build_unchecked_basis
from core.gap.candidate_motions import candidates
from core.gap.effect_fit import EffectFit, fit_effects, fit_nominal
from core.gap.prediction import Prediction
from core.gap.proposal import proposals
from core.gap.rehearsal import rehearse
from core.gap.tie import Tie, distance_sigma
from core.gap.windows import Windows
from core.payload.inertia import Motion
from core.payload.rigid_wrench import wrench
from core.planning.stop import Stop, Swings, Wave
from core.recording.recording import Recording, SensorDescription, append_recording
from core.robot.model import RobotModel

CELL = load_cell(find_cell("lwr4_bench"))
DOWN = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
DELAY_S = 0.012


def made(stops: tuple[Stop, ...], rng: np.random.Generator) -> Recording:
    """The cylinder carried through stops, its wrench 12 ms late and noisy, at 1 kHz."""
    robot = RobotModel.of_cell(CELL)
    noise = np.array(CELL.sensor.noise_std)
    home = np.array(CELL.robot.home_rad)
    start = Recording(
        t=np.array([0.0, 0.001]),
        gravity=CELL.gravity,
        q=np.stack((home, home)),
        robot=robot.description,
        sensor=SensorDescription(noise_std=noise),
    )
    path = rehearse(start, poses_of(start), stops)
    late = wrench(kinematics(path, path.t - DELAY_S), CELL.payloads["cylinder"].parameters.phi)
    fields = {**vars(path), "wrench": late + rng.normal(0.0, noise, late.shape), "q": path.q + rng.normal(0.0, 2e-6, path.q.shape)}
    return Recording(**fields)


def kinematics(path: Recording, t: np.ndarray) -> Motion:
    """Motion at times t, from splines through exact poses."""
    poses = poses_of(path)
    R, p = CubicSpline(path.t, poses.rotation), CubicSpline(path.t, poses.position)
    t = np.clip(t, path.t[0], path.t[-1])
    back = np.swapaxes(R(t), 1, 2)
    a = np.einsum("nij,nj->ni", back, p(t, 2))
    return Motion(np.einsum("nij,j->ni", back, CELL.gravity), a, axial(back @ R(t, 1)), axial(back @ R(t, 2)))


FIRST = tuple(Stop(down=down, swings=Swings(about=axis, repetitions=3)) for axis, down in DOWN.items())
NEXT = Stop(down=DOWN["x"], swings=Swings(about="z", repetitions=10))
SHAKEN = Stop(down=DOWN["x"], wave=Wave(lowest_hz=3.0, highest_hz=9.0, seconds=10.0))


@cache
def recorded() -> Recording:
    """Rotations about the vertical alone, three swings each."""
    return made(FIRST, np.random.default_rng(2))


def fitted(recording: Recording) -> tuple[Windows, tuple[EffectFit, EffectFit]]:
    """Delay and filter."""
    windows = Windows(build_unchecked_basis(recording, poses_of(recording), recording.wrench))
    nominal = fit_nominal(windows)
    scene = windows.basis.scene.with_phi(nominal.phi)
    still = np.zeros((len(scene), 6))
    by_id = {effect.id: effect for effect in library()}
    fits = [fit_effects(windows, (by_id[name],), nominal, by_id[name].starts(scene, still)) for name in ("time_delay", "sensor_lowpass")]
    return windows, (fits[0], fits[1])


def gravity(recording: Recording) -> tuple[Poses, np.ndarray]:
    """Poses, and gravity's direction in the sensor frame."""
    poses = poses_of(recording)
    return poses, poses.g / np.linalg.norm(poses.g, axis=1, keepdims=True)


def test_all_kinds_of_motions_are_among_the_candidates():
    segments = segments_of_phase(recorded().phase)
    found = {motion.id: motion for motion in candidates(recorded(), segments, poses_of(recorded()).g)}
    assert {"tilted_holds", "revisit", "both_sides", "wide_band_slow", "wide_band_fast", "other_posture"} <= set(found)
    assert {f"swings_about_horizontal_{axis}" for axis in "xyz"} <= set(found)
    for motion in found.values():
        assert motion.stops
        for stop in motion.stops:
            assert np.linalg.norm(stop.down) == pytest.approx(1.0)
            assert stop.swings is None or abs(stop.down["xyz".index(stop.swings.about)]) < 1e-9  # gravity sweeps


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_a_rehearsed_rotation_turns_about_its_axis_in_place(axis):
    start = recorded()
    vertical = DOWN["xyz"[("xyz".index(axis) + 1) % 3]]
    path = rehearse(start, poses_of(start), (Stop(down=vertical, swings=Swings(about=axis, repetitions=2)),))
    poses, down = gravity(path)
    turning = path.phase == f"rotate:{axis}"
    assert np.abs(down[turning, "xyz".index(axis)]).max() < 2e-3  # the axis stays horizontal
    angle = np.arccos(np.clip(down[turning] @ vertical, -1.0, 1.0))
    assert angle.max() == pytest.approx(0.25, abs=0.02)
    assert np.linalg.norm(poses.position - poses.position[0], axis=1).max() < 1e-3


def test_another_posture_has_the_same_attitude_with_other_joints():
    start = recorded()
    q = start.q[np.flatnonzero(start.phase == "hold:z+")[0]]
    path = rehearse(start, poses_of(start), (Stop(down=DOWN["z"], away_from_rad=tuple(q)),))
    _, down = gravity(path)
    np.testing.assert_allclose(down[-1], DOWN["z"], atol=2e-3)
    assert np.abs(path.q[-1] - q).max() > 1.0


def test_the_distance_that_is_predicted_is_the_one_that_is_reached():
    windows, fits = fitted(recorded())
    path = rehearse(recorded(), poses_of(recorded()), (SHAKEN,))
    before = distance_sigma(windows, *fits)
    predicted = np.hypot(before, Prediction(windows, path, fits[0]).distance_sigma(*fits))
    both = append_recording(recorded(), made((SHAKEN,), np.random.default_rng(3)))
    windows, fits = fitted(both)
    reached = np.sqrt(fits[1].cost - fits[0].cost)  # twice the logarithm of the likelihood ratio, the truth being a delay
    assert predicted == pytest.approx(reached, abs=2.0 + 0.1 * reached)
    assert predicted > 1.3 * before


def test_the_proposal_settles_the_worst_tie_and_standing_still_does_not():
    windows, fits = fitted(recorded())
    tie = Tie(*fits, distance_sigma(windows, *fits))
    best = proposals(recorded(), windows, [tie])[0]
    still = rehearse(recorded(), poses_of(recorded()), (Stop(down=DOWN["x"]),))
    assert Prediction(windows, still, fits[0]).distance_sigma(*fits) < 0.5
    assert best.after > 2.0 * max(best.before, 1.0)
    assert best.motion.stops
    assert best.answer.splits == [("time_delay", "sensor_lowpass")]


def test_where_no_motion_helps_a_second_payload_is_asked_for():
    windows, (delay, _) = fitted(recorded())
    same = proposals(recorded(), windows, [Tie(delay, delay, 0.0)])  # two names for one thing
    assert [proposal.motion.id for proposal in same] == ["second_payload"]
    assert same[0].after == pytest.approx(0.0, abs=1e-6)
    assert not same[0].motion.stops


def test_without_ties_nothing_is_proposed():
    windows, _ = fitted(recorded())
    assert proposals(recorded(), windows, []) == ()


def test_what_is_clear_already_needs_no_motion_and_one_that_adds_nothing_is_not_proposed():
    windows, (delay, lowpass) = fitted(recorded())
    assert proposals(recorded(), windows, [Tie(delay, lowpass, 7.0)]) == ()
    (instead,) = proposals(recorded(), windows, [Tie(delay, delay, 5.0)])  # both recordings together would reach 5 without any motion
    assert not instead.motion.stops


def test_a_recording_of_poses_without_joints_is_rehearsed_too():
    poses = poses_of(recorded())
    bare = Recording(t=recorded().t, gravity=CELL.gravity, orientation=poses.rotation, position=poses.position)
    path = rehearse(bare, poses, (NEXT,))
    _, down = gravity(path)
    assert path.q is None
    assert np.abs(down[path.phase == "rotate:z", 2]).max() < 2e-3
