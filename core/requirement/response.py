"""What the controller takes for an external torque where its payload is wrong.

A momentum observer (De Luca and Mattone 2003) with a wrong payload sees, beside what touches the arm, the torque that the error of the
payload would need, through a low-pass of first order with the observer's gain. Both are linear in the error of the ten parameters.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.payload.inertia import Motion, regressor
from core.requirement.motions import JointMotion

if TYPE_CHECKING:  # who only reads requirements waits for no robot
    from core.robot.model import RobotModel

SINGULAR = 0.02
"""m/rad: where the flange moves less per radian in some direction, forces in that direction are not told from joint torques."""


@dataclass(frozen=True)
class Response:
    """What an error of the payload looks like along a motion.

    Args:
        torque_nm: (N, n, 10), external torque of each joint that the observer reports, per unit of each parameter.
        force_n: (M, 3, 10), external force at the sensor frame that follows from it, in sensor axes, where the arm is not singular.
        guiding_force_n: (N, 3, 10), force that somebody feels who holds the arm still.
        period_s: between rows of `torque_nm`.
    """

    torque_nm: Array
    force_n: Array
    guiding_force_n: Array
    period_s: float


def respond(cell: Cell, robot: RobotModel, motion: JointMotion, observer_rate_per_s: float) -> Response:
    """The observer's answer to errors of the payload along a motion that begins at rest."""
    J = robot.sensor_jacobians(motion.q)
    g = np.einsum("kji,j->ki", robot.sensor_poses(motion.q).rotation, cell.gravity)
    V = regressor(_felt_motion(J, motion, g))
    seen = _low_pass(J.transpose(0, 2, 1) @ V, observer_rate_per_s * motion.period_s)
    return Response(seen, _force(J, seen), regressor(Motion.still(g))[:, :3], motion.period_s)


def find_felt_motion(robot: RobotModel, gravity: Array, motion: JointMotion) -> Motion:
    """What the sensor frame does along a motion of the joints, in its own axes.

    Args:
        gravity: (3,), in the frame of the robot's poses.
    """
    g = np.einsum("kji,j->ki", robot.sensor_poses(motion.q).rotation, gravity)
    return _felt_motion(robot.sensor_jacobians(motion.q), motion, g)


def _felt_motion(J: Array, motion: JointMotion, g: Array) -> Motion:
    """What the sensor frame does, of its Jacobians (N, 6, n) in sensor axes.

    A column of J is the screw of a joint, fixed in the link before it: in sensor axes it turns as that link moves against the sensor,
    `dS_j/dt = (V_j - V) x S_j` (Featherstone 2008, section 2.9 with 2.10).
    """
    parts = J * motion.dq[:, None, :]
    twist = parts.sum(axis=2)
    against = np.cumsum(parts, axis=2) - twist[:, :, None]
    v, w, v_of, w_of = against[:, :3], against[:, 3:], J[:, :3], J[:, 3:]
    rate = np.concatenate([np.cross(w, v_of, axis=1) + np.cross(v, w_of, axis=1), np.cross(w, w_of, axis=1)], axis=1)
    acceleration = (J @ motion.ddq[:, :, None] + rate @ motion.dq[:, :, None])[:, :, 0]
    linear = acceleration[:, :3] + np.cross(twist[:, 3:], twist[:, :3])  # of the point at the sensor's origin, not of the field
    return Motion(g, linear, twist[:, 3:], acceleration[:, 3:])


def _low_pass(needed: Array, periods: float) -> Array:
    """First order, at rest before, exact for what is straight between the rows.

    Args:
        needed: (N, ...).
        periods: of the rows, in time constants.
    """
    from scipy.signal import lfilter  # noqa: PLC0415 - the service knows what a requirement is, and starts without SciPy

    kept = float(np.exp(-periods))
    mean = (1.0 - kept) / periods
    return np.asarray(lfilter([1.0 - mean, mean - kept], [1.0, -kept], needed, axis=0, zi=mean * needed[:1])[0])


def _force(J: Array, seen: Array) -> Array:
    """(M, 3, 10), the force of least norm with its torque that makes these torques (N, n, 10), where the arm is not singular."""
    wide = J.shape[2] >= J.shape[1]
    gram = J @ J.transpose(0, 2, 1) if wide else J.transpose(0, 2, 1) @ J
    clear = np.linalg.eigvalsh(gram)[:, 0] > SINGULAR**2
    J, gram, seen = J[clear], gram[clear], seen[clear]
    wrench = np.linalg.solve(gram, J @ seen) if wide else J @ np.linalg.solve(gram, seen)
    return np.asarray(wrench[:, :3])
