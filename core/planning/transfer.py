"""A transfer: from one configuration to another, planned, rounded, timed, and checked once more as it will be commanded.

Where a load that comes off would fly into a protected zone, or a joint has not the torque, the transfer is made slower, and where that
does not help, another way.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.interpolate import PPoly

from core.array import Array
from core.cell.body_name import name_body
from core.cell.cell import Cell
from core.errors import NoPath
from core.planning.blending import round_corners
from core.planning.certificate import least_margin
from core.planning.effort import PATH_ITERATIONS
from core.planning.joint_torques import JointTorques
from core.planning.path import SPARE_M, START, check_drop, nearest_names, plan_path
from core.planning.room import Room
from core.planning.settings import Planner
from core.planning.throw import ThrowCheck
from core.planning.timing import MotionLimits, time_curve
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.trajectory import JointTrajectory

SPEED_FRACTION = 0.96
"""Part of the Cartesian limit that is planned with; the rest is left to the controller's tracking error."""

LEFT_BY_ROUNDING = 0.6
"""Part of a path's margin that rounding a corner may not use up: what is left for the controller's tracking error."""

SLOWER = (1.0, 0.5, 0.25, 0.12)
"""Parts of the speed, one after the other, at which a load is not thrown into a zone and the joints have the torque."""

_TRIES = 4


@dataclass(frozen=True)
class Transfer:
    """A transfer that may be commanded as it is.

    Args:
        trajectory: joint positions at the control period, at rest at both ends.
        least_margin_m: smallest distance beyond what is required, along the trajectory.
        certified_margin_m: nowhere, also between samples, is the margin smaller than this.
        nearest: the pair of bodies where it is least.
        length_rad: of the path in joint space.
    """

    trajectory: JointTrajectory
    least_margin_m: float
    certified_margin_m: float
    nearest: str
    length_rad: float

    @property
    def goal(self) -> Array:
        """(n,), where it ends."""
        return np.asarray(self.trajectory.q[-1])


def plan_transfer(
    cell: Cell,
    robot: RobotModel,
    collision: CollisionModel,
    start: Array,
    goal: Array,
    *,
    period: float,
    seed: int = 0,
    planner: Planner = "rrt_connect",
    iterations: int = PATH_ITERATIONS[-1],
    torques: JointTorques | None = None,
    spare_m: float = SPARE_M,
) -> Transfer:
    """Timed transfer from start (n,) to goal that keeps all distances and limits.

    Args:
        goal: (n,), or (K, n) for a transfer to any one of them; `Transfer.goal` tells which.
        period: control period, s.
        iterations: bound on the search for a path, for each of a few tries.
        torques: with the load that the joints have to carry; None where they are not to be judged.
        spare_m: margin of the path on top of the required distances.

    Raises:
        NoPath: with the reason of the last try.
    """
    throws = ThrowCheck(cell)
    if any(np.array_equal(start, q) for q in np.atleast_2d(goal)):
        check_drop(START, np.array(start, dtype=float), robot, collision, throws)
        return _stand_still(collision, start, period)
    limits = MotionLimits.of_cell(cell, robot, collision)
    limits = replace(limits, cartesian_speed_m_s=SPEED_FRACTION * limits.cartesian_speed_m_s)
    for attempt in range(_TRIES):
        path = plan_path(
            cell, robot, collision, start, goal,
            planner=planner, seed=seed + 1000 * attempt, iterations=iterations, torques=torques, spare_m=spare_m,
        )  # fmt: skip
        room = Room(robot, collision, throws, path.q[[0, -1]], LEFT_BY_ROUNDING * spare_m, torques)
        try:
            trajectory = _time_safely(path.q, round_corners(path.q, room.has_all), robot, collision, throws, torques, limits, period)
        except NoPath as error:
            failure = error
            continue
        least = least_margin(room.margins, trajectory.q)
        if least.bound_m >= 0.0:
            names = nearest_names(collision, least)
            return Transfer(trajectory, least.margin_m, least.bound_m, names, path.length_rad)
        near = collision.nearest(least.q)
        first, second = name_body(cell, near.first), name_body(cell, near.second)
        failure = NoPath("planning-rounding-too-close", depth_m=-least.margin_m, first=first, second=second, in_the_way=near.second)
    raise failure


def _time_safely(
    path_q: Array,
    curve: PPoly,
    robot: RobotModel,
    collision: CollisionModel,
    throws: ThrowCheck,
    torques: JointTorques | None,
    limits: MotionLimits,
    period: float,
) -> JointTrajectory:
    """The trajectory along a curve, as fast as a load that comes off anywhere stays out of the zones and the joints have the torque.

    Where they have not even for the slowest, that is returned: what the whole plan asks of them is judged when it is finished.

    Raises:
        NoPath: it cannot be timed, or a load flies into a zone even from the slowest.
    """
    for share in SLOWER:
        slower = replace(limits, cartesian_speed_m_s=share * limits.cartesian_speed_m_s, acceleration=share**2 * limits.acceleration)
        trajectory = _between(path_q, time_curve(curve, robot, slower, period=period))
        throw = throws.into_zone(collision.payload_box, robot.sensor_poses(trajectory.q), period)
        if throw is None and (torques is None or torques.suffice(trajectory)):
            break
    if throw is not None:
        raise NoPath(
            "planning-transfer-throws-load",
            time_s=throw.time_s, speed_m_s=throw.speed_m_s, depth_m=-throw.distance_m, zone=throw.zone, in_the_way=throw.zone,
        )  # fmt: skip
    return trajectory


def _between(path_q: Array, trajectory: JointTrajectory) -> JointTrajectory:
    """The trajectory with the very ends of the path, which polynomials only meet to the last digit but one."""
    q = trajectory.q.copy()
    q[0], q[-1] = path_q[0], path_q[-1]
    return replace(trajectory, q=q)


def _stand_still(collision: CollisionModel, q: Array, period: float) -> Transfer:
    """The transfer of a robot that is there already."""
    nearest = collision.nearest(q)
    if nearest.margin_m < 0.0:
        first, second = name_body(collision.cell, nearest.first), name_body(collision.cell, nearest.second)
        if nearest.distance_m < 0.0:
            raise NoPath("planning-stands-inside", first=first, second=second, depth_m=-nearest.distance_m, in_the_way=nearest.second)
        raise NoPath(
            "planning-stands-too-close",
            first=first, second=second, distance_m=nearest.distance_m, required_m=nearest.required_m, in_the_way=nearest.second,
        )  # fmt: skip
    trajectory = JointTrajectory(period, np.array([q], dtype=float))
    return Transfer(trajectory, nearest.margin_m, nearest.margin_m, f"{nearest.first} - {nearest.second}", 0.0)
