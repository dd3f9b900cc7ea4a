"""A run that ends as soon as its target is met: what it leaves out, and that the robot only goes ways of the released plan."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial import cKDTree

from core.cell.folder import load_cell
from core.events import Event, PhaseStarted, Planned, Progress, StepFinished, TargetReached, drive
from core.planning.plan import Plan, plan_digest
from core.planning.settings import Timing
from core.planning.stops import Stops
from core.procedure.identify import identify, move_and_estimate
from core.procedure.outcome import Outcome
from core.procedure.recorder import Recorder
from core.procedure.run import Planning, Run
from core.procedure.target_watch import TargetAnswer, TargetWatch
from core.requirement.target import Standing, Target, TargetCheck
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from core.sessions.simulated import SimulatedSession
from core.twin.twin import NOMINAL

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
BLOCK = CELL.payloads["steel_block"]
STOPS = Stops.of_procedure(timing=Timing(hold_s=0.5, settle_s=0.4, inertia_std=0.001, robot_s=45.0))
MASS = TargetCheck(Target(mass_share=0.05))


class Scripted(TargetWatch):
    """Gives the answers of a list, one for each time that it is asked; the last one stays."""

    def __init__(self, *answers: TargetAnswer) -> None:
        super().__init__(MASS)
        self.answers, self.asked = answers, 0

    def ask(self, log: SampleLog) -> None:
        assert len(log)
        self.asked += 1

    def newest(self) -> TargetAnswer | None:
        return self.answers[min(self.asked, len(self.answers)) - 1] if self.asked else None


OPEN, REACHED, TYPE_B = (TargetAnswer(each, "") for each in (Standing.OPEN, Standing.REACHED, Standing.TYPE_B))


def make_run(watch: TargetWatch | None) -> Run:
    robot = RobotModel.of_cell(CELL)
    session = SimulatedSession(CELL, BLOCK.parameters, seed=3)
    log = SampleLog(CELL, robot, payload="steel_block", reference=BLOCK)
    return Run(CELL, robot, session, BLOCK.box, Planning(STOPS, seed=3), Recorder(log), watch=watch)


@pytest.fixture(scope="module")
def plan() -> Plan:
    return drive(make_run(None).make_plan(np.array(CELL.robot.home_rad)))


def carry_out(plan: Plan, watch: TargetWatch | None) -> tuple[list[Event], Outcome]:
    events: list[Event] = []
    return events, drive(move_and_estimate(make_run(watch), plan, NOMINAL, None), events.append)


def count_holds_and_turns(plan: Plan) -> int:
    return sum(3 if leg.profile is not None else 1 for leg in plan.legs)


def test_the_plan_has_repetitions_to_leave_out(plan):
    assert all(len(leg.profile.rests) > 2 for leg in plan.legs if leg.profile is not None)


@pytest.fixture(scope="module")
def whole(plan) -> tuple[list[Event], Outcome]:
    return carry_out(plan, None)


@pytest.fixture(scope="module")
def early(plan) -> tuple[list[Event], Outcome]:
    """A hold, a hold, one swing."""
    return carry_out(plan, Scripted(OPEN, OPEN, REACHED))


def test_a_target_that_is_reached_ends_the_run_and_the_robot_goes_home_along_the_plans_transfers(plan, whole, early):
    events, outcome = early
    phases = [(event.phase, event.toward) for event in events if isinstance(event, PhaseStarted)]
    assert phases == [
        ("transfer", "x-"), ("hold:x-", ""), ("transfer", "x+"), ("hold:x+", ""), ("rotate:x", ""), ("hold:x+", ""),
        ("transfer", "y-"), ("transfer", "y+"), ("transfer", "z-"), ("transfer", "z+"), ("transfer", "home"),
    ]  # fmt: skip
    assert sum(isinstance(event, TargetReached) for event in events) == 1
    assert [event.step for event in events if isinstance(event, StepFinished)] == [1, 6]
    np.testing.assert_allclose(outcome.recording.q_cmd[-1], CELL.robot.home_rad, atol=1e-4)
    away, _ = cKDTree(np.concatenate([path.q for path in plan.commanded])).query(outcome.recording.q_cmd[::5])
    assert away.max() < 1e-3, "rad, from what was released"
    left_out = outcome.target.left_out
    assert (left_out.made, left_out.planned) == (4, count_holds_and_turns(plan))
    all_swings = sum(len(leg.profile.rests) for leg in plan.legs if leg.profile is not None)
    assert left_out.repetitions == all_swings - 2  # the one that was under way when the answer came is finished
    assert left_out.saved_s == pytest.approx(whole[1].robot_s - outcome.robot_s, abs=0.05)
    assert outcome.result().target.message.code == "target-reached-early"


@pytest.mark.thorough
def test_from_a_stop_with_a_way_home_of_its_own_the_robot_takes_that(plan, whole):
    wanted = make_run(None)
    request = wanted.planning.request(wanted, np.array(CELL.robot.home_rad))
    with_ways = drive(replace(STOPS, target=MASS.target).plan(request, wanted.robot, wanted.collision))
    assert plan_digest(with_ways) != plan_digest(plan), "what is released holds the ways home"
    way = with_ways.legs[1].home
    assert way is not None
    assert way.opinion.passes
    rest_s = with_ways.home.trajectory.duration + sum(leg.transfer.trajectory.duration for leg in with_ways.legs[2:])
    assert way.transfer.trajectory.duration < rest_s
    events, outcome = carry_out(with_ways, Scripted(OPEN, OPEN, REACHED))
    toward = [event.toward for event in events if isinstance(event, PhaseStarted) and event.toward]
    assert toward == ["x-", "x+", "home"]
    going = outcome.recording.q_cmd[-round(way.transfer.trajectory.duration / 0.001) :]
    away, _ = cKDTree(way.transfer.trajectory.q).query(going)
    assert away.max() < 1e-3, "rad, from what was released"
    np.testing.assert_allclose(going[-1], CELL.robot.home_rad, atol=1e-4)
    assert outcome.target.left_out.saved_s == pytest.approx(with_ways.robot_s - outcome.robot_s, abs=0.05)
    assert [event.step for event in events if isinstance(event, StepFinished)] == [1, 6]


def test_time_left_only_ever_falls(early):
    events, _ = early
    left_s = [event.total_s - event.done_s for event in events if isinstance(event, Progress)]
    assert np.diff(left_s).max() < 1e-6
    assert left_s[-1] < 0.05


def test_a_target_that_is_reached_before_a_hold_leaves_that_out_too(plan):
    events, outcome = carry_out(plan, Scripted(REACHED))
    assert {event.phase for event in events if isinstance(event, PhaseStarted)} == {"transfer", "hold:x-"}
    assert outcome.target.left_out.made == 1


def test_an_axis_of_which_enough_is_known_is_turned_about_once(plan):
    events, outcome = carry_out(plan, Scripted(TargetAnswer(Standing.OPEN, "xz")))
    seconds = {axis: 0.001 * np.count_nonzero(outcome.recording.phase == f"rotate:{axis}") for axis in "xyz"}
    profiles = {leg.about: leg.profile for leg in plan.legs if leg.profile is not None}
    for axis, swings in (("x", 1), ("y", len(profiles["y"].rests)), ("z", 1)):
        expected_s = profiles[axis].period * profiles[axis].rests[swings - 1]
        assert seconds[axis] == pytest.approx(expected_s, abs=0.02)
    assert [event.step for event in events if isinstance(event, StepFinished)] == [1, 2, 3, 4, 5, 6]
    assert not any(isinstance(event, TargetReached) for event in events)
    left_out = outcome.target.left_out
    assert left_out.made == left_out.planned == count_holds_and_turns(plan)
    assert left_out.repetitions == len(profiles["x"].rests) + len(profiles["z"].rests) - 2


def test_where_type_b_is_what_is_left_the_last_rotation_is_not_repeated_but_nothing_is_skipped(plan):
    _, outcome = carry_out(plan, Scripted(TYPE_B))
    turns = [leg for leg in plan.legs if leg.profile is not None]
    assert outcome.target.left_out.repetitions == len(turns[-1].profile.rests) - 1
    assert outcome.target.left_out.made == outcome.target.left_out.planned


def test_a_run_without_a_target_leaves_nothing_out(plan, whole):
    _, outcome = whole
    assert outcome.target is None
    assert outcome.robot_s == pytest.approx(plan.robot_s, abs=0.1)


@pytest.mark.thorough
def test_a_real_target_is_watched_by_the_estimator_of_the_result(tmp_path):
    session = SimulatedSession(CELL, BLOCK.parameters, seed=3)
    target = Target(mass_share=0.03)  # the assumed calibration leaves 1.4 %
    run = identify(CELL, session, BLOCK.box, stops=STOPS, seed=3, reference=BLOCK, target=target, out=tmp_path / "recording")
    events: list[Event] = []
    outcome = drive(run, events.append)
    planned_s = next(event.robot_s for event in events if isinstance(event, Planned))
    assert outcome.target.standing == "reached"
    assert outcome.robot_s < planned_s - 5.0
    estimate = outcome.identification.estimate
    assert 1.96 * estimate.std[0] < 0.03 * estimate.phi[0]
    assert abs(estimate.phi[0] - BLOCK.parameters.mass) < 1.96 * estimate.std[0]
