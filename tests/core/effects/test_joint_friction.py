"""Friction of the joints in their torques and in the tracking error; torques by Newton-Euler with masses that the URDF does not have."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from scipy.spatial.transform import Rotation

from core.cell.folder import load_cell
from core.effects.effect import Finding, View
from core.effects.joint_friction import JointFriction
from core.recording.recording import FrictionDescription, Recording, RobotDescription
from core.robot.model import RobotModel

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
ROBOT = RobotDescription(CELL.urdf, tuple(f"joint{j}" for j in range(1, 8)), CELL.robot.base_frame, CELL.robot.sensor_frame)
G = np.array([0.0, 0.0, -9.81])
PERIOD = 0.002
STILL = slice(0, 1000)
COULOMB = np.array([3.5, 4.0, 2.0, 2.5, 1.5, 1.0, 1.2])
VISCOUS = np.array([5.0, 3.0, 4.0, 2.0, 1.0, 0.5, 0.8])
NOISE = 0.05
OFFSET = np.array([3.0, -2.0, 1.0, 0.1, 0.0, 0.2])


def motion(seconds: float = 40.0) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Two seconds at rest, then sines that begin gently: t, q, dq, ddq."""
    t = np.arange(round(seconds / PERIOD)) * PERIOD
    x = np.maximum(t - STILL.stop * PERIOD, 0.0)[:, None]
    rng = np.random.default_rng(5)
    q, dq, ddq = np.tile([0.2, 0.5, -0.3, 1.2, 0.4, -0.8, 0.3], (len(t), 1)), np.zeros((len(t), 7)), np.zeros((len(t), 7))
    for _ in range(3):
        A, w = rng.uniform(0.1, 0.4, 7), 2 * np.pi * rng.uniform(0.05, 0.4, 7)
        q, dq, ddq = q + A * (1 - np.cos(w * x)), dq + A * w * np.sin(w * x), ddq + A * w * w * np.cos(w * x) * (x > 0)
    return t, q, dq, ddq


def torques(q: np.ndarray, dq: np.ndarray, ddq: np.ndarray) -> np.ndarray:
    """Of an arm a tenth heavier than its URDF, with a payload and rotors."""
    model = RobotModel(ROBOT).model.copy()
    model.gravity.linear = G
    for j in range(1, model.njoints):
        model.inertias[j] = pin.Inertia(1.1 * model.inertias[j].mass, model.inertias[j].lever, 1.1 * model.inertias[j].inertia)
    model.inertias[7] += pin.Inertia(2.0, np.array([0.02, 0.01, 0.2]), 0.01 * np.eye(3))
    data = model.createData()
    return np.stack([pin.rnea(model, data, *row) for row in zip(q, dq, ddq, strict=True)]) + 0.4 * ddq


def recording(extra: np.ndarray | float, **changes: object) -> Recording:
    t, q, dq, ddq = motion()
    tau = torques(q, dq, ddq) + extra + NOISE * np.random.default_rng(2).normal(size=q.shape)
    return Recording(**{"t": t, "gravity": G, "q": q, "dq": dq, "tau": tau, "robot": ROBOT, **changes})  # type: ignore[arg-type]  # any field


def observe(run: Recording) -> Finding | None:
    return JointFriction().observe(run, View((STILL,), np.ones(6), np.full(10, np.nan), np.full(10, np.nan)))


def friction() -> np.ndarray:
    _, _, dq, _ = motion()
    return COULOMB * np.sign(dq) + VISCOUS * dq


def test_coulomb_and_viscous_friction_are_found_in_the_torques_of_every_joint() -> None:
    finding = observe(recording(friction()))
    assert finding is not None
    assert finding.sigma > 20
    coulomb, viscous = finding.theta.reshape(7, 2).T
    std = finding.std.reshape(7, 2).T
    assert (np.abs(coulomb - COULOMB) < 4 * std[0] + 0.05 * COULOMB).all()
    assert (np.abs(viscous - VISCOUS) < 4 * std[1] + 0.05 * VISCOUS).all()
    assert (std[0] < 0.2 * COULOMB).all()
    assert "N m (Coulomb)" in finding.message.text


