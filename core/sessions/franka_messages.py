"""The messages of the Franka Control Interface (FCI): what a controller tells a thousand times a second, and what it is told.

Packed little-endian structures, by the headers that Franka publishes (libfranka-common, `research_interface/robot/rbk_types.h`,
`service_types.h`, `error.h`), of the server versions 5 (Panda, system 4.2) to 10 (Franka Research 3, system 5.9). What differs between
them is in `Dialect`. Numbers of a state have single precision in the published layout of version 10 and double precision before; the
length of a datagram tells which.
"""

from __future__ import annotations

import struct
from enum import IntEnum
from itertools import accumulate
from typing import NamedTuple

import numpy as np

from core.array import Array

OLDEST, NEWEST = 5, 10
"""Versions of the server that are known here."""
JOINTS = 7
PERIOD = 0.001
"""Of the controller, s; a state's number counts its periods."""
NUMBERS: dict[str, int] = {
    "O_T_EE": 16, "O_T_EE_d": 16, "F_T_EE": 16, "EE_T_K": 16, "F_T_NE": 16, "NE_T_EE": 16,
    "m_ee": 1, "I_ee": 9, "F_x_Cee": 3, "m_load": 1, "I_load": 9, "F_x_Cload": 3, "elbow": 2, "elbow_d": 2,
    "tau_J": 7, "tau_J_d": 7, "dtau_J": 7, "q": 7, "q_d": 7, "dq": 7, "dq_d": 7, "ddq_d": 7,
    "joint_contact": 7, "cartesian_contact": 6, "joint_collision": 7, "cartesian_collision": 6,
    "tau_ext_hat_filtered": 7, "O_F_ext_hat_K": 6, "K_F_ext_hat_K": 6, "O_dP_EE_d": 6, "O_ddP_O": 3,
    "elbow_c": 2, "delbow_c": 2, "ddelbow_c": 2, "O_T_EE_c": 16, "O_dP_EE_c": 6, "O_ddP_EE_c": 6, "theta": 7, "dtheta": 7,
}  # fmt: skip
"""Numbers of a state in their order, with the maker's names; version 10 has 36 of accelerometers behind them."""
ACCELEROMETERS = 36
ERRORS = 41
PLACES = {name: slice(end - NUMBERS[name], end) for name, end in zip(NUMBERS, accumulate(NUMBERS.values()), strict=True)}
COUNT = sum(NUMBERS.values())
HEADER = struct.Struct("<III")
"""Command, its number, and the length of the whole message, B."""


class Mode(IntEnum):
    """Of the robot."""

    OTHER = 0
    IDLE = 1
    MOVE = 2
    GUIDING = 3
    REFLEX = 4
    USER_STOPPED = 5
    RECOVERING = 6


class Command(IntEnum):
    """What is asked over TCP, by a number of Heft's own; `Dialect.commands` has the server's."""

    CONNECT = 0
    MOVE = 1
    STOP_MOVE = 2
    SET_LOAD = 3
    GET_MODEL = 4


