"""`core.requirement`: crossings of thresholds are predicted as a simulated momentum observer sees them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest

from core.array import Array
from core.cell.cell import Cell, Pose
from core.cell.folder import load_cell
from core.cell.thresholds import ContactThresholds
from core.errors import BadCell, BadInput
from core.payload.inertia import PINOCCHIO_ORDER, InertialParameters
from core.requirement.motions import PERIOD_S, JointMotion, make_brisk_motion, read_program
from core.requirement.requirement import GROUPS, CriterionKind, PayloadQuantity, find_typed_jacobian, judge, require
from core.robot.model import RobotModel

CELLS = Path(__file__).parents[3] / "cells"
TORQUES_NM = (20.0, 20.0, 18.0, 18.0, 16.0, 14.0, 12.0)
RATE_PER_S = 30.0
FINE = 5
"""Steps of the simulated observer per row of the motion."""


def cell_with(name: str = "lwr4_bench", **thresholds: object) -> tuple[Cell, RobotModel]:
    cell = load_cell(CELLS / name)
    stated = ContactThresholds.model_validate({"observer_rate_per_s": RATE_PER_S, **thresholds})
    cell = cell.model_copy(update={"thresholds": stated})
    return cell, RobotModel.of_cell(cell)


def payload_of(cell: Cell) -> InertialParameters:
    return cell.payloads["steel_block"].parameters


class Observer:
    """A momentum observer in a controller that believes in a payload, on a robot that carries another; by Pinocchio, step by step.

    The generalised momentum's derivative is C^T dq - g + tau; what the wrong model cannot account for is the residual.
    """

    def __init__(self, cell: Cell, robot: RobotModel, carried: InertialParameters, believed: InertialParameters) -> None:
        self.real, self.model = self._arm(cell, robot, carried), self._arm(cell, robot, believed)

    @staticmethod
    def _arm(cell: Cell, robot: RobotModel, load: InertialParameters) -> tuple[pin.Model, pin.Data]:
        model = robot.model.copy()
        model.gravity.linear = cell.gravity
        frame = model.frames[robot.sensor_frame_id]
        model.inertias[frame.parentJoint] += frame.placement.act(pin.Inertia.FromDynamicParameters(load.phi[PINOCCHIO_ORDER]))
        return model, model.createData()

    def residuals(self, motion: JointMotion) -> Array:
        """(N, n), N m, at the rows of the motion."""
        period = motion.period_s / FINE
        residual: Array | None = None
        seen = []
        for k in range((len(motion.q) - 1) * FINE + 1):
            q, dq, ddq = self._state(motion, k)
            tau = pin.rnea(*self.real, q, dq, ddq).copy()
            model, data = self.model
            pin.computeAllTerms(model, data, q, dq)
            pin.computeCoriolisMatrix(model, data, q, dq)
            mass = np.triu(data.M) + np.triu(data.M, 1).T
            momentum = mass @ dq
            rate = data.C.T @ dq - pin.computeGeneralizedGravity(model, data, q).copy() + tau
            if residual is None:  # it has stood here for long
                residual = -rate
                integral = momentum - (residual / RATE_PER_S)
            else:
                integral = integral + period * (rate + residual)
                residual = RATE_PER_S * (momentum - integral)
            if k % FINE == 0:
                seen.append(residual)
        return np.array(seen)

    @staticmethod
    def _state(motion: JointMotion, k: int) -> tuple[Array, Array, Array]:
        row, rest = divmod(k, FINE)
        s = rest / FINE
        if rest == 0:
            return motion.q[row], motion.dq[row], motion.ddq[row]
        ahead = s * motion.period_s
        ddq = (1 - s) * motion.ddq[row] + s * motion.ddq[row + 1]
        dq = (1 - s) * motion.dq[row] + s * motion.dq[row + 1]
        return motion.q[row] + ahead * motion.dq[row] + 0.5 * ahead**2 * motion.ddq[row], dq, ddq


@pytest.mark.parametrize("rpy_deg", [(0.0, 0.0, 0.0), (0.0, 90.0, 0.0)], ids=["on a table", "on a wall"])
@pytest.mark.parametrize("group", list(PayloadQuantity))
def test_an_error_as_large_as_allowed_reaches_the_threshold_in_a_simulated_observer(
    group: PayloadQuantity, rpy_deg: tuple[float, ...]
) -> None:
    cell, _ = cell_with(joint_torque_nm=TORQUES_NM)
    stands = Pose(xyz_m=cell.robot.base.xyz_m, rpy_rad=tuple(np.radians(rpy_deg)))
    cell = cell.model_copy(update={"robot": cell.robot.model_copy(update={"base": stands})})
    robot = RobotModel.of_cell(cell)
    carried = payload_of(cell)
    motion = make_brisk_motion(cell, robot, moves=6)
    requirement = require(cell, robot, carried, motion)
    [allowed] = [each for each in requirement.allowed if each.group is group]
    criterion = allowed.criterion
    assert criterion is not None
    assert criterion.joint is not None
    row = criterion.rows[round(allowed.time_s / PERIOD_S), 0, GROUPS[group]]
    weights = np.array([1, 2, 2, 1, 2, 1]) if group is PayloadQuantity.INERTIA else np.ones(len(row))
    direction = row / weights / np.sqrt((row**2 / weights).sum())  # of norm one, where the response is largest
    error = np.zeros(10)
    error[GROUPS[group]] = allowed.error * direction
    m, c = carried.mass + error[0], carried.com + error[1:4]
    believed = InertialParameters.from_com(m, c, carried.inertia_com + np.array([
        [error[4], error[5], error[6]], [error[5], error[7], error[8]], [error[6], error[8], error[9]]]))  # fmt: skip
    seen = np.abs(Observer(cell, robot, carried, believed).residuals(motion)).max(axis=0) / np.array(TORQUES_NM)
    assert int(seen.argmax()) + 1 == criterion.joint
    assert seen.max() == pytest.approx(1.0, rel=0.1)


def test_a_centre_of_mass_in_the_wrong_place_is_felt_as_force_of_the_right_size_at_rest() -> None:
    """At rest an error of the mass is felt as its weight, whatever the pose."""
    cell, robot = cell_with(tcp_force_n=20.0, guiding_force_n=5.0)
    still = np.repeat([cell.robot.home_rad], 40, axis=0)
    requirement = require(cell, robot, payload_of(cell), JointMotion(PERIOD_S, still, 0 * still, 0 * still))
    mass = requirement.allowed[0]
    assert mass.error == pytest.approx(5.0 / 9.81, rel=1e-6)
    assert mass.criterion is not None
    assert mass.criterion.kind is CriterionKind.GUIDING_FORCE
    assert requirement.allowed[2].error == np.inf


def test_what_is_typed_moves_the_ten_parameters_as_its_derivative_says() -> None:
    cell, _ = cell_with()
    payload = payload_of(cell)
    typed = find_typed_jacobian(payload)
    step = 1e-6 * np.array([1.0, 0.3, -0.2, 0.1, *[0.01] * 6])
    six = step[4:]
    moved = InertialParameters.from_com(payload.mass + step[0], payload.com + step[1:4], payload.inertia_com + np.array([
        [six[0], six[1], six[2]], [six[1], six[3], six[4]], [six[2], six[4], six[5]]]))  # fmt: skip
    np.testing.assert_allclose(moved.phi - payload.phi, typed @ step, atol=1e-11)


def test_an_answer_is_good_enough_as_often_as_its_errors_stay_below_the_thresholds() -> None:
    cell, robot = cell_with(joint_torque_nm=TORQUES_NM, tcp_force_n=20.0)
    motion = make_brisk_motion(cell, robot, moves=4)
    payload = payload_of(cell)
    requirement = require(cell, robot, payload, motion)
    rng = np.random.default_rng(5)
    covariance = np.diag(np.array([0.02, *[0.002] * 3, *[0.0005] * 6]) ** 2)
    adequacy = judge(requirement, covariance)
    assert adequacy.good_enough
    assert adequacy.margin > 1.0
    errors = rng.multivariate_normal(np.zeros(10), covariance * adequacy.margin**2, size=2000)
    typed = np.linalg.inv(find_typed_jacobian(payload))
    most = np.zeros(len(errors))
    for each in requirement.criteria:
        for row in each.rows:
            np.maximum(most, np.linalg.norm((errors @ typed.T) @ row.T, axis=1) / each.threshold, out=most)
    assert (most < 1.0).mean() == pytest.approx(0.95, abs=0.015)
    assert sum(adequacy.shares.values()) == pytest.approx(1.0)
    assert adequacy.decides is max(adequacy.shares, key=lambda group: adequacy.shares[group])


def test_what_the_maker_allows_counts_without_any_motion() -> None:
    cell, robot = cell_with(guiding_force_n=500.0, mass_kg=0.1, com_m=0.004)
    motion = make_brisk_motion(cell, robot, moves=1)
    requirement = require(cell, robot, payload_of(cell), motion)
    assert [each.error for each in requirement.allowed[:2]] == pytest.approx([0.1, 0.004])
    assert not requirement.assumed


def test_where_the_cell_states_nothing_a_usual_force_is_assumed() -> None:
    cell, robot = cell_with()
    requirement = require(cell, robot, payload_of(cell), make_brisk_motion(cell, robot, moves=2))
    assert requirement.assumed
    assert {each.kind for each in requirement.criteria} == {CriterionKind.TCP_FORCE}


def test_brisk_moves_reach_a_limit_and_exceed_none() -> None:
    cell, robot = cell_with()
    motion = make_brisk_motion(cell, robot, moves=10)
    hardest = np.array(cell.robot.acceleration_rad_s2)
    assert (np.abs(motion.dq) <= robot.velocity * (1 + 1e-9)).all()
    assert (np.abs(motion.ddq) <= hardest * (1 + 1e-9)).all()
    used = np.maximum((np.abs(motion.dq) / robot.velocity).max(), (np.abs(motion.ddq) / hardest).max())
    assert used > 0.95
    np.testing.assert_allclose(np.gradient(motion.q, PERIOD_S, axis=0)[2:-2], motion.dq[2:-2], atol=0.05)


def test_a_threshold_for_each_joint_of_another_robot_is_refused() -> None:
    cell, _ = cell_with()
    with pytest.raises(BadCell, match=r"thresholds\.joint_torque_nm"):
        RobotModel.of_cell(cell.model_copy(update={"thresholds": ContactThresholds(joint_torque_nm=(20.0,) * 6)}))


def test_a_programs_path_is_read_and_smoothed(tmp_path: Path) -> None:
    cell, robot = cell_with()
    home = ",".join(str(value) for value in cell.robot.home_rad)
    there = ",".join(str(value + 0.2) for value in cell.robot.home_rad)
    file = tmp_path / "program.csv"
    file.write_text(f"t_s,{','.join(f'q{k}_rad' for k in range(1, 8))}\n0,{home}\n1.5,{there}\n3,{home}\n")
    motion = read_program(file, robot)
    assert motion.duration_s == pytest.approx(3.0)
    np.testing.assert_allclose(motion.q[300], np.array(cell.robot.home_rad) + 0.2, atol=1e-9)
    np.testing.assert_allclose(motion.dq[[0, -1]], 0.0, atol=1e-9)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("t,q\n0,0,0,0,0,0,0,0\n", "requirement-no-rows"),
        ("t,q\n0,0,0,0,0,0,0,0\n0,0,0,0,0,0,0,0\n", "requirement-time-stands"),
        ("t,q\n0,0,0,0,0,0,0\n1,0,0,0,0,0,0\n", "requirement-no-numbers"),
        ("t,q\n0,a,0,0,0,0,0,0\n", "requirement-no-numbers"),
        ("t,q\n0,0,0,0,0,0,0,nan\n", "requirement-no-numbers"),
        ("t,q\n0,9,0,0,0,0,0,0\n1,0,0,0,0,0,0,0\n", "requirement-beyond-limits"),
        ("t,q\n0,0,0,0,0,0,0,0\n1e7,0,0,0,0,0,0,0\n", "requirement-too-long"),
    ],
)
def test_a_path_that_cannot_be_used_is_refused_in_words(tmp_path: Path, text: str, code: str) -> None:
    _, robot = cell_with()
    (tmp_path / "program.csv").write_text(text)
    with pytest.raises(BadInput) as caught:
        read_program(tmp_path / "program.csv", robot)
    assert caught.value.message.code == code
