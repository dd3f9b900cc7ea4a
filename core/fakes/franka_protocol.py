"""The controller's side of the Franka Control Interface: the states that it sends, and what it reads of requests and commands.

Written from the published headers, apart from the driver: a state is packed field by field, a request is read by the format of its body.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from core.array import Array

PORT = 1337
CONNECT, MOVE, STOP_MOVE, SET_COLLISION_BEHAVIOR, SET_LOAD, RECOVER, GET_ROBOT_MODEL, OTHER = range(8)
"""What is asked for; `ids_of` says by which number."""
SUCCESS = 0
STATE = (
    ("O_T_EE", 16), ("O_T_EE_d", 16), ("F_T_EE", 16), ("EE_T_K", 16), ("F_T_NE", 16), ("NE_T_EE", 16), ("m_ee", 1), ("I_ee", 9),
    ("F_x_Cee", 3), ("m_load", 1), ("I_load", 9), ("F_x_Cload", 3), ("elbow", 2), ("elbow_d", 2), ("tau_J", 7), ("tau_J_d", 7),
    ("dtau_J", 7), ("q", 7), ("q_d", 7), ("dq", 7), ("dq_d", 7), ("ddq_d", 7), ("joint_contact", 7), ("cartesian_contact", 6),
    ("joint_collision", 7), ("cartesian_collision", 6), ("tau_ext_hat_filtered", 7), ("O_F_ext_hat_K", 6), ("K_F_ext_hat_K", 6),
    ("O_dP_EE_d", 6), ("O_ddP_O", 3), ("elbow_c", 2), ("delbow_c", 2), ("ddelbow_c", 2), ("O_T_EE_c", 16), ("O_dP_EE_c", 6),
    ("O_ddP_EE_c", 6), ("theta", 7), ("dtheta", 7),
)  # fmt: skip
FLAGS = 41


@dataclass
class State:
    """Of the robot; fields that are not said are zero, frames that are not said are the same as the one before."""

    number: int
    said: dict[str, Array]
    motion: int = 0
    controller: int = 3
    errors: set[int] = field(default_factory=set)
    reasons: set[int] = field(default_factory=set)
    mode: int = 1
    success: float = 0.0

    def pack(self, version: int) -> bytes:
        """The datagram of a server of this version: single precision and accelerometers from 10 on."""
        code = "f" if version >= 10 else "d"
        nothing, same = np.zeros(16), np.eye(4).ravel()
        frames = ("EE_T_K", "NE_T_EE", "O_T_EE_d", "O_T_EE_c")
        out = struct.pack("<Q", self.number)
        for name, size in STATE:
            value = self.said.get(name, (same if name in frames else nothing)[:size])
            out += struct.pack(f"<{size}{code}", *value)
        if version >= 10:
            out += struct.pack("<36f", *[0.0] * 36)
        flags = (bytes(k in each for k in range(FLAGS)) for each in (self.errors, self.reasons))
        return out + bytes([self.motion, self.controller]) + b"".join(flags) + bytes([self.mode]) + struct.pack(f"<{code}", self.success)


class Request(NamedTuple):
    """What a client asks for over TCP.

    Args:
        id: as it counts them; the answer has the same. body: behind the header.
    """

    kind: int
    id: int
    raw_kind: int
    body: bytes


class Order(NamedTuple):
    """A command of motion: the state that it answers, joint positions, and whether the motion ends with it."""

    number: int
    q: Array
    finished: bool


def ids_of(version: int) -> dict[int, int]:
    """What each number of a request asks for, in this version."""
    order = [CONNECT, MOVE, STOP_MOVE]
    if version <= 5:
        order += [OTHER]  # a Cartesian limit
    order += [SET_COLLISION_BEHAVIOR, OTHER, OTHER, OTHER, OTHER, OTHER, SET_LOAD]
    if version <= 5:
        order += [OTHER]  # filters
    order += [RECOVER]
    if version <= 9:
        order += [OTHER]  # the model as a library
    if version >= 8:
        order += [GET_ROBOT_MODEL]
    return dict(enumerate(order))


def answers_to_move(version: int) -> dict[str, int]:
    """How the outcome of a move is numbered."""
    names = ["success", "started", "preempted"]
    if version >= 6:
        names += ["preempted_by_safety", "rejected_by_safety"]
    names += ["not_possible", "singular", "invalid_argument", "reflex", "emergency", "input_error", "aborted"]
    return {name: k for k, name in enumerate(names)}


def take_requests(data: bytes, version: int) -> tuple[list[Request], bytes]:
    """The whole requests in what has come, and what is left of it."""
    found, ids = [], ids_of(version)
    while len(data) >= 12:
        kind, number, size = struct.unpack("<III", data[:12])
        if size < 12 or len(data) < size:
            break
        found.append(Request(ids.get(kind, OTHER), number, kind, data[12:size]))
        data = data[size:]
    return found, data


def answer(request: Request, status: int, behind: bytes = b"") -> bytes:
    """What is sent back."""
    return struct.pack("<IIIB", request.raw_kind, request.id, 13 + len(behind), status) + behind


def read_move(body: bytes, version: int) -> tuple[int, int] | None:
    """Controller and motion generator of a move; None where it is none of this version, or one of the asynchronous generator."""
    if len(body) != (113 if version >= 10 else 56) or (version >= 10 and body[56]):
        return None
    controller, generator = struct.unpack_from("<II", body)
    return controller, generator


def read_load(body: bytes) -> tuple[float, Array, Array] | None:
    """Mass, centre of mass and inertia (nine by columns) of a request for a load."""
    if len(body) != 104:
        return None
    numbers = np.array(struct.unpack("<13d", body))
    return float(numbers[0]), numbers[1:4], numbers[4:]


def read_order(data: bytes, version: int) -> Order | None:
    """A datagram of a client; None where it is none of this version."""
    if len(data) != (371 if version >= 7 else 370):
        return None
    number, *q = struct.unpack_from("<Q7d", data)
    return Order(number, np.array(q), bool(data[8 + 38 * 8 + 1]))
