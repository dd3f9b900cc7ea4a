from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest
from kinematic_session import CELLS, bench

from core.control.speed import fastest_point


@pytest.mark.parametrize("name", CELLS)
def test_the_fastest_point_is_the_one_that_pinocchio_finds(name):
    robot, points = bench(name).robot, bench(name).collision.points
    model, data = robot.model, robot.model.createData()
    rng = np.random.default_rng(0)
    for _ in range(50):
        q, dq = rng.uniform(robot.lower, robot.upper), rng.normal(size=robot.n)
        pin.forwardKinematics(model, data, q, dq)
        speeds = []
        for joint, local in zip(points.joint, points.local, strict=True):
            v = data.v[int(joint) + 1]  # in the joint's own frame
            speeds.append(np.linalg.norm(v.linear + np.cross(v.angular, local)))
        found = fastest_point(robot.chain, points, q, dq)
        assert found.speed == pytest.approx(max(speeds))
        assert speeds[found.point] == pytest.approx(max(speeds))


def test_a_robot_that_stands_has_no_speed():
    robot, points = bench().robot, bench().collision.points
    assert fastest_point(robot.chain, points, bench().home, np.zeros(robot.n)).speed == 0.0
