"""Where the load would fly if it let go during a rotation, for people to look at."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.cell.cell import Box, Cell
from core.planning.plan import Leg, Plan
from core.planning.throw import Throw
from core.robot.model import RobotModel
from server.runner.plan_schemas import ThrowPart


def throws_of(cell: Cell, payload_box: Box, plan: Plan) -> Iterator[ThrowPart]:
    """For each rotation the release whose flight comes nearest to a protected zone."""
    robot = RobotModel.of_cell(cell)
    for leg in plan.legs:
        throw = leg.start.throw
        if throw is not None:
            point, velocity = _release(leg, throw, payload_box)
            sensor = robot.sensor_pose(leg.start.q)
            yield ThrowPart(
                axis=leg.axis,
                zone=throw.zone,
                distance_m=throw.distance_m,
                speed_m_s=throw.speed_m_s,
                point_m=np.round(sensor.position + sensor.rotation @ point, 4).tolist(),
                velocity_m_s=np.round(sensor.rotation @ velocity, 4).tolist(),
            )


def _release(leg: Leg, throw: Throw, box: Box) -> tuple[Array, Array]:
    """The box's fastest corner at the moment of release and its velocity, in the sensor's axes at the start; (3,), m and m/s."""
    if leg.profile is None:
        return box.pose.translation, np.zeros(3)
    axis = np.eye(3)["xyz".index(leg.about)]
    row = min(round(throw.time_s / leg.profile.period), len(leg.profile.angle) - 1)
    corners = box.corners @ Rotation.from_rotvec(leg.profile.angle[row] * axis).as_matrix().T
    velocities = np.cross(leg.profile.rate[row] * axis, corners)
    fastest = int(np.argmax(np.linalg.norm(velocities, axis=1)))
    return corners[fastest], velocities[fastest]
