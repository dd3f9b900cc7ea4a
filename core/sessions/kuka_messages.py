"""The messages of KUKA's Fast Robot Interface: what a controller tells in each cycle, and the command that answers it.

Protocol buffers (proto2); field numbers and enumerations as in the client library that KUKA publishes, of the versions 1.11 to 2.7. Only
what is read or written here is described; the rest of a message is skipped, so that one table holds for all of them.
"""

from __future__ import annotations

from enum import IntEnum
from typing import Any, NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.sessions.vendor import import_vendor

MONITORING, COMMAND = 0x245142, 0x34001
"""Identifiers of the two messages of an LBR."""
JOINTS = "Joints"
FIELDS: dict[str, dict[str, tuple[int, str]]] = {
    JOINTS: {"value": (1, "double*")},
    "Stamp": {"sec": (1, "uint32"), "nanosec": (2, "uint32")},
    "Pose": {"element": (2, "double*")},
    "Header": {"identifier": (1, "uint32"), "sequence": (2, "uint32"), "reflected": (3, "uint32")},
    "Connection": {"state": (1, "int32"), "quality": (2, "int32"), "send_period": (3, "uint32"), "multiplier": (4, "uint32")},
    "Robot": {"joints": (1, "int32"), "safety": (2, "int32"), "drives": (5, "int32*"), "operation": (6, "int32"), "control": (7, "int32")},
    "Measured": {
        "q": (1, JOINTS), "torque": (2, JOINTS), "commanded": (3, JOINTS), "external": (5, JOINTS), "pose": (9, "Pose"),
        "stamp": (15, "Stamp"),
    },
    "Interpolated": {"q": (1, JOINTS), "command_mode": (10, "int32"), "overlay": (11, "int32"), "tracking": (12, "double")},
    "Monitoring": {
        "header": (1, "Header"), "robot": (2, "Robot"), "measured": (3, "Measured"), "connection": (4, "Connection"),
        "ipo": (5, "Interpolated"),
    },
    "Commanded": {"q": (1, JOINTS)},
    "Command": {"header": (1, "Header"), "commanded": (2, "Commanded")},
}  # fmt: skip
"""Number and type of every field; several values where the type has a star."""
METRE = 1e-3
"""Of a millimetre, in which poses are told."""


class State(IntEnum):
    """Of a session."""

    IDLE = 0
    MONITORING_WAIT = 1
    MONITORING_READY = 2
    COMMANDING_WAIT = 3
    COMMANDING_ACTIVE = 4


class Quality(IntEnum):
    """Of the connection, as the controller judges it; from GOOD on it lets a client command."""

    POOR = 0
    FAIR = 1
    GOOD = 2
    EXCELLENT = 3


class Safety(IntEnum):
    """Which stop the safety controller asks for."""

    NORMAL = 0
    STOP_0 = 1
    STOP_1 = 2
    STOP_2 = 3


class Operation(IntEnum):
    """Mode of operation; in T1 and T2 somebody holds the enabling switch."""

    T1 = 0
    T2 = 1
    AUTOMATIC = 2


ACTIVE_DRIVE, POSITION_CONTROL, JOINT_POSITION, JOINT_OVERLAY = 2, 0, 1, 1
"""What drives, controller, command mode and overlay have to be for positions to be followed."""


class FriError(ConnectionError):
    """What came is no message of the interface."""


class Sample(NamedTuple):
    """What a controller tells in one cycle; joints (n,), rad and N m.

    Args:
        sequence, reflected: its own count, and the count of the newest command that it has.
        stamp: s and ns, of the controller's clock.
        joints: how many it says it has.
        commanded: the last command; None where it does not say (FRI 2).
        ipo: where its own motion is; None outside of command mode.
        external: torques that it does not explain by what it knows of the arm and its load.
        tracking: 1 where the arm follows at once, towards 0 where it lags.
        pose: of the tool centre point, position (3,), m, and rotation (3, 3); None where it does not say (FRI 1).
    """

    sequence: int
    reflected: int
    stamp: tuple[int, int]
    state: int
    quality: int
    period_ms: int
    multiplier: int
    joints: int
    safety: int
    operation: int
    control: int
    drives: tuple[int, ...]
    q: Array
    torque: Array
    external: Array
    commanded: Array | None
    ipo: Array | None
    command_mode: int
    overlay: int
    tracking: float
    pose: tuple[Array, Array] | None


