"""What the controller takes for an external torque where its payload is wrong.

A momentum observer (De Luca and Mattone 2003) with a wrong payload sees, beside what touches the arm, the torque that the error of the
payload would need, through a low-pass of first order with the observer's gain. Both are linear in the error of the ten parameters.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.signal import lfilter

from core.array import Array
from core.cell.cell import Cell
from core.payload.inertia import Motion, regressor
from core.requirement.motions import JointMotion
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
    twists = [robot.sensor_twist(*row) for row in zip(motion.q, motion.dq, motion.ddq, strict=True)]
    velocity, acceleration = (np.array(each) for each in zip(*twists, strict=True))
    g = np.einsum("kji,j->ki", robot.sensor_poses(motion.q).rotation, cell.gravity)
    V = regressor(Motion(g, acceleration[:, :3], velocity[:, 3:], acceleration[:, 3:]))
    J = np.stack([robot.sensor_jacobian(row) for row in motion.q])
    needed = J.transpose(0, 2, 1) @ V
    kept = float(np.exp(-observer_rate_per_s * motion.period_s))
    seen = lfilter([1.0 - kept], [1.0, -kept], needed, axis=0, zi=kept * needed[:1])[0]
    clear = np.linalg.svd(J, compute_uv=False)[:, -1] > SINGULAR
    wrench = np.linalg.pinv(J[clear].transpose(0, 2, 1)) @ seen[clear]
    return Response(seen, wrench[:, :3], regressor(Motion.still(g))[:, :3], motion.period_s)
