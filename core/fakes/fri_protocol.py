"""The controller's side of KUKA's Fast Robot Interface: what it sends in each cycle, and what it reads of an answer.

Written from the published field numbers, apart from the driver: every message is described by lines of `number name type`.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any, NamedTuple

from core.array import Array
from core.errors import MissingPackage

MESSAGES = """
JointValues: 1 value double[]
TimeStamp: 1 sec uint32, 2 nanosec uint32
Transformation: 1 name string, 2 element double[]
MessageHeader: 1 messageIdentifier uint32, 2 sequenceCounter uint32, 3 reflectedSequenceCounter uint32
ConnectionInfo: 1 sessionState int32, 2 quality int32, 3 sendPeriod uint32, 4 receiveMultiplier uint32
RobotInfo: 1 numberOfJoints int32, 2 safetyState int32, 5 driveState int32[], 6 operationMode int32, 7 controlMode int32
MonitorData: 1 measuredJointPosition JointValues, 2 measuredTorque JointValues, 3 commandedJointPosition JointValues, 4 commandedTorque JointValues, 5 externalTorque JointValues, 9 measuredCartesianPose Transformation, 15 timestamp TimeStamp
IpoData: 1 jointPosition JointValues, 10 clientCommandMode int32, 11 overlayType int32, 12 trackingPerformance double
MonitoringMessage: 1 header MessageHeader, 2 robotInfo RobotInfo, 3 monitorData MonitorData, 4 connectionInfo ConnectionInfo, 5 ipoData IpoData
CommandData: 1 jointPosition JointValues
CommandMessage: 1 header MessageHeader, 2 commandData CommandData
"""  # noqa: E501 - a table, one message a line
MONITORING_ID, COMMAND_ID = 2380098, 212993
"""0x245142 and 0x34001: what an LBR sends, and what it takes."""


class Answer(NamedTuple):
    """What a client says.

    Args:
        positions: rad, as many as it gave; None where it commands none.
    """

    sequence: int
    reflected: int
    positions: tuple[float, ...] | None


class FriMessages:
    """Makes and reads the messages.

    Raises:
        MissingPackage: `protobuf` is not installed.
    """

    def __init__(self) -> None:
        try:
            pb2, pools, factory = (
                import_module(f"google.protobuf.{name}") for name in ("descriptor_pb2", "descriptor_pool", "message_factory")
            )
            self._decode_error: type[Exception] = import_module("google.protobuf.message").DecodeError
        except ImportError as error:
            raise MissingPackage(
                "heft fake kuka", "session-no-package", module="google.protobuf", extra="fri", reason=str(error)[:120]
            ) from error
        file = pb2.FileDescriptorProto(name="stand_in.proto", package="stand_in")
        for line in MESSAGES.strip().splitlines():
            title, fields = line.split(":")
            message = file.message_type.add(name=title)
            for field in fields.split(","):
                number, name, kind = field.split()
                many, kind = kind.endswith("[]"), kind.removesuffix("[]")
                entry = message.field.add(name=name, number=int(number))
                entry.label = entry.LABEL_REPEATED if many else entry.LABEL_OPTIONAL
                if kind[0].isupper():
                    entry.type, entry.type_name = entry.TYPE_MESSAGE, f".stand_in.{kind}"
                else:
                    entry.type = getattr(entry, f"TYPE_{kind.upper()}")
        pool = pools.DescriptorPool()
        pool.Add(file)
        self._told = factory.GetMessageClass(pool.FindMessageTypeByName("stand_in.MonitoringMessage"))
        self._taken = factory.GetMessageClass(pool.FindMessageTypeByName("stand_in.CommandMessage"))

    def new(self) -> Any:
        """An empty message of the controller."""
        message = self._told()
        message.header.messageIdentifier = MONITORING_ID
        return message

    def take(self, data: bytes) -> Answer | None:
        """What a datagram of the client says; None where it is none of this interface."""
        message = self._taken()
        try:
            message.ParseFromString(data)
        except self._decode_error:
            return None
        header = message.header
        if header.messageIdentifier != COMMAND_ID:
            return None
        given = message.commandData.jointPosition.value if message.commandData.HasField("jointPosition") else None
        return Answer(header.sequenceCounter, header.reflectedSequenceCounter, None if given is None else tuple(given))


def fill(values: Any, numbers: Array) -> None:
    """Numbers into a field of joint values."""
    values.value.extend(numbers.tolist())
