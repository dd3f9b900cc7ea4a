"""Joint torques against MuJoCo's inverse dynamics, and what is said where they do not suffice."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import mujoco
import numpy as np
import pytest

from core.array import Array
from core.cell.cell import Box, Cell, Friction, Pose
from core.cell.folder import load_cell
from core.errors import TooHeavy
from core.planning.candidate_checks import Attitude
from core.planning.joint_torques import HOLDING_SHARE, JointTorques, Load, even_load, find_known_load, guess_load, refuse_too_heavy
from core.planning.search import plan_stops
from core.planning.start_configuration import Grid, find_start_configuration
from core.planning.stops import PROCEDURE
from core.planning.transfer import plan_transfer
from core.plant.arm import arm_of_cell
from core.plant.mechanics import Drives, build_model
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.trajectory import JointTrajectory
from core.second_opinion.opinion import JointPath
from core.words.message import Message

CELLS = Path(__file__).parents[3] / "cells"
PERIOD = 0.001
IDEAL = Drives(armature_s2=0.0, damping_s=0.0, friction=0.0)


@cache
def known(name: str) -> tuple[Cell, RobotModel]:
    cell = load_cell(CELLS / name)
    cell = cell.model_copy(update={"robot": cell.robot.model_copy(update={"friction": None})})
    return cell, RobotModel.of_cell(cell)


def with_urdf(cell: Cell, change: Callable[[str], str]) -> Cell:
    """The cell with another text of its URDF."""
    other = cell.model_copy()
    other.__dict__["urdf"] = change(cell.urdf)
    return other


def swing(cell: Cell, away: float, seconds: float) -> Array:
    """(N, n), from home and back, every joint at its own pace."""
    n = len(cell.robot.home_rad)
    t = np.linspace(0.0, 2.0 * np.pi, round(seconds / PERIOD))
    return np.asarray(np.array(cell.robot.home_rad) + away * (1.0 - np.cos(t[:, None])) * np.linspace(0.5, -0.4, n))


def mujocos(cell: Cell, load: Load, q: Array) -> Array:
    """(N, n), inverse dynamics of the finite differences of q."""
    model = build_model(arm_of_cell(cell), load.parameters, cell.gravity, IDEAL)
    data = mujoco.MjData(model)
    still = np.concatenate((q[:1], q, q[-1:]))
    found = []
    for k in range(len(q)):
        data.qpos[:], data.qvel[:] = q[k], (still[k + 2] - still[k]) / (2 * PERIOD)
        data.qacc[:] = (still[k + 2] - 2 * still[k + 1] + still[k]) / PERIOD**2
        mujoco.mj_inverse(model, data)
        found.append(data.qfrc_inverse.copy())
    return np.array(found)


@pytest.mark.parametrize("name", ["lwr4_bench", "ur5e_line"])
@pytest.mark.parametrize("base", [(0.0, 0.0, 0.0), (np.pi, 0.3, 0.0)])
def test_the_largest_share_of_a_torque_is_the_one_that_mujoco_finds(name: str, base: tuple[float, float, float]) -> None:
    cell, _ = known(name)
    cell = cell.model_copy(update={"robot": cell.robot.model_copy(update={"base": Pose(rpy_rad=base)})})
    load = find_known_load(cell, "steel_block")
    assert load is not None
    q = swing(cell, 0.6, 0.8)
    found = JointTorques(cell, RobotModel.of_cell(cell), load).of([JointPath("there", q[:300]), JointPath("back", q[300:])], PERIOD)
    theirs = mujocos(cell, load, q[:300]), mujocos(cell, load, q[300:])
    limits = arm_of_cell(cell).effort
    part = int(np.argmax([np.abs(each / limits).max() for each in theirs]))
    row, j = np.unravel_index(np.argmax(np.abs(theirs[part] / limits)), theirs[part].shape)
    most = found.largest
    assert most is not None and not found.not_judged
    assert (most.joint, most.part) == (arm_of_cell(cell).joints[j].name, ("there", "back")[part])
    assert most.torque_n_m == pytest.approx(abs(theirs[part][row, j]), rel=1e-9)
    assert most.ratio == pytest.approx(most.torque_n_m / limits[j], rel=1e-12)
    assert most.time_s == pytest.approx(row * PERIOD)
    assert most.holding_n_m == pytest.approx(abs(mujocos(cell, load, q[300 * part + row][None])[0, j]), rel=1e-9)


def test_stated_friction_is_asked_of_the_drives_as_well() -> None:
    cell, robot = known("ur5e_line")
    friction = Friction(coulomb_n_m=(20.0,) * 6, viscous_n_m_s=(5.0,) * 6)
    rough = cell.model_copy(update={"robot": cell.robot.model_copy(update={"friction": friction})})
    load = guess_load(cell, cell.payload_box, 1.0)
    q = swing(cell, 0.6, 0.8)
    speed = np.gradient(np.concatenate((q[:1], q, q[-1:])), PERIOD, axis=0)[1:-1]
    asked = np.abs(mujocos(cell, load, q) + np.where(np.abs(speed) > 1e-4, 20.0 * np.sign(speed), 0.0) + 5.0 * speed)
    most = JointTorques(rough, robot, load).of([JointPath("a", q)], PERIOD).largest
    assert most is not None
    assert most.ratio == pytest.approx((asked / arm_of_cell(cell).effort).max(), rel=1e-9)


def test_an_even_load_has_the_inertia_of_its_points() -> None:
    box = Box(size_m=(0.1, 0.2, 0.3), pose=Pose(xyz_m=(0.02, -0.05, 0.2), rpy_rad=(0.3, -0.5, 1.0)))
    load = even_load(box, 2.0, "a guessed mass").parameters
    grid = (np.stack(np.meshgrid(*[np.arange(24)] * 3, indexing="ij"), axis=-1).reshape(-1, 3) + 0.5) / 24 - 0.5
    points = grid * np.array(box.size_m) @ box.pose.rotation.T + box.pose.translation
    each = 2.0 / len(points)
    inertia = each * ((points**2).sum() * np.eye(3) - points.T @ points)
    assert load.mass == 2.0
    np.testing.assert_allclose(load.first_moment, each * points.sum(axis=0), atol=1e-12)
    np.testing.assert_allclose(load.inertia, inertia, rtol=2e-3, atol=1e-5)


def test_an_unknown_payload_is_as_heavy_as_the_robot_may_carry_and_otherwise_as_guessed() -> None:
    cell, _ = known("ur5e_line")
    assert find_known_load(cell, "anvil") is None
    assert guess_load(cell, cell.payload_box, 1.5).parameters.mass == 1.5
    limited = cell.model_copy(update={"robot": cell.robot.model_copy(update={"payload_limit_kg": 5.0})})
    found = guess_load(limited, cell.payload_box, 1.5)
    assert found.parameters.mass == 5.0
    assert found.source.code == "planning-load-payload-limit"


def test_a_tool_too_heavy_for_the_arm_is_refused_with_joint_value_and_limit_before_anything_is_searched() -> None:
    cell, _ = known("ur5e_line")
    weak = with_urdf(cell, lambda text: text.replace('effort="28"', 'effort="3"'))
    robot = RobotModel.of_cell(weak)
    collision = CollisionModel(weak, robot, weak.payload_box)
    load = even_load(weak.payload_box, 8.0, Message.of("planning-load-guessed"))
    home = np.array(weak.robot.home_rad)
    steps = plan_stops(weak, robot, collision, weak.payload_box, PROCEDURE.stops, start=home, load=load)
    with pytest.raises(TooHeavy) as caught:
        next(steps)
    held = np.abs(mujocos(weak, load, home[None])[0])
    j = int(np.argmax(held / arm_of_cell(weak).effort))
    joint = arm_of_cell(weak).joints[j].name
    assert (
        f'the load of 8.000 kg is too heavy for "{joint}": it would need {held[j]:.1f} N m (limit {arm_of_cell(weak).effort[j]:.1f} N m)'
        in str(caught.value)
    )
    assert caught.value.exit_code == 3


def test_start_configurations_are_those_that_the_joints_can_hold() -> None:
    cell, robot = known("ur5e_line")
    cell = cell.model_copy(update={"zones": (), "obstacles": ()})
    collision = CollisionModel(cell, robot, cell.payload_box)
    load = even_load(cell.payload_box, 5.0, "a stated mass")
    small = Grid(vertices=60, per_vertex=3, per_side=2, postures=2000, rounds=1)
    free = find_start_configuration(cell, robot, collision, Attitude.of_axis("x-"), seed=0, grid=small)
    asked = np.abs(mujocos(cell, load, free.q[None])[0])
    joint = int(np.argmax(asked[:3]))
    effort = 0.99 * float(asked[joint])
    names = [each.name for each in arm_of_cell(cell).joints]
    weak = with_urdf(cell, lambda text: _with_effort(text, names[joint], effort))
    found = find_start_configuration(
        weak, robot, collision, Attitude.of_axis("x-"), seed=0, grid=small, torques=JointTorques(weak, robot, load)
    )
    held = np.abs(mujocos(weak, load, found.q[None])[0])
    assert (held <= HOLDING_SHARE * arm_of_cell(weak).effort + 1e-9).all()
    powerless = with_urdf(cell, lambda text: _with_effort(text, names[1], 1.0))
    torques = JointTorques(powerless, robot, load)
    with pytest.raises(TooHeavy, match=rf'sensor axis x- along gravity: the load is too heavy, .*"{names[1]}" would need \d+ %'):
        find_start_configuration(powerless, robot, collision, Attitude.of_axis("x-"), seed=0, grid=small, torques=torques)


def test_a_transfer_for_which_a_joint_has_not_the_torque_is_made_slower_until_mujoco_says_that_it_has() -> None:
    cell, robot = known("lwr4_bench")
    cell = cell.model_copy(update={"zones": (), "obstacles": ()})
    collision = CollisionModel(cell, robot, cell.payload_box)
    load = even_load(cell.payload_box, 2.0, Message.of("planning-load-guessed"))
    home = np.array(cell.robot.home_rad)
    goal = home + np.array([1.2, 0.3, 0.0, 0.2, 0.0, 0.0, 0.0])

    def move(weak: Cell) -> JointTrajectory:
        return plan_transfer(weak, robot, collision, home, goal, period=PERIOD, torques=JointTorques(weak, robot, load)).trajectory

    fast = move(cell)
    turning = np.abs(mujocos(cell, load, fast.q))[:, 0].max()  # about the vertical: nothing to hold
    names = [each.name for each in arm_of_cell(cell).joints]
    weak = with_urdf(cell, lambda text: _with_effort(text, names[0], 0.5 * turning))
    slow = move(weak)
    assert np.abs(mujocos(weak, load, slow.q))[:, 0].max() <= 0.5 * turning
    assert slow.duration > 1.2 * fast.duration
    assert move(with_urdf(cell, lambda text: _with_effort(text, names[0], 1.05 * turning))).duration == pytest.approx(fast.duration)


def _with_effort(text: str, joint: str, effort: float) -> str:
    before, name, after = text.partition(f'<joint name="{joint}"')
    head, key, rest = after.partition('effort="')
    return before + name + head + key + f"{effort:.6f}" + rest[rest.index('"') :]


def test_without_an_effort_or_a_mass_the_torques_are_not_determined_and_the_reason_is_told() -> None:
    cell, _ = known("ur5e_line")
    names = [each.name for each in arm_of_cell(cell).joints]
    load = guess_load(cell, cell.payload_box, 1.0)
    here = [JointPath("home", np.array([cell.robot.home_rad]))]
    silent = with_urdf(cell, lambda text: _with_effort(text, names[0], 0.0))
    found = JointTorques(silent, RobotModel.of_cell(silent), load).of(here, PERIOD)
    assert found.not_judged == [Message.of("planning-joint-without-effort", joint=names[0])]
    assert found.largest is not None and found.largest.joint != names[0]
    light = with_urdf(cell, lambda text: text.replace('<mass value="1.3"/>', '<mass value="0"/>'))
    found = JointTorques(light, RobotModel.of_cell(light), load).of(here, PERIOD)
    assert len(found.not_judged) == 5
    assert all(why.code == "planning-joint-without-mass" for why in found.not_judged)
    assert found.largest is not None and found.largest.joint == names[-1]
    massless = with_urdf(cell, lambda text: text.replace('<mass value="0.365"/>', '<mass value="0"/>'))
    none = JointTorques(massless, RobotModel.of_cell(massless), load)
    found = none.of(here, PERIOD)
    assert found.largest is None and len(found.not_judged) == 6
    assert none.too_weak_to_hold(np.array(cell.robot.home_rad)) is None
    refuse_too_heavy(found)
