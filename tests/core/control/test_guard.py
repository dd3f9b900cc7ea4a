from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.cell.cell import Pose
from core.control.execute import execute
from core.control.guard import REACTION
from core.control.movers import Playback, StandStill
from core.errors import BadState, OutOfLimits, OverLoad, RobotStateLate, SensorFrozen, TooClose, TooFast
from core.robot.trajectory import JointTrajectory
from core.sessions.session import RobotState
from tests.core.control.kinematic_session import CELLS, PERIOD, KinematicSession, approach, bench, fresh_bench, spoiled_after


def at(index: int, value: float):
    """A change of one element of what a state holds."""

    def change(array: np.ndarray) -> np.ndarray:
        array = array.copy()
        array[index] = value
        return array

    return change


FAULTS = {
    "position": ({"q": lambda s: at(2, np.nan)(s.q)}, BadState, "state is not finite"),
    "velocity": ({"dq": lambda s: at(2, np.inf)(s.dq)}, BadState, "state is not finite"),
    "dead wrench": ({"wrench": np.full(6, np.nan)}, BadState, "state is not finite"),
    "no clock": ({"t": np.nan}, BadState, "state is not finite"),
    "frozen clock": ({"t": 0.1}, BadState, r"went on by 0\.00 ms in one period \(expected 1\.00 ms\), its state is stale"),
    "clock backwards": ({"t": lambda s: 0.2 - s.t}, BadState, "stale"),
    "late": ({"t": lambda s: s.t + 0.02}, RobotStateLate, r"came after 21\.0 ms \(limit 10\.0 ms\)"),
    "frozen wrench": ({"wrench": np.ones(6)}, SensorFrozen, r"has not changed for 0\.25\d s \(limit 0\.250 s\)"),
    "past a limit": ({"q": lambda s: at(1, 2.11)(s.q)}, OutOfLimits, r"joint joint2 is at 2\.1100 rad \(limit 2\.0944 rad\)"),
    "below a limit": ({"q": lambda s: at(1, -2.11)(s.q)}, OutOfLimits, r"joint joint2 is at -2\.1100 rad \(limit -2\.0944 rad\)"),
    "joint speed": ({"dq": lambda s: at(6, -3.8)(s.dq)}, TooFast, r"joint joint7 moves at -3\.800 rad/s \(limit 3\.2"),
    "speed": ({"dq": lambda s: at(0, 0.6)(s.dq)}, TooFast, r"payload moves at 0\.\d+ m/s \(limit 0\.250 m/s\)"),
    "overload": ({"wrench": lambda s: at(2, -290.0)(s.wrench)}, OverLoad, r"fz of ATI Mini45 is -290\.00 N \(range 290\.00 N\)"),
    "overload torque": ({"wrench": lambda s: at(4, 4.9999)(s.wrench)}, OverLoad, r"ty of ATI Mini45 is 5\.00 N m"),
    "tracking": ({"q": lambda s: at(3, s.q[3] + 0.06)(s.q)}, BadState, r"joint joint4 is 0\.0600 rad from its command"),
}


@pytest.mark.parametrize("name", FAULTS)
def test_a_planted_fault_stops_the_robot_with_a_sentence_and_the_last_samples(name):
    changes, error, sentence = FAULTS[name]
    session = KinematicSession(bench().home, spoiled_after(0.1, **changes))
    guard = bench().guard()
    with pytest.raises(error, match=sentence) as caught:
        list(execute(session, guard, StandStill(2.0, PERIOD), "hold:free"))
    assert type(caught.value) is error
    assert "; the robot was stopped. " in str(caught.value)
    assert session.stops == 1
    samples = caught.value.samples
    assert len(samples) == min(session.k + 1, 500)
    times = [sample.t for sample in samples[:-1]]
    assert times == sorted(times)
    assert len(session.commands) == session.k  # the tick with the fault commanded nothing


def test_a_sensor_that_dies_at_the_end_of_a_phase_is_noticed_as_soon_in_the_next():
    session = KinematicSession(bench().home, spoiled_after(0.1, wrench=np.ones(6)))
    guard = bench().guard()
    list(execute(session, guard, StandStill(0.2, PERIOD), "hold:free"))
    with pytest.raises(BadState, match="the wrench has not changed") as caught:
        list(execute(session, guard, StandStill(2.0, PERIOD), "hold:free"))
    assert caught.value.samples[-1].t == pytest.approx(0.1 + 0.25, abs=0.005)


def test_the_same_motion_without_a_fault_passes():
    session = KinematicSession(bench().home)
    guard = bench().guard()
    batches = list(execute(session, guard, StandStill(1.0, PERIOD), "hold:free"))
    assert sum(len(batch.states) for batch in batches) == 1001
    assert guard.record.ticks == 1001 and session.stops == 0
    beyond, first = (
        find(bench().home).distance_m for find in (bench().collision.obstacle_distance, bench().collision.find_nearest_left_out)
    )
    assert guard.record.beyond_first_m == pytest.approx(beyond)
    assert guard.record.min_distance_m == pytest.approx(min(beyond, first))
    assert guard.record.nearest is not None and guard.record.nearest.distance_m == guard.record.min_distance_m
    assert guard.record.min_margin_m == pytest.approx(bench().collision.margin(bench().home))
    assert [round(t, 6) for t, _ in guard.distances] == [round(0.02 * k, 6) for k in range(51)]


def state_at_home() -> RobotState:
    q = bench().home
    return RobotState(0.0, q, np.zeros_like(q), q, np.zeros(6))


