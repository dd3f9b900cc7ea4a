"""`core.estimation.joint_torques.torque_regressor` against Newton and Euler written apart from it."""

from __future__ import annotations

import numpy as np

from core.estimation.joint_torques.torque_regressor import TorqueRegressor
from core.robot.model import RobotModel
from tests.torque_recordings import GRAVITY, describe_exactly, draw_links, draw_payload, newton_euler


def test_regressor_times_links_and_payload_is_what_newton_and_euler_ask_of_the_joints() -> None:
    rng = np.random.default_rng(0)
    links, (points, phi) = draw_links(rng), draw_payload(rng, 3.0)
    q, dq, ddq = rng.normal(size=(3, 40, 6))
    regressor = TorqueRegressor(RobotModel(describe_exactly(links)), GRAVITY)
    tau = regressor.rows(q, dq, ddq) @ np.concatenate((regressor.links.ravel(), phi))
    np.testing.assert_allclose(tau, newton_euler(q, dq, ddq, links, points), atol=1e-9)
