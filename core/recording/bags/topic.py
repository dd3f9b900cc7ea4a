"""A topic of a bag: its messages, taken apart into tables."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.recording.bags.kernels import copy_bytes, find_alike
from core.recording.bags.layout import Fields, Layout, NoLayoutError, Number, find_layout
from core.recording.bags.spooled_table import SpooledTable

MOST_LAYOUTS = 64
"""Of one topic; beyond it is left out."""
STAMP = re.compile(r"(.*\.)?header\.stamp\.(sec|nanosec)")
INDEX = re.compile(r"(position|velocity|effort)\[(\d+)\]")
IN_TRANSFORM = re.compile(r"transforms\[(\d+)\]\.(?:transform\.)?(.+)")
JOINTS, TRANSFORMS = "sensor_msgs/msg/JointState", "tf2_msgs/msg/TFMessage"


@dataclass(frozen=True)
class Topic:
    """Args:
    kind: type of its messages.
    fields: of that type and of those in it.
    """

    name: str
    kind: str
    fields: Fields

    def __hash__(self) -> int:
        return hash((self.name, self.kind))


class MessageBatch(NamedTuple):
    """Messages (M,) of a topic: log times, s, and where in `data` each begins and how long it is."""

    topic: Topic
    times: Array
    data: NDArray[np.uint8]
    begins: NDArray[np.int64]
    sizes: NDArray[np.int64]

    @classmethod
    def of(cls, topic: Topic, messages: Sequence[tuple[int, bytes]]) -> MessageBatch:
        """Of messages with their log times in ns."""
        sizes = np.array([len(content) for _, content in messages], dtype=np.int64)
        data = np.frombuffer(b"".join(content for _, content in messages), dtype=np.uint8)
        times: Array = 1e-9 * np.array([time for time, _ in messages], dtype=np.float64)
        return cls(topic, times, data, np.cumsum(sizes) - sizes, sizes)


class ColumnShare(NamedTuple):
    """What a message gives to one table: its name, its columns, the frame of them, and which of the message's numbers they are."""

    table: str
    columns: list[str]
    frame: str | None
    numbers: list[int]
    stamp: tuple[int, int] | None


class TopicReader:
    """Turns batches into rows.

    Args:
        make: a new table of that name with these columns in that frame.
    """

    def __init__(self, topic: Topic, make: Callable[[str, list[str], str | None], SpooledTable]) -> None:
        self.topic, self.make = topic, make
        self.layouts: list[tuple[Layout, list[ColumnShare]]] = []
        self.tables: dict[tuple[str, ...], SpooledTable] = {}
        self.texts: dict[str, str] = {}
        self.given_up = False

    def add(self, batch: MessageBatch) -> None:
        """The rows of further messages."""
        rows: dict[tuple[str, ...], list[tuple[NDArray[np.intp], Array]]] = {}
        left = np.arange(len(batch.begins))
        known = iter(list(self.layouts))
        while len(left) and not self.given_up:
            layout, shares = next(known, None) or self._learn(batch, int(left[0]))
            alike = find_alike(batch.data, batch.begins[left], batch.sizes[left], layout.content, layout.fixed)
            for share in shares if alike.any() else ():
                values = _take_rows(batch, left[alike], layout, share)
                rows.setdefault((share.table, share.frame or "", *share.columns), []).append((left[alike], values))
            left = left[~alike]
        for key, pieces in rows.items():
            order = np.argsort(np.concatenate([which for which, _ in pieces]), kind="stable")
            self._table(key).append(np.concatenate([values for _, values in pieces])[order])

    def _learn(self, batch: MessageBatch, k: int) -> tuple[Layout, list[ColumnShare]]:
        content = batch.data[batch.begins[k] : batch.begins[k] + batch.sizes[k]].tobytes()
        try:
            if len(self.layouts) >= MOST_LAYOUTS:
                raise NoLayoutError("messages that are laid out in too many ways")
            layout = find_layout(content, self.topic.kind, self.topic.fields)
        except NoLayoutError:
            self.given_up = True
            nothing = np.zeros(0, dtype=np.uint8)
            return Layout(nothing, nothing.astype(bool)), []
        self.texts |= layout.texts
        self.layouts.append((layout, _share_out(self.topic, layout)))
        return self.layouts[-1]

    def _table(self, key: tuple[str, ...]) -> SpooledTable:
        if key not in self.tables:
            self.tables[key] = self.make(key[0], list(key[2:]), key[1] or None)
        return self.tables[key]


