"""The pose of one frame in the root of the tree, from the transforms that a bag has between neighbours."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.spatial.transform import Rotation, Slerp

from core.array import Array, interpolate
from core.recording.bags.spooled_table import SpooledTable

TRANSLATION = ("translation.x", "translation.y", "translation.z")
ROTATION = ("rotation.x", "rotation.y", "rotation.z", "rotation.w")
COLUMNS = ("t", "position.x", "position.y", "position.z", "orientation.x", "orientation.y", "orientation.z", "orientation.w")


def compose_transforms(tables: Mapping[str, SpooledTable], frame: str, where: str) -> SpooledTable | None:
    """A table of `COLUMNS`, at the times of the neighbours that are seen most often; None where nothing moves or no chain is there.

    Args:
        tables: those of a bag; transforms are called `<topic> <parent>><child>`.
        frame: whose pose it is.
        where: what messages call the table.
    """
    chain = _find_chain(tables, frame)
    moving = [table for table in chain if len(table) > 2]
    if not moving:
        return None
    curves = [_Curve(table) for table in chain]
    t = max((curve.t for curve in curves if len(curve.t) > 2), key=len)
    ends = [curve.t[[0, -1]] for curve in curves if len(curve.t) > 2]
    t = t[(t >= max(first for first, _ in ends)) & (t <= min(last for _, last in ends))]
    if len(t) < 2:
        return None
    position, rotation = np.zeros((len(t), 3)), Rotation.identity(len(t))
    for curve in reversed(curves):  # from the root to the frame
        step, turn = curve.at(t)
        position = position + rotation.apply(step)
        rotation = rotation * turn
    made = SpooledTable(where, COLUMNS, frame)
    made.append(np.column_stack([t, position, rotation.as_quat()]))
    return made


def find_root(tables: Mapping[str, SpooledTable], frame: str) -> str | None:
    """The frame at the top of the tree that `frame` is in."""
    chain = _find_chain(tables, frame)
    return chain[-1].frame if chain else None


def _find_chain(tables: Mapping[str, SpooledTable], frame: str) -> list[SpooledTable]:
    """Transforms from the frame up to the root."""
    above: dict[str, SpooledTable] = {}
    for name, table in tables.items():
        if ">" in name and set(TRANSLATION) <= set(table.columns):
            child = name.split("#")[0].rpartition(">")[2]
            above[child] = max(above.get(child, table), table, key=len)
    chain: list[SpooledTable] = []
    here = frame.lstrip("/")
    while here in above and len(chain) <= len(above):
        chain.append(above[here])
        here = chain[-1].frame or ""
    return chain


class _Curve:
    """One transform over time; one that was said once holds for ever."""

    def __init__(self, table: SpooledTable) -> None:
        values = table.numbers("t", *TRANSLATION, *ROTATION)
        self.t, first = np.unique(values[:, 0], return_index=True)
        self.translation, quaternion = values[first, 1:4], values[first, 4:]
        lengths = np.linalg.norm(quaternion, axis=1)
        self.rotation = Rotation.from_quat(np.where(lengths[:, None] > 0.5, quaternion, [0.0, 0.0, 0.0, 1.0]))

    def at(self, t: Array) -> tuple[Array, Rotation]:
        if len(self.t) <= 2:
            return np.tile(self.translation[-1], (len(t), 1)), Rotation.from_quat(np.tile(self.rotation[-1].as_quat(), (len(t), 1)))
        moved = interpolate(t, self.t, self.translation)
        return moved, Slerp(self.t, self.rotation)(t)
