"""The robot's kinematics: a Pinocchio model of the joints between base and sensor, in the world frame.

Pinocchio ships no types; this module and `collision` are the only ones that touch it for the arm.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import pinocchio as pin

from core.array import Array
from core.cell.cell import Cell
from core.cell.folder import check_robot
from core.cell.urdf import check_urdf
from core.cell.urdf_tree import UrdfTree, without_inertia
from core.errors import BadRobot
from core.recording.recording import RobotDescription
from core.robot.chain import Chain, forward, forward_many, jacobian, jacobian_many


@dataclass(frozen=True)
class SensorPose:
    """Where the sensor frame is in the world: rotation (3, 3) and origin (3,), m."""

    rotation: Array
    position: Array


class RobotModel:
    """Kinematics of an arm with revolute joints, from the world (or base) frame to the sensor frame.

    Links behind the sensor frame have shapes and no mass: the sensor feels them, so they count with what is carried.

    Args:
        description: URDF text, joint order and frames.
        base_rotation, base_position: the URDF's base frame in the world.
        where: the file named in errors.

    Raises:
        BadRobot: the URDF cannot be used.
    """

    def __init__(
        self,
        description: RobotDescription,
        *,
        base_rotation: Array | None = None,
        base_position: Array | None = None,
        where: str = "robot.urdf",
    ) -> None:
        chain = check_urdf(description.urdf, where).chain(description.base_frame, description.sensor_frame)
        if description.joints != chain:
            raise BadRobot(f"{where}: joints", "robot-joints-not-of-chain", joints=description.joints, chain=chain)
        self.description = description
        try:
            model = _build_model(description).copy()
        except (ValueError, RuntimeError) as error:
            raise BadRobot(where, "robot-urdf-not-taken", reason=str(error)[:300]) from error
        data = model.createData()
        pin.framesForwardKinematics(model, data, pin.neutral(model))
        urdf_to_base = data.oMf[model.getFrameId(description.base_frame)].inverse()
        world = pin.SE3(
            np.eye(3) if base_rotation is None else base_rotation,
            np.zeros(3) if base_position is None else base_position,
        )
        self.root = world * urdf_to_base
        """Placement of the URDF's root link in the world."""
        for j in range(1, model.njoints):
            if model.parents[j] == 0:
                model.jointPlacements[j] = self.root * model.jointPlacements[j]
        for frame in model.frames:
            if frame.parentJoint == 0:
                frame.placement = self.root * frame.placement
        self.model = model
        self.data = model.createData()
        self.sensor_frame_id = model.getFrameId(description.sensor_frame)
        if model.frames[self.sensor_frame_id].parentJoint != model.njoints - 1:
            raise BadRobot(f"{where}: sensor_frame", "robot-sensor-frame-elsewhere", frame=description.sensor_frame)

    @classmethod
    def of_cell(cls, cell: Cell) -> RobotModel:
        """The cell's robot in the world frame; home and limits are checked against the URDF.

        Raises:
            BadCell, BadRobot.
        """
        where = str(cell.folder / cell.robot.urdf)
        urdf = check_urdf(cell.urdf, where)
        check_robot(cell, urdf)
        joints = urdf.chain(cell.robot.base_frame, cell.robot.sensor_frame)
        description = RobotDescription(cell.urdf, joints, cell.robot.base_frame, cell.robot.sensor_frame)
        base = cell.robot.base
        return cls(description, base_rotation=base.rotation, base_position=base.translation, where=where)

    @property
    def n(self) -> int:
        """Number of joints."""
        return int(self.model.nq)

    @cached_property
    def lower(self) -> Array:
        """Joint position limits (n,), rad."""
        return np.array(self.model.lowerPositionLimit)

    @cached_property
    def upper(self) -> Array:
        """Joint position limits (n,), rad."""
        return np.array(self.model.upperPositionLimit)

    @cached_property
    def velocity(self) -> Array:
        """Joint velocity limits (n,) of the URDF, rad/s."""
        return np.array(self.model.upperVelocityLimit)

    @cached_property
    def chain(self) -> Chain:
        """The same kinematics as arrays for compiled code."""
        model, data = self.model, self.data
        pin.computeJointJacobians(model, data, pin.neutral(model))
        J = data.J
        placements = np.stack(
            [np.asarray(model.jointPlacements[j].homogeneous) for j in range(1, model.njoints)]
            + [np.asarray(model.frames[self.sensor_frame_id].placement.homogeneous)]
        )
        axes = np.stack([data.oMi[j + 1].rotation.T @ J[3:, j] for j in range(self.n)])
        return Chain(placements, axes)

    def sensor_pose(self, q: Array) -> SensorPose:
        """Sensor frame in the world at q (n,)."""
        T = forward(self.chain, np.ascontiguousarray(q, dtype=float))
        return SensorPose(T[:3, :3], T[:3, 3])

    def sensor_poses(self, q: Array) -> SensorPose:
        """Sensor frame at every row of q (N, n): rotation (N, 3, 3), position (N, 3)."""
        T = forward_many(self.chain, np.ascontiguousarray(q, dtype=float))
        return SensorPose(T[:, :3, :3], T[:, :3, 3])

    def sensor_twist(self, q: Array, dq: Array, ddq: Array) -> tuple[Array, Array]:
        """Velocity and acceleration (6,) of the sensor frame at one instant: of its origin, then angular, in sensor axes."""
        pin.forwardKinematics(self.model, self.data, q, dq, ddq)
        local = pin.ReferenceFrame.LOCAL
        v = pin.getFrameVelocity(self.model, self.data, self.sensor_frame_id, local)
        a = pin.getFrameClassicalAcceleration(self.model, self.data, self.sensor_frame_id, local)
        return np.array(v.vector), np.array(a.vector)

    def sensor_jacobian(self, q: Array) -> Array:
        """(6, n), linear then angular velocity of the sensor origin, in sensor axes, per joint velocity."""
        return jacobian(self.chain, np.ascontiguousarray(q, dtype=float))

    def sensor_jacobians(self, q: Array) -> Array:
        """(N, 6, n), as `sensor_jacobian`, at every row of q (N, n)."""
        return jacobian_many(self.chain, np.ascontiguousarray(q, dtype=float))


@lru_cache(maxsize=8)
def _build_model(description: RobotDescription) -> pin.Model:
    """Pinocchio's model of the joints that move; what hangs behind the sensor weighs nothing. Read once for all who ask."""
    full = pin.buildModelFromXML(without_inertia(description.urdf, UrdfTree(description.urdf).behind(description.sensor_frame)))
    others = [full.getJointId(name) for name in full.names[1:] if name not in description.joints]
    return pin.buildReducedModel(full, others, pin.neutral(full))
