"""Where on the joints' side: tracking error while moving against its noise, and joint torque that arm and payload do not account for."""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from core.array import Array
from core.gap.answer import JointGap
from core.recording.recording import Recording
from core.robot.model import RobotModel

ROWS = 1000
"""No more rows than about this many are looked at."""
MOVING_RAD_S = 0.02


def joint_side(recording: Recording, offset: Array) -> list[JointGap]:
    """One entry per joint; empty where neither commands nor torques were recorded.

    Args:
        recording: with joints.
        offset: (6,), of the wrist sensor, N and N m.
    """
    q, robot = recording.q, recording.robot
    if q is None or robot is None or (recording.q_cmd is None and recording.tau is None):
        return []
    rows = slice(0, None, max(1, len(q) // ROWS))
    moving = np.abs(np.gradient(q, recording.t, axis=0)[rows]) > MOVING_RAD_S
    tracking = None if recording.q_cmd is None else recording.q_cmd - q
    torque = _find_unexplained_torque(recording, RobotModel(robot), rows, offset)
    return [
        JointGap(
            joint=name,
            tracking_rms_rad=None if tracking is None else _rms(tracking[rows, j][moving[:, j]]),
            tracking_noise_rad=None if tracking is None else _noise(tracking[:, j]),
            torque_rms_n_m=None if torque is None else _rms(torque[:, j]),
        )
        for j, name in enumerate(robot.joints)
    ]


def _rms(values: Array) -> float | None:
    return float(np.sqrt(np.mean(values**2))) if len(values) else None


def _noise(error: Array) -> float:
    """Of one sample of a joint's error (N,): from third differences, which motion hardly reaches."""
    return float(np.sqrt(np.mean(np.diff(error, n=3) ** 2) / 20.0))


def _find_unexplained_torque(recording: Recording, robot: RobotModel, rows: slice, offset: Array) -> Array | None:
    """(M, n), N m, torque less what gravity and motion ask of the arm by its masses and what the wrist's wrench asks of it."""
    if recording.tau is None or recording.q is None or recording.wrench is None:
        return None
    if sum(inertia.mass for inertia in robot.model.inertias) <= 0.0:
        return None
    model = robot.model.copy()
    model.gravity.linear = recording.gravity
    data = model.createData()
    arm = np.stack([pin.computeGeneralizedGravity(model, data, row) for row in recording.q[rows]])
    load = robot.sensor_jacobians(recording.q[rows])
    return np.asarray(recording.tau[rows] - arm - np.einsum("nij,ni->nj", load, recording.wrench[rows] - offset))
