"""Bags written by `rosbags`, which shares no code with what reads them here (of MCAP and CDR)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from rosbags.rosbag1 import Writer as Ros1Writer
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as Ros2Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from core.array import Array

BEGIN_NS = 1_700_000_000_000_000_000
ROS2 = get_typestore(Stores.ROS2_HUMBLE)
ROS1 = get_typestore(Stores.ROS1_NOETIC)
ROS1.register(get_types_from_msg("geometry_msgs/TransformStamped[] transforms", "tf2_msgs/msg/TFMessage"))


class Messages:
    """Makes messages of either ROS; t in s after `BEGIN_NS`."""

    def __init__(self, store: Any = ROS2) -> None:
        self.store, self.types = store, store.types

    def header(self, t: float, frame: str) -> Any:
        ns = BEGIN_NS + round(1e9 * t)
        stamp = self.types["builtin_interfaces/msg/Time"](ns // 10**9, ns % 10**9)
        kind = self.types["std_msgs/msg/Header"]
        return kind(0, stamp, frame) if self.store is ROS1 else kind(stamp, frame)

    def wrench(self, t: float, values: Array, frame: str) -> Any:
        vector = self.types["geometry_msgs/msg/Vector3"]
        both = self.types["geometry_msgs/msg/Wrench"](vector(*map(float, values[:3])), vector(*map(float, values[3:])))
        return self.types["geometry_msgs/msg/WrenchStamped"](self.header(t, frame), both)

    def joints(self, t: float, names: list[str], q: Array, dq: Array | None = None, tau: Array | None = None) -> Any:
        empty = np.zeros(0)
        rest = [empty if x is None else np.asarray(x, dtype=float) for x in (dq, tau)]
        return self.types["sensor_msgs/msg/JointState"](self.header(t, ""), names, np.asarray(q, dtype=float), *rest)

    def transforms(self, t: float, of: Mapping[tuple[str, str], tuple[Array, Array]]) -> Any:
        vector, turn = self.types["geometry_msgs/msg/Vector3"], self.types["geometry_msgs/msg/Quaternion"]
        inner, outer = self.types["geometry_msgs/msg/Transform"], self.types["geometry_msgs/msg/TransformStamped"]
        each = [
            outer(self.header(t, parent), child, inner(vector(*map(float, p)), turn(*map(float, q))))
            for (parent, child), (p, q) in of.items()
        ]
        return self.types["tf2_msgs/msg/TFMessage"](each)


def write_bag(path: Path, topics: Mapping[str, Iterable[tuple[float, Any]]], *, storage: str = "mcap") -> Path:
    """A bag of these topics: times in s with messages. Returns what is to be read."""
    if storage == "ros1":
        with Ros1Writer(path) as bag:
            for name, messages in topics.items():
                connection = None
                for t, message in messages:
                    connection = connection or bag.add_connection(name, message.__msgtype__, typestore=ROS1)
                    bag.write(connection, BEGIN_NS + round(1e9 * t), ROS1.serialize_ros1(message, message.__msgtype__))
        return path
    plugin = StoragePlugin.MCAP if storage == "mcap" else StoragePlugin.SQLITE3
    with Ros2Writer(path, version=9, storage_plugin=plugin) as bag:
        for name, messages in topics.items():
            connection = None
            for t, message in messages:
                connection = connection or bag.add_connection(name, message.__msgtype__, typestore=ROS2)
                bag.write(connection, BEGIN_NS + round(1e9 * t), ROS2.serialize_cdr(message, message.__msgtype__))
    return path