@pytest.mark.parametrize(("stated", "matters"), [(0.0, True), (0.55, True), (0.75, False), (1.0, False), (1.8, False), (2.5, True)])
def test_friction_matters_where_it_differs_by_more_than_half_from_what_is_stated(stated: float, matters: bool) -> None:
    finding = observe(recording(friction(), friction=FrictionDescription(stated * COULOMB, stated * VISCOUS)))
    assert finding is not None
    assert finding.material is matters
    assert finding.message.code == ("symptom-friction-differs" if matters else "symptom-friction-as-stated")
    if stated:
        assert finding.times_expected == pytest.approx(1.0 / stated, rel=0.1)
    else:
        assert finding.times_expected is None


def test_one_joint_that_rubs_twice_as_much_is_named() -> None:
    less = np.array([1.0, 1.0, 1.0, 0.5, 1.0, 1.0, 1.0])
    finding = observe(recording(friction(), friction=FrictionDescription(less * COULOMB, less * VISCOUS)))
    assert finding is not None
    assert finding.material
    assert finding.message.parameters["joint"] == 4
    assert finding.message.parameters["stated"].parameters["coulomb_nm"] == 0.5 * COULOMB[3]


def test_friction_that_is_stated_and_is_not_there_differs() -> None:
    finding = observe(recording(0.0, friction=FrictionDescription(COULOMB, VISCOUS)))
    assert finding is not None
    assert finding.material
    assert finding.times_expected == pytest.approx(0.0, abs=0.2)


def test_friction_that_nobody_states_matters_only_by_a_large_tracking_error() -> None:
    _, q, _, _ = motion()
    small, large = (observe(recording(friction(), q_cmd=q + np.radians(error))) for error in (0.4, 0.6))
    assert small is not None
    assert large is not None
    assert not small.material
    assert large.material
    assert "the cell states no friction" in small.message.text
    assert "0.60 deg" in large.message.text
    assert (small.times_expected, large.times_expected) == (None, pytest.approx(1.2))


def test_a_large_tracking_error_matters_though_the_friction_is_as_stated() -> None:
    _, q, _, _ = motion()
    stated = FrictionDescription(COULOMB, VISCOUS)
    finding = observe(recording(friction(), q_cmd=q + np.radians(0.8), friction=stated))
    assert finding is not None
    assert finding.material
    assert finding.message.parameters["seen"].code == "symptom-friction-as-stated"


def test_an_arm_heavier_than_its_urdf_is_no_friction() -> None:
    assert observe(recording(0.0)) is None


def test_a_cable_that_rubs_on_the_payload_is_no_friction_of_the_joints() -> None:
    t, q, dq, _ = motion()
    robot = RobotModel(ROBOT)
    J = np.stack([robot.sensor_jacobian(row) for row in q])
    v = np.einsum("nij,nj->ni", J, dq)[:, :3]
    w = np.hstack([4.0 * v / np.sqrt(np.sum(v * v, axis=1, keepdims=True) + 1e-4), np.zeros((len(t), 3))])
    pulled = np.einsum("nij,ni->nj", J, w)
    blind, seeing = observe(recording(pulled)), observe(recording(pulled, wrench=w + OFFSET))
    assert blind is not None
    assert seeing is None


def test_without_torques_the_tracking_error_shows_the_coulomb_part() -> None:
    _, q, dq, ddq = motion()
    stiffness = np.array([4000.0, 4000, 3000, 3000, 2000, 1000, 1000])
    error = (torques(q, dq, ddq) + friction()) / stiffness + 1e-5 * np.random.default_rng(3).normal(size=q.shape)
    run = recording(0.0, tau=None, q_cmd=q + error)
    finding = observe(run)
    assert finding is not None
    assert not finding.material
    assert finding.theta.shape == (7,) == (len(JointFriction().parameters(run)),)
    np.testing.assert_allclose(finding.theta, COULOMB / stiffness, rtol=0.15)
    assert "mrad" in finding.message.text


@pytest.mark.parametrize(
    "changes",
    [{"tau": None}, {"q": None}, {"robot": None, "q": None, "orientation": Rotation.identity(20000).as_matrix()}],
)
def test_a_recording_without_joints_or_torques_shows_no_friction(changes: dict[str, object]) -> None:
    assert observe(recording(0.0, **changes)) is None


def test_a_recording_at_rest_shows_no_friction() -> None:
    run = recording(0.0)
    assert run.q is not None
    assert run.tau is not None
    assert observe(Recording(t=run.t[STILL], gravity=G, q=run.q[STILL], tau=run.tau[STILL], robot=ROBOT)) is None