class Codec:
    """Reads and writes the messages with the package `protobuf`.

    Args:
        where: the key that asks for it.

    Raises:
        MissingPackage: it is not installed.
    """

    def __init__(self, where: str) -> None:
        descriptor, pool, factory, message = (
            import_vendor(f"google.protobuf.{name}", extra="fri", where=where)
            for name in ("descriptor_pb2", "descriptor_pool", "message_factory", "message")
        )
        described = descriptor.FileDescriptorProto(name="fri.proto", package="fri", syntax="proto2")
        for name, fields in FIELDS.items():
            entry = described.message_type.add(name=name)
            for field, (number, kind) in fields.items():
                plain = kind.rstrip("*")
                added = entry.field.add(name=field, number=number, label=3 if kind.endswith("*") else 1)
                if plain in FIELDS:
                    added.type, added.type_name = descriptor.FieldDescriptorProto.TYPE_MESSAGE, f".fri.{plain}"
                else:
                    added.type = descriptor.FieldDescriptorProto.Type.Value(f"TYPE_{plain.upper()}")
        known = pool.DescriptorPool()
        known.Add(described)
        self._monitoring, self._command = (
            factory.GetMessageClass(known.FindMessageTypeByName(f"fri.{name}")) for name in ("Monitoring", "Command")
        )
        self._undecodable: type[Exception] = message.DecodeError

    def read(self, data: bytes) -> Sample:
        """A controller's message.

        Raises:
            FriError: it is none, or lacks what every one has.
        """
        told = self._monitoring()
        try:
            told.ParseFromString(data)
        except self._undecodable as error:
            raise FriError(f"{len(data)} B that are no message of FRI") from error
        header, robot, measured, connection, ipo = told.header, told.robot, told.measured, told.connection, told.ipo
        if header.identifier != MONITORING:
            raise FriError(f"a message with the identifier {header.identifier:#x}, expected {MONITORING:#x}")
        q, torque, external = (_joints(each) for each in (measured.q, measured.torque, measured.external))
        if not q.size or not measured.HasField("stamp") or not q.size == torque.size == external.size:
            raise FriError(f"a message with {q.size} positions, {torque.size} torques and {external.size} external torques")
        return Sample(
            header.sequence, header.reflected, (measured.stamp.sec, measured.stamp.nanosec),
            connection.state, connection.quality, connection.send_period, connection.multiplier,
            robot.joints, robot.safety, robot.operation, robot.control, tuple(robot.drives),
            q, torque, external,
            _joints(measured.commanded) if measured.HasField("commanded") else None,
            _joints(ipo.q) if ipo.HasField("q") else None,
            ipo.command_mode, ipo.overlay, ipo.tracking,
            _read_pose(measured.pose.element) if measured.HasField("pose") else None,
        )  # fmt: skip

    def write(self, sequence: int, reflected: int, q: Array | None) -> bytes:
        """The command that answers a message.

        Args:
            sequence: counts commands; `reflected` is that of the message that is answered.
            q: (n,), rad; no command where None, which only says that the client is there.
        """
        command = self._command()
        command.header.identifier, command.header.sequence, command.header.reflected = COMMAND, sequence, reflected
        if q is not None:
            command.commanded.q.value.extend(q.tolist())
        return bytes(command.SerializeToString())


def _joints(told: Any) -> Array:
    return np.array(told.value, dtype=float)


def _read_pose(element: Any) -> tuple[Array, Array]:
    """x y z (mm) and a unit quaternion, w first."""
    numbers = np.array(element, dtype=float)
    if numbers.size != 7 or not np.linalg.norm(numbers[3:]) > 0.5:
        raise FriError(f"a pose of {numbers.size} numbers that is none")
    return METRE * numbers[:3], Rotation.from_quat(numbers[3:], scalar_first=True).as_matrix()
