"""The messages of ROS 2 in which a recording is written: their definitions, and their bytes in CDR.

Definitions as `ros2 interface show` gives them, without comments (common_interfaces, geometry2).
"""

from __future__ import annotations

import struct
from collections.abc import Sequence

import numpy as np

from core.array import Array

_LINE = "=" * 80
_HEADER = f"""{_LINE}
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
{_LINE}
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
"""
_VECTOR = f"""{_LINE}
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z
"""
DEFINITIONS = {
    "sensor_msgs/msg/JointState": f"""std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort
{_HEADER}""",
    "geometry_msgs/msg/WrenchStamped": f"""std_msgs/Header header
geometry_msgs/Wrench wrench
{_LINE}
MSG: geometry_msgs/Wrench
geometry_msgs/Vector3 force
geometry_msgs/Vector3 torque
{_VECTOR}{_HEADER}""",
    "tf2_msgs/msg/TFMessage": f"""geometry_msgs/TransformStamped[] transforms
{_LINE}
MSG: geometry_msgs/TransformStamped
std_msgs/Header header
string child_frame_id
geometry_msgs/Transform transform
{_LINE}
MSG: geometry_msgs/Transform
geometry_msgs/Vector3 translation
geometry_msgs/Quaternion rotation
{_LINE}
MSG: geometry_msgs/Quaternion
float64 x
float64 y
float64 z
float64 w
{_VECTOR}{_HEADER}""",
    "std_msgs/msg/String": "string data\n",
}


class _Bytes:
    """CDR, little endian: a header of four bytes, then every number aligned to its own size."""

    def __init__(self) -> None:
        self.content = bytearray(b"\x00\x01\x00\x00")

    def put(self, kind: str, *values: float) -> None:
        size = struct.calcsize(kind)
        for value in values:
            self.content += bytes(-(len(self.content) - 4) % size)
            self.content += struct.pack(f"<{kind}", value)

    def put_text(self, text: str) -> None:
        encoded = text.encode() + b"\x00"
        self.put("I", len(encoded))
        self.content += encoded

    def put_header(self, ns: int, frame: str) -> None:
        self.put("i", ns // 10**9)
        self.put("I", ns % 10**9)
        self.put_text(frame)

    def put_list(self, values: Array | None) -> None:
        self.put("I", 0 if values is None else len(values))
        self.put("d", *(() if values is None else values.tolist()))


def encode_wrench(ns: int, frame: str, wrench: Array) -> bytes:
    """`WrenchStamped` of a wrench (6,), N and N m, at a time in ns."""
    out = _Bytes()
    out.put_header(ns, frame)
    out.put("d", *wrench.tolist())
    return bytes(out.content)


def encode_joints(ns: int, names: Sequence[str], q: Array, dq: Array | None, tau: Array | None) -> bytes:
    """`JointState` of positions (n,), rad, velocities, rad/s, and torques, N m."""
    out = _Bytes()
    out.put_header(ns, "")
    out.put("I", len(names))
    for name in names:
        out.put_text(name)
    for values in (q, dq, tau):
        out.put_list(values)
    return bytes(out.content)


def encode_transform(ns: int, parent: str, child: str, position: Array, quaternion: Array) -> bytes:
    """`TFMessage` of one transform: position (3,), m, and quaternion (4,), x y z w, of the child in its parent."""
    out = _Bytes()
    out.put("I", 1)
    out.put_header(ns, parent)
    out.put_text(child)
    out.put("d", *np.concatenate([position, quaternion]).tolist())
    return bytes(out.content)


def encode_text(text: str) -> bytes:
    """`String`."""
    out = _Bytes()
    out.put_text(text)
    return bytes(out.content)
