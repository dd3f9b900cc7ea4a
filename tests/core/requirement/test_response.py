"""What an observer without delay sees of a wrong payload is the torque that Pinocchio needs for the error."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest

from core.cell.folder import load_cell
from core.payload.inertia import PINOCCHIO_ORDER
from core.requirement.motions import JointMotion, make_brisk_motion
from core.requirement.response import respond
from core.robot.model import RobotModel

CELLS = Path(__file__).parents[3] / "cells"
AT_ONCE = 1e9


@pytest.mark.parametrize("name", sorted(folder.name for folder in CELLS.iterdir() if folder.is_dir()))
def test_without_delay_it_is_the_torque_that_the_error_needs(name: str) -> None:
    cell = load_cell(CELLS / name)
    robot = RobotModel.of_cell(cell)
    motion = make_brisk_motion(cell, robot, moves=2)
    error = next(iter(cell.payloads.values())).parameters.phi
    model = robot.model.copy()
    model.gravity.linear = cell.gravity
    frame = model.frames[robot.sensor_frame_id]
    loaded = model.copy()
    loaded.inertias[frame.parentJoint] += frame.placement.act(pin.Inertia.FromDynamicParameters(error[PINOCCHIO_ORDER]))
    data, loaded_data = model.createData(), loaded.createData()
    seen = respond(cell, robot, motion, AT_ONCE).torque_nm @ error
    for k in range(0, len(motion.q), 37):
        q, dq, ddq = motion.q[k], motion.dq[k], motion.ddq[k]
        needed = pin.rnea(loaded, loaded_data, q, dq, ddq) - pin.rnea(model, data, q, dq, ddq)
        np.testing.assert_allclose(seen[k], needed, atol=1e-6)


def test_a_payload_that_becomes_wrong_at_once_is_seen_as_slowly_as_the_observer_is() -> None:
    """After a time constant, 63 % of a step between two rows; straight between them, so half a row late."""
    cell = load_cell(CELLS / "lwr4_bench")
    robot = RobotModel.of_cell(cell)
    rate_per_s, period_s = 50.0, 0.001
    q = np.repeat([cell.robot.home_rad], 400, axis=0)
    ddq = np.zeros_like(q)
    ddq[100:, 1] = 1.0  # a step in what is needed, of which only the acceleration is one
    seen = respond(cell, robot, JointMotion(period_s, q, 0 * q, ddq), rate_per_s).torque_nm[:, 1, 0]
    before, after = seen[0], seen[-1]
    after_constant = (seen[119] - before) / (after - before)
    assert after_constant == pytest.approx(1.0 - np.exp(-rate_per_s * 0.0195), rel=1e-3)
