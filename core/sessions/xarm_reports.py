"""What a UFACTORY controller reports by itself: the arm at every period (port 30000), settings and errors five times a second (30002).

Offsets from the maker's description of the ports; lengths in metres, angles in radians once they are here.
"""

from __future__ import annotations

import struct
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array

FAST_PORT, SLOW_PORT = 30000, 30002
FAST_LEAST, SLOW_LEAST = 736, 579
"""What is read here of a report, B."""
SLOTS = 7
"""Joints in a report; those that an arm has not are zero."""
METRE = 1e-3
"""Of a millimetre, in which a controller counts."""

Pose = tuple[Array, Array]
"""Position (3,), m, and rotation (3, 3)."""


class FastReport(NamedTuple):
    """One sample of the arm; all joints (n,), rad and rad/s.

    Args:
        t: s, of the controller's clock.
        state, mode: of motion.
        queued: motions that wait.
        tool: x y z (m) and three angles of the tool centre point in the base frame.
        raw: (6,), of the force/torque sensor, N and N m.
    """

    t: float
    state: int
    mode: int
    queued: int
    target_q: Array
    target_dq: Array
    q: Array
    dq: Array
    tool: Array
    raw: Array


class SlowReport(NamedTuple):
    """Settings and errors.

    Args:
        motors: whether each motor is on and its brake released.
        offset: the tool centre point in the flange.
        payload: mass (kg) and centre of mass (m) that the controller is set to.
        joint_speed: largest, of all joints, rad/s.
        lower, upper: (n,), joint limits of the reduced mode, rad; None where it is off.
    """

    motors: tuple[bool, ...]
    error: int
    offset: Pose
    payload: tuple[float, ...]
    joint_speed: float
    simulation: bool
    lower: Array | None
    upper: Array | None
    sensor_on: bool


def read_fast(report: bytes, n: int) -> FastReport:
    """A report of port 30000 of an arm with n joints."""
    stamp, _, queued = struct.unpack_from(">QBH", report, 4)
    target_q, target_dq, q, dq = (_floats(report, at, SLOTS)[:n] for at in (32, 60, 116, 144))
    tool = _floats(report, 472, 6)
    tool[:3] *= METRE
    return FastReport(1e-6 * stamp, report[12] & 0x0F, report[12] >> 4, queued, target_q, target_dq, q, dq, tool, _floats(report, 688, 6))


def read_slow(report: bytes, n: int) -> SlowReport:
    """A report of port 30002 of an arm with n joints."""
    motors = tuple(bool(report[87] & report[88] & 1 << k) for k in range(n))
    offset, payload = _floats(report, 91, 6), _floats(report, 115, 4)
    speed, lower, upper = float(_floats(report, 217, 1)[0]), None, None
    if report[495] == 1:
        limits = _floats(report, 516, 2 * SLOTS)[: 2 * n]
        lower, upper = limits[0::2], limits[1::2]
        speed = min(speed, float(_floats(report, 512, 1)[0]))
    return SlowReport(
        motors,
        report[89],
        read_pose(offset * np.repeat([METRE, 1.0], 3), "xyz"),
        (float(payload[0]), *(METRE * payload[1:]).tolist()),
        speed,
        report[314] == 1,
        lower,
        upper,
        bool(report[578] & 1),
    )


def read_pose(numbers: Array, turn: str) -> Pose:
    """A pose of x y z (m) and three angles, rad: roll, pitch and yaw about fixed axes ("xyz"), or a rotation vector ("vector")."""
    angles = numbers[3:]
    turned = Rotation.from_rotvec(angles) if turn == "vector" else Rotation.from_euler("xyz", angles)
    return numbers[:3], turned.as_matrix()


def remove_tool(tool: Pose, offset: Pose) -> Pose:
    """The flange whose tool centre point is at `tool`."""
    rotation = tool[1] @ offset[1].T
    return tool[0] - rotation @ offset[0], rotation


def _floats(report: bytes, at: int, count: int) -> Array:
    return np.array(struct.unpack_from(f"<{count}f", report, at), dtype=float)