def _share_out(topic: Topic, layout: Layout) -> list[ColumnShare]:
    if topic.kind == TRANSFORMS:
        return _share_transforms(topic.name, layout)
    names = {k: name for k in range(len(layout.numbers)) if (name := layout.texts.get(f"name[{k}]")) is not None}
    paths = [number.path for number in layout.numbers]
    if topic.kind == JOINTS:
        paths = [INDEX.sub(lambda match: f"{match[1]}.{names.get(int(match[2]), match[2])}", path) for path in paths]
    kept = [k for k, path in enumerate(paths) if not STAMP.fullmatch(path)]
    columns = ["t", *(paths[k] for k in kept)]
    if len(set(columns)) < len(columns) or not kept:
        return []
    return [ColumnShare(topic.name, columns, layout.texts.get("header.frame_id"), kept, _find_stamp(layout.numbers, "header"))]


def _share_transforms(name: str, layout: Layout) -> list[ColumnShare]:
    """A table for each pair of frames: translation and rotation of the child in its parent."""
    of_each: dict[int, list[tuple[int, str]]] = {}
    for k, number in enumerate(layout.numbers):
        match = IN_TRANSFORM.fullmatch(number.path)
        if match and not STAMP.fullmatch(number.path):
            of_each.setdefault(int(match[1]), []).append((k, match[2]))
    shares = []
    for each, numbers in of_each.items():
        parent, child = (layout.texts[f"transforms[{each}].{key}"].lstrip("/") for key in ("header.frame_id", "child_frame_id"))
        columns = ["t", *(path for _, path in numbers)]
        stamp = _find_stamp(layout.numbers, f"transforms[{each}].header")
        shares.append(ColumnShare(f"{name} {parent}>{child}", columns, parent, [k for k, _ in numbers], stamp))
    return shares


def _find_stamp(numbers: list[Number], header: str) -> tuple[int, int] | None:
    at = {number.path: k for k, number in enumerate(numbers)}
    paths = f"{header}.stamp.sec", f"{header}.stamp.nanosec"
    return (at[paths[0]], at[paths[1]]) if all(path in at for path in paths) else None


def _take_rows(batch: MessageBatch, which: NDArray[np.intp], layout: Layout, share: ColumnShare) -> Array:
    """(M, columns): the stamp, or the log time where there is none, and the numbers."""
    begins = batch.begins[which]
    out = np.empty((len(which), len(share.columns)))
    out[:, 0] = batch.times[which]
    if share.stamp is not None:
        seconds, fraction = (_copy_run(batch.data, begins, layout.numbers[k : k + 1])[:, 0] for k in share.stamp)
        stamped = (seconds != 0.0) | (fraction != 0.0)
        out[stamped, 0] = seconds[stamped] + 1e-9 * fraction[stamped]
    column = 1
    for run in _find_runs([layout.numbers[k] for k in share.numbers]):
        out[:, column : column + len(run)] = _copy_run(batch.data, begins, run)
        column += len(run)
    return out


def _copy_run(data: NDArray[np.uint8], begins: NDArray[np.int64], run: list[Number]) -> Array:
    kind = run[0].kind
    return np.asarray(copy_bytes(data, begins, run[0].offset, len(run) * int(kind[2])).view(kind), dtype=float)


def _find_runs(numbers: list[Number]) -> list[list[Number]]:
    """Numbers of one kind that follow each other."""
    runs: list[list[Number]] = []
    for number in numbers:
        if runs and runs[-1][-1].kind == number.kind and runs[-1][-1].offset + int(number.kind[2]) == number.offset:
            runs[-1].append(number)
        else:
            runs.append([number])
    return runs