IDLE_MOTION, JOINT_POSITION, JOINT_IMPEDANCE = 0, 1, 0
"""Of a state: no motion generator, that of joint positions; the controller that follows it. A move asks for it by a number one less."""
CONNECTED, OTHER_VERSION = 0, 1
"""Answers to a connection."""
ERROR_NAMES = (
    "joint_position_limits_violation", "cartesian_position_limits_violation", "self_collision_avoidance_violation",
    "joint_velocity_violation", "cartesian_velocity_violation", "force_control_safety_violation", "joint_reflex", "cartesian_reflex",
    "max_goal_pose_deviation_violation", "max_path_pose_deviation_violation", "cartesian_velocity_profile_safety_violation",
    "joint_position_motion_generator_start_pose_invalid", "joint_motion_generator_position_limits_violation",
    "joint_motion_generator_velocity_limits_violation", "joint_motion_generator_velocity_discontinuity",
    "joint_motion_generator_acceleration_discontinuity", "cartesian_position_motion_generator_start_pose_invalid",
    "cartesian_motion_generator_elbow_limit_violation", "cartesian_motion_generator_velocity_limits_violation",
    "cartesian_motion_generator_velocity_discontinuity", "cartesian_motion_generator_acceleration_discontinuity",
    "cartesian_motion_generator_elbow_sign_inconsistent", "cartesian_motion_generator_start_elbow_invalid",
    "force_controller_desired_force_tolerance_violation", "start_elbow_sign_inconsistent", "communication_constraints_violation",
    "power_limit_violation", "cartesian_motion_generator_joint_position_limits_violation",
    "cartesian_motion_generator_joint_velocity_limits_violation", "cartesian_motion_generator_joint_velocity_discontinuity",
    "cartesian_motion_generator_joint_acceleration_discontinuity", "cartesian_position_motion_generator_invalid_frame_flag",
    "controller_torque_discontinuity", "joint_p2p_insufficient_torque_for_planning", "tau_J_range_violation", "instability_detected",
    "joint_move_in_wrong_direction", "cartesian_spline_motion_generator_violation",
    "joint_via_motion_generator_planning_joint_limit_violation", "base_acceleration_initialization_timeout",
    "base_acceleration_invalid_reading",
)  # fmt: skip
"""Of the flags of a state, in their order; their names say what they mean."""


class FrankaError(ConnectionError):
    """What came is no message of the interface."""


class Dialect(NamedTuple):
    """How a server of one version is spoken to.

    Args:
        commands: its number of each command; absent where it has none.
        outcomes: its names of what becomes of a move, in their order.
        move_tail: B behind the request of a move: the asynchronous generator, which is left off.
        command_tail: B behind a command of motion.
    """

    commands: dict[Command, int]
    outcomes: tuple[str, ...]
    move_tail: int
    command_tail: int


_EARLY = (
    "success", "started", "preempted", "not-possible", "singular", "invalid", "reflex", "emergency", "input", "aborted",
)  # fmt: skip
_LATE = (
    "success", "started", "preempted", "preempted-safety", "rejected-safety", "not-possible", "singular", "invalid", "reflex", "emergency",
    "input", "aborted",
)  # fmt: skip


def dialect_of(version: int) -> Dialect:
    """That of a server of this version, `OLDEST` to `NEWEST`."""
    commands = {Command.CONNECT: 0, Command.MOVE: 1, Command.STOP_MOVE: 2, Command.SET_LOAD: 9 if version >= 6 else 10}
    if version >= 8:
        commands[Command.GET_MODEL] = 11 if version >= 10 else 12
    return Dialect(commands, _LATE if version >= 6 else _EARLY, 57 if version >= 10 else 0, 1 if version >= 7 else 0)


class Sample(NamedTuple):
    """What a controller tells in one cycle; joints (7,), rad, N m, in its order.

    Args:
        number: counts its periods.
        q_d, dq_d, ddq_d: the position that it commands now, and its backward differences: the last command, or what it put in its place.
        torque: measured behind the gears.
        external: torques that it does not explain by what it knows of the arm and its load.
        estimate: (6,), N and N m, the force on the tool as it follows from these: no measurement.
        pose, tool: (4, 4), end effector in the base, and in the flange.
        end_effector_kg: as set up in Desk.
        load: mass, inertia (9,) and centre of mass (3,) as set by `setLoad`.
        motion, controller: which run, see `JOINT_POSITION`, `JOINT_IMPEDANCE`.
        errors, reasons: flags of now and of what ended the last motion, see `ERROR_NAMES`.
    """

    number: int
    q: Array
    dq: Array
    q_d: Array
    dq_d: Array
    ddq_d: Array
    torque: Array
    external: Array
    estimate: Array
    pose: Array
    tool: Array
    end_effector_kg: float
    load: Array
    motion: int
    controller: int
    errors: bytes
    reasons: bytes
    mode: int

    @property
    def t(self) -> float:
        """Of the controller's clock, s."""
        return self.number * PERIOD

    def error_names(self) -> list[str]:
        """Of the flags of now, and where there are none, of what ended the last motion."""
        flags = self.errors if any(self.errors) else self.reasons
        return [name for name, flag in zip(ERROR_NAMES, flags, strict=True) if flag]


