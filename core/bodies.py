"""The convex bodies of robot, payload box, obstacles and zones, as Coal's shapes, and how far they can move."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from core.cell import Box, Capsule, Cell, Shape, Sphere
from core.cell_tools import tool_boxes
from core.robot import RobotModel

Array = NDArray[np.float64]

PAYLOAD = "payload"


@dataclass(frozen=True)
class SpeedPoints:
    """Corners of the box round every moving link and of the payload box.

    The speed of a rigid body is a convex function of the point: no point of the body is faster than the fastest corner.

    Args:
        joint: (n_points,), index of the joint that carries the point, 0 for the first joint of the chain.
        local: (n_points, 3), in that joint's frame, m.
        owner: name of the link, or "payload", of each point.
    """

    joint: NDArray[np.int64]
    local: Array
    owner: tuple[str, ...]


@dataclass(frozen=True)
class Body:
    """A rigid convex body.

    Args:
        name: of the link, the obstacle or the zone, or "payload".
        joint: number of the joint that carries it as Pinocchio counts, 0 for what does not move.
        geometry: Coal's shape.
        placement: in that joint's frame, or in the world.
    """

    name: str
    joint: int
    geometry: Any
    placement: Any

    @property
    def corners(self) -> Array:
        """(8, 3), corners of the box round the body, in the joint's frame or the world, m."""
        self.geometry.computeLocalAABB()
        ends = np.array([self.geometry.aabb_local.min_, self.geometry.aabb_local.max_])
        corners = np.stack(np.meshgrid(*ends.T), axis=-1).reshape(-1, 3)
        return np.asarray(corners @ self.placement.rotation.T + self.placement.translation)


def link_bodies(cell: Cell, robot: RobotModel) -> list[Body]:
    """The collision bodies of the URDF; those of the base are in the world frame, as the model's frames are."""
    geometry = pin.buildGeomFromUrdfString(robot.model, cell.urdf, pin.GeometryType.COLLISION, None, str(cell.folder))
    return [
        Body(robot.model.frames[body.parentFrame].name, body.parentJoint, _convex(body.geometry), body.placement)
        for body in geometry.geometryObjects
    ]


def _convex(geometry: Any) -> Any:
    """The convex hull of a mesh; other shapes as they are."""
    if not isinstance(geometry, coal.BVHModelBase):
        return geometry
    geometry.buildConvexHull(True, "Qt")
    return geometry.convex


def payload_body(robot: RobotModel, box: Box) -> Body:
    """The payload box, given in the sensor frame."""
    return _carried_box(PAYLOAD, robot, box)


def tool_bodies(cell: Cell, robot: RobotModel) -> list[Body]:
    """The boxes of the cell's tools, by the tools' names; tools made of links are among `link_bodies`."""
    return [_carried_box(name, robot, box) for name, box in tool_boxes(cell).items()]


def _carried_box(name: str, robot: RobotModel, box: Box) -> Body:
    placement = robot.model.frames[robot.sensor_frame_id].placement * pin.SE3(box.pose.rotation, box.pose.translation)
    return Body(name, robot.n, coal.Box(*box.size_m), placement)


def fixed_body(name: str, shape: Shape) -> Body:
    """An obstacle or a zone."""
    return Body(name, 0, _coal(shape), pin.SE3(shape.pose.rotation, shape.pose.translation))


def _coal(shape: Shape) -> Any:
    match shape:
        case Box():
            return coal.Box(*shape.size_m)
        case Sphere():
            return coal.Sphere(shape.radius_m)
        case Capsule():
            return coal.Capsule(shape.radius_m, shape.length_m)


def corners_of(bodies: list[Body]) -> SpeedPoints:
    """The corners of all bodies that a joint moves."""
    moving = [body for body in bodies if body.joint > 0]
    return SpeedPoints(
        joint=np.repeat([body.joint - 1 for body in moving], 8),
        local=np.concatenate([body.corners for body in moving]),
        owner=tuple(body.name for body in moving for _ in range(8)),
    )


def reach_of(robot: RobotModel, points: SpeedPoints) -> Array:
    """Largest distance of any point behind joint i from its axis, over all configurations.

    Behind joint i the chain may be stretched in any direction: a point of a farther body is at most the length of the
    links between away from the origin of joint i + 1, which itself turns about axis i at a fixed distance.
    """
    placements, axes = robot.chain.placements, robot.chain.axes
    reach = np.zeros(robot.n)
    farthest = 0.0  # from the origin of a joint to a point that it moves
    for i in range(int(points.joint.max()), -1, -1):
        own = points.local[points.joint == i]
        from_axis, from_origin = np.linalg.norm(np.cross(axes[i], own), axis=1), np.linalg.norm(own, axis=1)
        if farthest > 0.0:
            following = placements[i + 1, :3, 3]
            from_axis = np.append(from_axis, np.linalg.norm(np.cross(axes[i], following)) + farthest)
            from_origin = np.append(from_origin, np.linalg.norm(following) + farthest)
        reach[i], farthest = from_axis.max(), from_origin.max()
    return reach
