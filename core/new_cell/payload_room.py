"""The default payload box: from the flange face on, away from the robot, beyond the tool where there is one."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.cell.cell import Box, Pose
from core.robot.bodies import Body
from core.robot.model import RobotModel

EDGE_M = 0.16
BEYOND_TOOL_M = 0.1
ROUND = 3
LEAST_M = 0.005  # along the last joint's axis, to say where the arm goes on
Z_PREFERRED = 0.5  # another axis than the sensor's z is taken where it points away from the robot by so much better


def payload_room(robot: RobotModel, bodies: list[Body], tool: tuple[str, ...], edge: float = EDGE_M, gap: float = 0.0) -> Box:
    """A box that begins at the flange face, the sensor frame's origin, and goes away from the last link.

    Behind a tool it goes on for 0.1 m; the tool has shapes of its own.

    Args:
        bodies: of the links. tool: names of those that hang behind the sensor.
        edge: width, and depth without a tool, m.
        gap: between flange face and box, m.
    """
    frame = robot.model.frames[robot.sensor_frame_id].placement
    last = [body for body in bodies if body.joint == robot.n]
    arm, held = (
        np.array([frame.actInv(point) for body in last if (body.name in tool) == is_tool for point in body.corners]).reshape(-1, 3)
        for is_tool in (False, True)
    )
    axis, sign = _axis(held.mean(axis=0) if len(held) else _away(robot, arm))
    far = float((sign * held[:, axis]).max()) if len(held) else 0.0
    depth = edge if far <= 0.0 else max(edge, far + BEYOND_TOOL_M)
    size, centre = np.full(3, edge), np.zeros(3)
    size[axis], centre[axis] = depth, sign * (gap + depth / 2)
    size, centre = np.round(size, ROUND), np.round(centre, ROUND + 1)
    return Box(
        size_m=(float(size[0]), float(size[1]), float(size[2])), pose=Pose(xyz_m=(float(centre[0]), float(centre[1]), float(centre[2])))
    )


def _away(robot: RobotModel, arm: Array) -> Array:
    """Where the arm goes on, (3,) in the sensor frame: along the last joint's axis from the joint before, or away from its bodies.

    Args:
        arm: (k, 3), corners of what the last joint carries, in the sensor frame.
    """
    last, frame = robot.model.jointPlacements[robot.n], robot.model.frames[robot.sensor_frame_id].placement
    turned = robot.chain.axes[-1]
    along = (np.asarray(frame.translation) - np.asarray(last.inverse().translation)) @ turned
    if abs(along) > LEAST_M:
        return np.asarray(frame.rotation.T @ (along * turned))
    return -arm.mean(axis=0) if len(arm) else np.zeros(3)


def _axis(away: Array) -> tuple[int, float]:
    """The axis of the sensor frame that points away from the arm, and its sign."""
    length = float(np.linalg.norm(away))
    if length < 1e-6:
        return 2, 1.0
    away = away / length
    axis = int(np.argmax(np.abs(away)))
    if abs(away[axis]) - abs(away[2]) < Z_PREFERRED:
        axis = 2
    return axis, 1.0 if away[axis] >= 0.0 else -1.0