@pytest.mark.parametrize(
    ("target", "error", "sentence"),
    [
        (at(3, np.nan), BadState, "commanded position is not finite"),
        (at(3, 2.2), OutOfLimits, r"joint joint4 was commanded to 2\.2000 rad"),
        (lambda q: at(3, q[3] + 0.003)(q), TooFast, r"joint joint4 was commanded at 3\.000 rad/s"),
        (lambda q: at(0, q[0] + 0.0005)(q), TooFast, r"payload was commanded at 0\.\d+ m/s \(limit 0\.250 m/s\)"),
    ],
)
def test_a_command_is_checked_before_it_goes_out(target, error, sentence):
    with pytest.raises(error, match=sentence):
        bench().guard().check(state_at_home(), target(bench().home))


def test_measurement_noise_is_tolerated_at_a_limit_but_a_command_is_not():
    state = state_at_home()
    edge = bench().home.copy()
    edge[6] = bench().robot.upper[6]
    noisy = edge + at(6, 1e-3)(np.zeros(7))
    bench().guard().check(replace(state, q=noisy, q_cmd=edge), edge)
    with pytest.raises(OutOfLimits):
        bench().guard().check(replace(state, q=noisy, q_cmd=edge), noisy)


def test_a_pause_between_two_phases_is_no_fault_but_one_within_a_phase_is():
    guard = bench().guard()
    guard.check(state_at_home(), bench().home)
    guard.begin()
    guard.check(replace(state_at_home(), t=7.0), bench().home)
    with pytest.raises(BadState, match="came after"):
        guard.check(replace(state_at_home(), t=9.0), bench().home)


def test_a_zone_that_moves_in_stops_the_robot_within_its_sampling_time():
    it = fresh_bench()
    session = KinematicSession(it.home)

    def move_in(state: RobotState) -> RobotState:
        if session.k == 105:
            payload = it.robot.sensor_pose(it.home).position
            it.collision.move("operator", Pose(xyz_m=(payload[0] + 0.5 + 0.1, payload[1], payload[2])))
        return state

    session.spoil = move_in
    with pytest.raises(
        TooClose, match=r'is -?0\.0\d{4} m from zone "operator" \(limit 0\.030 m\); the robot was stopped\. Clear the zone'
    ) as caught:
        list(execute(session, it.guard(), StandStill(1.0, PERIOD), "hold:free"))
    assert 105 <= session.k <= 125
    assert caught.value.value < caught.value.limit == 0.03


@pytest.mark.parametrize("name", CELLS)
@pytest.mark.parametrize("seed", range(8))
def test_it_stops_at_the_very_tick_that_checking_everything_exactly_would(name, seed):
    it = bench(name)
    q = approach(name, seed)
    session = KinematicSession(q[0])
    guard = it.guard()
    with pytest.raises(TooClose) as caught:
        list(execute(session, guard, Playback(JointTrajectory(PERIOD, q)), "transfer"))
    stopped_at = session.k
    acceleration = np.array(it.cell.robot.acceleration_rad_s2)
    dq = np.diff(q, axis=0, prepend=q[:1]) / PERIOD
    braking = np.max(np.abs(dq) / acceleration, axis=1, keepdims=True)
    stop = q + dq * (REACTION * PERIOD + braking / 2)
    unsafe = [k for k in range(stopped_at + 1) if it.collision.margin(q[k]) < 0 or it.collision.margin(stop[k]) < 0]
    assert unsafe == [stopped_at]
    assert it.collision.margin(q[stopped_at]) > -1e-3  # what a single period can do
    assert caught.value.samples[-1].t == pytest.approx(stopped_at * PERIOD)


def test_the_predicted_stop_counts_before_the_clearance_is_reached():
    """The robot is stopped while its distance is still all right, because it would not be at the end of the braking."""
    it = bench()
    predicted = 0
    for seed in range(12):
        q = approach("lwr4_bench", seed)
        session = KinematicSession(q[0])
        with pytest.raises(TooClose) as caught:
            list(execute(session, it.guard(), Playback(JointTrajectory(PERIOD, q)), "transfer"))
        if " would stop " in str(caught.value):
            predicted += 1
            assert it.collision.margin(q[session.k]) >= 0.0
            assert caught.value.value < caught.value.limit
    assert predicted >= 3


def test_the_record_has_the_largest_speed_and_what_was_fastest():
    it = bench()
    t = PERIOD * np.arange(400)
    q = np.tile(it.home, (400, 1))
    q[:, 0] += 0.02 * (1 - np.cos(2 * np.pi * t / 0.4))
    guard = it.guard()
    list(execute(KinematicSession(q[0]), guard, Playback(JointTrajectory(PERIOD, q)), "transfer"))
    corners = it.cell.payload_box.corners
    poses = it.robot.sensor_poses(q)
    world = np.einsum("nij,kj->nki", poses.rotation, corners) + poses.position[:, None]
    speed = np.linalg.norm(np.diff(world, axis=0), axis=2).max() / PERIOD
    assert guard.record.max_speed_m_s == pytest.approx(speed, rel=1e-3)
    assert guard.record.fastest == "payload"


def test_far_from_everything_distances_are_only_sampled():
    guard = bench().guard()
    list(execute(KinematicSession(bench().home), guard, StandStill(0.399, PERIOD), "hold:free"))
    assert guard.record.ticks == 400
    assert guard.record.queries == 2 * 20  # today's and the predicted stop's, every 20 ms
