from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest

from tests.core.control.kinematic_session import CELLS, bench, fastest_at


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
        speed, number = fastest_at(bench(name), q, dq)
        assert speed == pytest.approx(max(speeds))
        assert speeds[number] == pytest.approx(max(speeds))


def test_a_robot_that_stands_has_no_speed():
    assert fastest_at(bench(), bench().home, np.zeros(bench().robot.n))[0] == 0.0
