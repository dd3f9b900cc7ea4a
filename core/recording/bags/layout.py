"""Where in a message the numbers stand: messages of one topic are nearly all laid out alike, so one is taken apart and the others copied.

CDR, little endian, as DDS and ROS 2 write it (OMG DDS-XTypes 1.3, 7.4.1, encoding version 1): a header of four bytes, every number
aligned to its own size from there on, a sequence begins with its length, a text with its length and ends with a zero.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

HEADER = b"\x00\x01"
MOST_NUMBERS = 2000
"""In a message; pictures and point clouds have more."""
DEEPEST = 12
NUMBERS = {
    "bool": "<u1", "byte": "<u1", "octet": "<u1", "char": "<u1", "int8": "<i1", "uint8": "<u1", "int16": "<i2", "uint16": "<u2",
    "int32": "<i4", "uint32": "<u4", "int64": "<i8", "uint64": "<u8", "float32": "<f4", "float64": "<f8",
}  # fmt: skip

Fields = Mapping[str, tuple[Any, list[tuple[str, Any]]]]
"""Of each message type: constants, and fields with their types as `rosbags.typesys` parses them."""


class NoLayoutError(Exception):
    """The message is not what its definition says, or not of numbers."""


class Number(NamedTuple):
    """A number in a message: its path such as `wrench.force.x`, where it begins, and of which kind it is."""

    path: str
    offset: int
    kind: str


@dataclass
class Layout:
    """A message taken apart.

    Args:
        numbers: in the order in which they stand.
        texts: by path.
        fixed: (L,), which of the message's bytes are no numbers; another message is laid out alike if it has the same ones there.
        content: (L,), of this message.
    """

    content: NDArray[np.uint8]
    fixed: NDArray[np.bool_]
    numbers: list[Number] = field(default_factory=list)
    texts: dict[str, str] = field(default_factory=dict)


def find_layout(content: bytes, kind: str, fields: Fields) -> Layout:
    """Takes a message apart.

    Args:
        kind: its type, such as `sensor_msgs/msg/JointState`.

    Raises:
        NoLayoutError: it is too short, in another encoding, has more than `MOST_NUMBERS` numbers, or types that are not known.
    """
    if content[:2] != HEADER:
        raise NoLayoutError(f"encoding {content[:2].hex()}")
    bytes_of = np.frombuffer(content, dtype=np.uint8)
    layout = Layout(bytes_of, np.ones(len(content), dtype=bool))
    _Walk(content, fields, layout).visit_message(kind, "", 0)
    for each in layout.numbers:
        layout.fixed[each.offset : each.offset + int(each.kind[2])] = False
    return layout


class _Walk:
    """One way through a message, from its first field to its last."""

    def __init__(self, content: bytes, fields: Fields, layout: Layout) -> None:
        self.content, self.fields, self.layout = content, fields, layout
        self.at = 4

    def visit_message(self, kind: str, path: str, depth: int) -> None:
        if depth > DEEPEST or kind not in self.fields:
            raise NoLayoutError(f"type {kind[:80]}")
        for name, node in self.fields[kind][1]:
            self.visit(node, f"{path}.{name}" if path else name, depth + 1)

    def visit(self, node: Any, path: str, depth: int) -> None:
        tag, detail = int(node[0]), node[1]
        if tag == 1:
            self.visit_base(detail[0], path)
        elif tag == 2:
            self.visit_message(detail, path, depth)
        else:
            count = detail[1] if tag == 3 else self.take_length()
            if count > MOST_NUMBERS:
                raise NoLayoutError(f"{count} values")
            for k in range(count):
                self.visit(detail[0], f"{path}[{k}]", depth + 1)

    def visit_base(self, name: str, path: str) -> None:
        if name == "string":
            self.layout.texts[path] = self.take_text()
            return
        if name not in NUMBERS or len(self.layout.numbers) >= MOST_NUMBERS:
            raise NoLayoutError(f"type {name[:80]}")
        size = int(NUMBERS[name][2])
        self.layout.numbers.append(Number(path, self.take(size, size), NUMBERS[name]))

    def take(self, size: int, alignment: int) -> int:
        """Where so many bytes begin, at the next place that is aligned."""
        begin = self.at + -(self.at - 4) % alignment
        self.at = begin + size
        if self.at > len(self.content):
            raise NoLayoutError(f"{len(self.content)} bytes")
        return begin

    def take_length(self) -> int:
        return int(struct.unpack_from("<I", self.content, self.take(4, 4))[0])

    def take_text(self) -> str:
        size = self.take_length()
        begin = self.take(size, 1)
        return self.content[begin : begin + size].rstrip(b"\x00").decode(errors="replace")
