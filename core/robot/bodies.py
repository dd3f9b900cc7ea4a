"""The convex bodies of robot, payload box, obstacles and zones, as Coal's shapes, and how far they can move."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from core.array import Array
from core.cell.cell import Box, Capsule, Cell, Cylinder, Mesh, Shape, Sphere
from core.cell.tools import tool_boxes
from core.cell.urdf import check_urdf
from core.cell.urdf_elements import UrdfShape
from core.robot.meshes import WantedMesh, read_meshes
from core.robot.model import RobotModel

PAYLOAD = "payload"
FLOOR = "floor"


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
        carried: whether the arm carries it: the payload, or a tool.
    """

    name: str
    joint: int
    geometry: Any
    placement: Any
    carried: bool = False

    @cached_property
    def corners(self) -> Array:
        """(8, 3), corners of the box round the body, in the joint's frame or the world, m."""
        self.geometry.computeLocalAABB()
        ends = np.array([self.geometry.aabb_local.min_, self.geometry.aabb_local.max_])
        corners = np.stack(np.meshgrid(*ends.T), axis=-1).reshape(-1, 3)
        return np.asarray(corners @ self.placement.rotation.T + self.placement.translation)


@dataclass(frozen=True)
class LinkShape:
    """A shape of a link, for collisions or for the eye.

    Args:
        joint: number of the joint that carries it as Pinocchio counts, 0 for what does not move.
        parts: of a mesh the corners (k, 3) of the convex parts that together contain it, m.
    """

    link: str
    joint: int
    placement: Any
    shape: UrdfShape
    parts: tuple[Array, ...] = ()


def link_bodies(cell: Cell, robot: RobotModel) -> list[Body]:
    """The bodies of the robot's links, several for some; those of the base are in the world frame, as the model's frames are.

    Raises:
        BadRobot: a mesh that cannot be used, also among those that are only looked at.
    """
    carried = {link for tool in cell.tools.values() for link in tool.links or ()}
    return [
        Body(each.link, each.joint, geometry, each.placement, each.link in carried)
        for each in collision_shapes(cell, robot)
        for geometry in _geometries(each)
    ]


def collision_shapes(cell: Cell, robot: RobotModel) -> list[LinkShape]:
    """The shapes that something can run into: those of <collision>, of <visual> where the cell says so.

    Raises:
        BadRobot: as `link_bodies`.
    """
    return _link_shapes(cell, robot)[0]


def visual_shapes(cell: Cell, robot: RobotModel) -> list[LinkShape]:
    """What the robot looks like.

    Raises:
        BadRobot: as `link_bodies`.
    """
    return _link_shapes(cell, robot)[1]


def _link_shapes(cell: Cell, robot: RobotModel) -> tuple[list[LinkShape], list[LinkShape]]:
    """Shapes for collisions and for the eye; all meshes are read at once, so that a plan is not made for a robot that cannot be drawn."""
    urdf = check_urdf(cell.urdf, str(cell.folder / cell.robot.urdf))
    shapes = [(link.name, shape, True) for link in urdf.bodies for shape in link.collision]
    shapes += [(link.name, shape, True) for link in urdf.bodies if link.name in cell.robot.visual_shapes for shape in link.visual]
    shapes += [(link.name, shape, False) for link in urdf.bodies for shape in link.visual]
    meshed = [each for each in shapes if each[1].kind == "mesh"]
    wanted = [WantedMesh(f"{urdf.where}: link {name!r}", shape.file, shape.sizes, solid) for name, shape, solid in meshed]
    meshes = iter(read_meshes(cell.folder, wanted))
    found: tuple[list[LinkShape], list[LinkShape]] = [], []
    for name, shape, solid in shapes:
        frame = robot.model.frames[robot.model.getFrameId(name, pin.FrameType.BODY)]
        placement = frame.placement * pin.SE3(pin.rpy.rpyToMatrix(shape.rpy), shape.xyz)
        parts = next(meshes).parts if shape.kind == "mesh" else ()
        found[0 if solid else 1].append(LinkShape(name, frame.parentJoint, placement, shape, parts))
    return found


def _geometries(each: LinkShape) -> list[Any]:
    """Coal's shapes."""
    sizes = each.shape.sizes
    match each.shape.kind:
        case "box":
            return [coal.Box(*sizes)]
        case "sphere":
            return [coal.Sphere(*sizes)]
        case "capsule":
            return [coal.Capsule(*sizes)]
        case "cylinder":
            return [coal.Cylinder(*sizes)]
    return [_hull(part) for part in each.parts]


def _hull(corners: Array) -> Any:
    """Coal's convex polyhedron of corners (k, 3) that are in no plane."""
    points = coal.StdVec_Vec3s()
    for corner in corners:
        points.append(corner)
    return coal.ConvexBase.convexHull(points, True, "Qt")


def payload_body(robot: RobotModel, box: Box) -> Body:
    """The payload box, given in the sensor frame."""
    return _attach_box(PAYLOAD, robot, box)


def tool_bodies(cell: Cell, robot: RobotModel) -> list[Body]:
    """The boxes of the cell's tools, by the tools' names; tools made of links are among `link_bodies`."""
    return [_attach_box(name, robot, box) for name, box in tool_boxes(cell).items()]


def _attach_box(name: str, robot: RobotModel, box: Box) -> Body:
    placement = robot.model.frames[robot.sensor_frame_id].placement * pin.SE3(box.pose.rotation, box.pose.translation)
    return Body(name, robot.n, coal.Box(*box.size_m), placement, carried=True)


def standing_bodies(cell: Cell) -> dict[str, tuple[Body, ...]]:
    """Obstacles, then zones, by their names; of a mesh the convex parts that contain it.

    Raises:
        BadRobot: a mesh that cannot be used.
    """
    parts = standing_parts(cell)
    found = {}
    for item in cell.standing:
        if isinstance(item.shape, Mesh):
            placement = pin.SE3(item.shape.pose.rotation, item.shape.pose.translation)
            found[item.name] = tuple(Body(item.name, 0, _hull(part), placement) for part in parts[item.name])
        else:
            found[item.name] = (_fixed_body(item.name, item.shape),)
    return found


def standing_parts(cell: Cell) -> dict[str, tuple[Array, ...]]:
    """Corners (k, 3) of the convex parts that contain each obstacle or zone that is a mesh, in the frame of its `pose`, m.

    Raises:
        BadRobot: a mesh that cannot be used.
    """
    meshes = cell.standing_meshes
    wanted = [WantedMesh(cell.locate(key), shape.file, shape.scale, solid=True) for key, shape in meshes.items()]
    return {key.partition(".")[2]: mesh.parts for key, mesh in zip(meshes, read_meshes(cell.folder, wanted), strict=True)}


def _fixed_body(name: str, shape: Shape) -> Body:
    """An obstacle or a zone that is no mesh."""
    return Body(name, 0, _coal(shape), pin.SE3(shape.pose.rotation, shape.pose.translation))


def floor_body(floor_z_m: float) -> Body:
    """Everything below that height in the world."""
    return Body(FLOOR, 0, coal.Halfspace(np.array([0.0, 0.0, 1.0]), floor_z_m), pin.SE3.Identity())


def _coal(shape: Shape) -> Any:
    match shape:
        case Box():
            return coal.Box(*shape.size_m)
        case Sphere():
            return coal.Sphere(shape.radius_m)
        case Capsule():
            return coal.Capsule(shape.radius_m, shape.length_m)
        case Cylinder():
            return coal.Cylinder(shape.radius_m, shape.length_m)


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