_TAIL = 2 + 2 * ERRORS + 1
"""B behind the numbers: two modes, two sets of flags, the robot's mode; the share of commands comes last."""
_KINDS = {8 + size * (count + 1) + _TAIL: (np.dtype(f"<f{size}"), count) for size in (4, 8) for count in (COUNT, COUNT + ACCELEROMETERS)}
"""Type and count of the numbers by the length of a datagram."""


def read_state(data: bytes) -> Sample:
    """A controller's datagram.

    Raises:
        FrankaError: it is none, or of another length.
    """
    if len(data) not in _KINDS:
        raise FrankaError(f"a state of {len(data)} B")
    kind, count = _KINDS[len(data)]
    number = int.from_bytes(data[:8], "little")
    given = np.frombuffer(data, kind, COUNT, 8).astype(np.float64)
    at = 8 + kind.itemsize * count
    motion, controller = data[at], data[at + 1]
    errors, reasons = data[at + 2 : at + 2 + ERRORS], data[at + 2 + ERRORS : at + 2 + 2 * ERRORS]
    q, dq, q_d, dq_d, ddq_d, torque, external, estimate, pose, tool = (
        given[PLACES[name]]
        for name in ("q", "dq", "q_d", "dq_d", "ddq_d", "tau_J", "tau_ext_hat_filtered", "O_F_ext_hat_K", "O_T_EE", "F_T_EE")
    )
    if not np.isfinite(given[: PLACES["tau_ext_hat_filtered"].stop]).all():
        raise FrankaError("a state with numbers that are none")
    load = given[PLACES["m_load"].start : PLACES["F_x_Cload"].stop]
    return Sample(
        number, q, dq, q_d, dq_d, ddq_d, torque, external, estimate, pose.reshape(4, 4).T, tool.reshape(4, 4).T,
        float(given[PLACES["m_ee"]][0]), load, motion, controller, errors, reasons, data[at + 2 + 2 * ERRORS],
    )  # fmt: skip


_COMMAND = struct.Struct("<Q38d2?7d")
"""Number of the state that is answered; joint positions, joint speeds, pose, twist, elbow, two flags; torques."""


def write_command(number: int, q: Array, *, finished: bool, tail: int) -> bytes:
    """What answers a state: joint positions (7,), rad.

    Args:
        finished: whether the motion ends with it.
        tail: `Dialect.command_tail`.
    """
    return _COMMAND.pack(number, *q.tolist(), *[0.0] * 31, False, finished, *[0.0] * 7) + bytes(tail)


def write_connect(version: int, udp_port: int) -> bytes:
    """Body of a request for a connection."""
    return struct.pack("<HH", version, udp_port)


def write_move(tail: int) -> bytes:
    """Body of a request to follow joint positions with the controller's own joint impedance; no deviation is monitored that only the
    motions of the controller itself could have (the maker's client asks for the same).

    Args:
        tail: `Dialect.move_tail`.
    """
    return struct.pack("<II6d", JOINT_IMPEDANCE, JOINT_POSITION - 1, *(10.0, 3.12, 2.0 * np.pi) * 2) + bytes(tail)


def write_load(mass: float, com: Array, inertia: Array) -> bytes:
    """Body of a request to set the load.

    Args:
        com: (3,), m, in the flange. inertia: (3, 3), about the centre of mass, along the axes of the flange.
    """
    return struct.pack("<13d", mass, *com.tolist(), *inertia.ravel(order="F").tolist())
