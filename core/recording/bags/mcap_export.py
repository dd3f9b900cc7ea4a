"""A recording as an MCAP file with the messages of ROS 2, which PlotJuggler, Foxglove and `ros2 bag` read."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from mcap.writer import CompressionType, Writer
from scipy.spatial.transform import Rotation

from core.array import Array
from core.recording.bags.ros_messages import DEFINITIONS, encode_joints, encode_text, encode_transform, encode_wrench
from core.recording.recording import Recording

WRENCH, JOINTS, COMMANDS, POSES, ROBOT = "/wrench", "/joint_states", "/joint_commands", "/tf", "/robot_description"
TYPES = {
    WRENCH: "geometry_msgs/msg/WrenchStamped", JOINTS: "sensor_msgs/msg/JointState", COMMANDS: "sensor_msgs/msg/JointState",
    POSES: "tf2_msgs/msg/TFMessage", ROBOT: "std_msgs/msg/String",
}  # fmt: skip
BASE, SENSOR = "base", "sensor"
"""Frames of a recording without a robot."""


def write_mcap(recording: Recording, file: Path, orientation: Array | None, position: Array | None) -> None:
    """Writes it; times are those of the recording, from 0 on, as stamps and as log times.

    Args:
        orientation, position: of the sensor in the base (N, 3, 3) and (N, 3), m; a position that is not known is written as zero.
    """
    with file.open("wb") as stream:
        writer = Writer(stream, compression=CompressionType.ZSTD)
        writer.start(profile="ros2", library="heft")
        channels: dict[str, int] = {}
        for ns, topic, content in _messages(recording, orientation, position):
            if topic not in channels:
                schema = writer.register_schema(TYPES[topic], "ros2msg", DEFINITIONS[TYPES[topic]].encode())
                channels[topic] = writer.register_channel(topic, "cdr", schema)
            writer.add_message(channels[topic], ns, content, ns)
        writer.finish()  # type: ignore[no-untyped-call]  # it has no return type


def _messages(recording: Recording, orientation: Array | None, position: Array | None) -> Iterator[tuple[int, str, bytes]]:
    """All in the order of time: time in ns, topic, content."""
    robot, q_cmd = recording.robot, recording.q_cmd
    base, sensor = (robot.base_frame, robot.sensor_frame) if robot else (BASE, SENSOR)
    times = np.round(1e9 * recording.t).astype(np.int64).tolist()
    quaternions = None if orientation is None else Rotation.from_matrix(orientation).as_quat()
    where = np.zeros((len(times), 3)) if position is None else position
    if robot:
        yield times[0], ROBOT, encode_text(robot.urdf)
    for k, ns in enumerate(times):
        if recording.wrench is not None:
            yield ns, WRENCH, encode_wrench(ns, sensor, recording.wrench[k])
        if robot and recording.q is not None:
            yield ns, JOINTS, encode_joints(ns, robot.joints, recording.q[k], _row(recording.dq, k), _row(recording.tau, k))
        if robot and q_cmd is not None:
            yield ns, COMMANDS, encode_joints(ns, robot.joints, q_cmd[k], None, None)
        if quaternions is not None:
            yield ns, POSES, encode_transform(ns, base, sensor, where[k], quaternions[k])


def _row(values: Array | None, k: int) -> Array | None:
    return None if values is None else values[k]
