"""Messages of bags that `rosbags` reads: of ROS 2 in SQLite, of ROS 1; only of types that ROS itself defines."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from rosbags.rosbag1 import Reader as Ros1Reader
from rosbags.rosbag2 import Reader as Ros2Reader
from rosbags.typesys import Stores, get_typestore

from core.errors import BadRecording
from core.recording.bags.topic import MessageBatch, Topic

READ_TYPES = (
    "sensor_msgs/msg/JointState", "geometry_msgs/msg/WrenchStamped", "geometry_msgs/msg/Wrench", "geometry_msgs/msg/PoseStamped",
    "geometry_msgs/msg/TransformStamped", "tf2_msgs/msg/TFMessage", "std_msgs/msg/String",
)  # fmt: skip
GATHERED = 5000
"""Messages of a topic that make a batch."""


def read_with_rosbags(path: Path) -> Iterator[MessageBatch]:
    """The messages by topic, in their order.

    Raises:
        BadRecording: it is truncated, damaged or no bag.
    """
    where = str(path)
    try:
        store = get_typestore(Stores.ROS2_HUMBLE)
        if path.name.lower().endswith(".bag"):  # its headers count themselves, which those of ROS 2 do not, and the conversion leaves out
            with Ros1Reader(path) as bag:
                yield from _gather(bag, store.fielddefs, lambda content, kind: bytes(store.ros1_to_cdr(content, kind)))
        else:
            folder = path if path.is_dir() else path.parent
            with Ros2Reader(folder) as bag2:
                yield from _gather(bag2, store.fielddefs, lambda content, _: bytes(content))
    except BadRecording:
        raise
    except Exception as error:
        raise BadRecording(where, "bag-broken", reason=" ".join(str(error).split())[:160] or type(error).__name__) from error


def _gather(bag: Any, fields: Any, convert: Callable[[bytes, str], bytes]) -> Iterator[MessageBatch]:
    waiting: dict[Topic, list[tuple[int, bytes]]] = {}
    connections = [each for each in bag.connections if each.msgtype in READ_TYPES]
    topics = {each.id: Topic(each.topic, each.msgtype, fields) for each in connections}
    for connection, time, content in bag.messages(connections) if connections else ():
        topic = topics[connection.id]
        messages = waiting.setdefault(topic, [])
        messages.append((time, convert(content, connection.msgtype)))
        if len(messages) >= GATHERED:
            yield MessageBatch.of(topic, messages)
            messages.clear()
    for topic, messages in waiting.items():
        if messages:
            yield MessageBatch.of(topic, messages)
