"""A bag as tables: one for each topic, for each pair of frames of a tree of transforms, and for each set of joints."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from core.errors import BadRecording
from core.recording.bags.mcap_file import McapFile
from core.recording.bags.rosbag_folder import read_with_rosbags
from core.recording.bags.spooled_table import SpooledTable
from core.recording.bags.topic import MessageBatch, Topic, TopicReader

BAGS = (".mcap", ".bag", ".db3")
MOST_TABLES = 400
MOST_URDF_BYTES = 20_000_000
DESCRIPTION = "std_msgs/msg/String"


@dataclass(frozen=True)
class Bag:
    """Args:
    tables: by topic; a second set of joints or a second frame in one topic is called `topic#2`.
    urdf: the robot's description, where the bag has one (`/robot_description`).
    """

    tables: dict[str, SpooledTable]
    urdf: str | None


def is_bag(path: Path) -> bool:
    """Whether it is a file of a bag, or the folder of one."""
    return (path / "metadata.yaml").is_file() if path.is_dir() else path.name.lower().endswith(BAGS)


def read_bag(path: Path) -> Bag:
    """The topics whose messages consist of numbers.

    Args:
        path: an MCAP file, a bag of ROS 1, or the folder of a bag of ROS 2.

    Raises:
        BadRecording: it is truncated, damaged or no bag.
    """
    made: list[tuple[str, SpooledTable]] = []

    def make(name: str, columns: list[str], frame: str | None) -> SpooledTable:
        if len(made) >= MOST_TABLES:
            raise BadRecording(str(path), "bag-too-many-topics", most=MOST_TABLES)
        made.append((name, SpooledTable(f"{path}: {name}", columns, frame)))
        return made[-1][1]

    readers: dict[Topic, TopicReader] = {}
    for batch in _read_batches(path):
        reader = readers.setdefault(batch.topic, TopicReader(batch.topic, make))
        if not reader.given_up:
            reader.add(batch)
    return Bag(_name_tables(made), _find_urdf(readers.values()))


def _read_batches(path: Path) -> Iterator[MessageBatch]:
    if path.suffix.lower() == ".mcap":
        yield from McapFile(path).batches()
        return
    parts = sorted(path.glob("*.mcap"), key=_natural) if path.is_dir() else []
    if not parts:
        yield from read_with_rosbags(path)
    for part in parts:
        yield from McapFile(part).batches()


def _natural(file: Path) -> list[tuple[int, str]]:
    """So that part 10 comes after part 9."""
    return [(int(digits or 0), other) for digits, other in re.findall(r"(\d+)|(\D+)", file.name)]


def _name_tables(made: Iterable[tuple[str, SpooledTable]]) -> dict[str, SpooledTable]:
    tables: dict[str, SpooledTable] = {}
    for name, table in sorted(made, key=lambda each: -len(each[1])):
        others = sum(1 for each in tables if each == name or each.startswith(f"{name}#"))
        tables[f"{name}#{others + 1}" if others else name] = table
    return tables


def _find_urdf(readers: Iterable[TopicReader]) -> str | None:
    for reader in readers:
        text = reader.texts.get("data", "") if reader.topic.kind == DESCRIPTION else ""
        if "<robot" in text and len(text) <= MOST_URDF_BYTES:
            return text
    return None
