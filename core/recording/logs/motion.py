"""Attitudes, positions and joints of a log at other times than its own."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, Slerp

from core.array import Array
from core.errors import BadRecording
from core.recording.logs.mapping import ANGLE_UNITS, LENGTH_UNITS, JointsPart, PosePart
from core.recording.logs.tables import LogTable
from core.recording.samples import name_column
from core.words.message import Message

ROUNDING = 0.02
"""By which a quaternion's length or a matrix's columns may be off, logged with three digits."""


class LoggedPoses:
    """Sensor axes and origin in the base frame, as they stand in a table."""

    def __init__(self, table: LogTable, part: PosePart) -> None:
        self.table, self.part = table, part

    def at(self, t: Array, seen: Array, rows: slice, kept: NDArray[np.intp]) -> dict[str, Array]:
        """Orientation (N, 3, 3), and position (N, 3), m, where it is logged."""
        rotation = self._read_rotation(rows)[kept]
        rotation = rotation.inv() if self.part.inverse else rotation
        columns = {"orientation": rotation.as_matrix()}
        if self.part.position is not None:
            columns["position"] = self.table.numbers(*self.part.position, rows=rows)[kept] * LENGTH_UNITS[self.part.position_unit]
        if _are_same(t, seen):
            first = int(np.searchsorted(seen, t[0]))
            return {name: values[first : first + len(t)] for name, values in columns.items()}
        moved = {"orientation": Slerp(seen, rotation)(t).as_matrix()}
        return moved | ({"position": CubicSpline(seen, columns["position"])(t)} if "position" in columns else {})

    def _read_rotation(self, rows: slice) -> Rotation:
        (way,) = self.part.rotations
        columns = getattr(self.part, way)
        values = self.table.numbers(*columns, rows=rows)
        if way == "quaternion":
            off = np.linalg.norm(values, axis=1) - 1.0
            if (place := self._find_off(off, columns[0], rows)) is not None:
                raise BadRecording(place[0], "import-quaternion-length", by=place[1])
            return Rotation.from_quat(values)
        if way == "matrix":
            R = values.reshape(-1, 3, 3)
            off = np.abs(R @ R.transpose(0, 2, 1) - np.eye(3)).max(axis=(1, 2)) + 2.0 * (np.linalg.det(R) < 0)
            if (place := self._find_off(off, columns[0], rows)) is not None:
                raise BadRecording(place[0], "import-no-rotation", by=place[1])
            return Rotation.from_matrix(R)
        angles = values * ANGLE_UNITS[self.part.angle_unit]
        return Rotation.from_rotvec(angles) if way == "rotation_vector" else Rotation.from_euler("xyz", angles)

    def _find_off(self, off: Array, column: str, rows: slice) -> tuple[Message, float] | None:
        """The first row that is off by more than rounding explains, and by how much."""
        wrong = np.flatnonzero(np.abs(off) > ROUNDING)
        if not len(wrong):
            return None
        return name_column(self.table.where, column, rows.start + int(wrong[0]) + 1), float(off[wrong[0]])


class LoggedJoints:
    """The joints of a chain, of which a table may have them in another order and others too.

    Args:
        chain: names of the joints, in the order of the recording.
    """

    def __init__(self, table: LogTable, part: JointsPart, chain: tuple[str, ...]) -> None:
        self.table = table
        picked = [part.names.index(name) for name in chain]
        angle = ANGLE_UNITS[part.angle_unit]
        given = {"q": (part.position, angle), "dq": (part.velocity, angle), "q_cmd": (part.command, angle), "tau": (part.torque, 1.0)}
        self.columns = {name: ([names[k] for k in picked], unit) for name, (names, unit) in given.items() if names is not None}

    def at(self, t: Array, seen: Array, rows: slice, kept: NDArray[np.intp]) -> dict[str, Array]:
        """`q` and, where they are logged, `dq`, `q_cmd` and `tau` (N, n)."""
        values = {name: self.table.numbers(*names, rows=rows)[kept] * unit for name, (names, unit) in self.columns.items()}
        if _are_same(t, seen):
            first = int(np.searchsorted(seen, t[0]))
            return {name: x[first : first + len(t)] for name, x in values.items()}
        return {name: np.asarray(CubicSpline(seen, x)(t)) for name, x in values.items()}


def _are_same(t: Array, seen: Array) -> bool:
    """Whether the times t (N,) are rows of those that are seen, one after the other."""
    first = int(np.searchsorted(seen, t[0]))
    return bool(np.array_equal(seen[first : first + len(t)], t))
