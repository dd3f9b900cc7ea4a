import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.errors import BadPayload
from core.payload.inertia import InertialParameters
from core.plant.arm import arm_of_cell
from core.plant.mechanics import Drives, build_model
from tests.core.plant.plant_oracle import CARRIED, CELLS, NAMES, PinocchioArm

FRICTIONLESS = Drives(friction=0.0)


def random_states(cell, count=30):
    arm, rng = arm_of_cell(cell), np.random.default_rng(5)
    for _ in range(count):
        q = rng.uniform(arm.lower, arm.upper)
        yield q, rng.uniform(-arm.velocity, arm.velocity), rng.uniform(-arm.effort, arm.effort)


@pytest.mark.parametrize(("cell", "name"), CARRIED, ids=NAMES)
def test_forward_dynamics_is_pinocchios(cell, name):
    payload = cell.payloads[name].parameters
    model = build_model(arm_of_cell(cell), payload, cell.gravity, FRICTIONLESS)
    data = mujoco.MjData(model)
    oracle = PinocchioArm.of(cell, payload, cell.gravity)
    for q, dq, tau in random_states(cell):
        data.qpos[:], data.qvel[:], data.qfrc_applied[:] = q, dq, tau
        mujoco.mj_forward(model, data)
        expected = oracle.acceleration(FRICTIONLESS, q, dq, tau)
        np.testing.assert_allclose(data.qacc, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())


@pytest.mark.parametrize(("cell", "name"), CARRIED, ids=NAMES)
def test_the_sensor_reads_equation_1_with_its_sign_whatever_friction_does(cell, name):
    payload = cell.payloads[name].parameters
    model = build_model(arm_of_cell(cell), payload, cell.gravity, Drives())
    data = mujoco.MjData(model)
    oracle = PinocchioArm.of(cell, payload, cell.gravity)
    for q, dq, tau in random_states(cell):
        data.qpos[:], data.qvel[:], data.qfrc_applied[:] = q, dq, tau
        mujoco.mj_forward(model, data)
        np.testing.assert_allclose(data.sensordata, oracle.wrench(payload.phi, q, dq, data.qacc), atol=1e-9)


def test_a_rotated_lopsided_payload_keeps_all_its_products_of_inertia():
    cell = CELLS["lwr4_bench"]
    turn = Rotation.from_rotvec([0.4, -0.8, 1.1]).as_matrix()
    payload = InertialParameters.from_com(1.7, [0.03, -0.05, 0.11], turn @ np.diag([0.002, 0.005, 0.006]) @ turn.T)
    model = build_model(arm_of_cell(cell), payload, cell.gravity, FRICTIONLESS)
    data = mujoco.MjData(model)
    oracle = PinocchioArm.of(cell, payload, cell.gravity)
    for q, dq, tau in random_states(cell):
        data.qpos[:], data.qvel[:], data.qfrc_applied[:] = q, dq, tau
        mujoco.mj_forward(model, data)
        np.testing.assert_allclose(data.sensordata, oracle.wrench(payload.phi, q, dq, data.qacc), atol=1e-9)


@pytest.mark.parametrize("name", CELLS)
def test_a_bare_flange_weighs_nothing_and_leaves_the_arm_as_it_is(name):
    cell = CELLS[name]
    nothing = InertialParameters(np.zeros(10))
    model = build_model(arm_of_cell(cell), nothing, cell.gravity, FRICTIONLESS)
    data = mujoco.MjData(model)
    oracle = PinocchioArm.of(cell, nothing, cell.gravity)
    for q, dq, tau in random_states(cell, 5):
        data.qpos[:], data.qvel[:], data.qfrc_applied[:] = q, dq, tau
        mujoco.mj_forward(model, data)
        np.testing.assert_array_equal(data.sensordata, 0.0)
        np.testing.assert_allclose(data.qacc, oracle.acceleration(FRICTIONLESS, q, dq, tau), rtol=1e-8, atol=1e-6)


@pytest.mark.parametrize(
    "payload",
    [
        InertialParameters.from_com(1.0, [0, 0, 0.1], np.diag([0.001, 0.001, 0.0021])),
        InertialParameters.from_com(1.0, [0, 0, 0.1], np.diag([-0.001, 0.002, 0.002])),
        InertialParameters(np.array([-1.0, 0, 0, 0, 1e-3, 0, 0, 1e-3, 0, 1e-3])),
        InertialParameters(np.array([0.0, 0.1, 0, 0, 1e-3, 0, 0, 1e-3, 0, 1e-3])),
    ],
    ids=["triangle", "negative moment", "negative mass", "no mass"],
)
def test_a_payload_that_no_body_can_be_is_refused(payload):
    cell = CELLS["ur5e_line"]
    with pytest.raises(BadPayload, match="those that a rigid body can have"):
        build_model(arm_of_cell(cell), payload, cell.gravity, FRICTIONLESS)
