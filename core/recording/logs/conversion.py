"""From the tables of a log to a recording: SI, the paper's sign, one clock, one row for each reading of the wrench, else of the joints."""

from __future__ import annotations

from collections.abc import Iterator
from copy import copy
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.cell.urdf import check_urdf
from core.errors import BadRecording
from core.files.jail import read_inside
from core.recording.logs.mapping import FORCE_UNITS, TIME_UNITS, TORQUE_UNITS, JointsPart, LogPart, Mapping, WrenchPart
from core.recording.logs.motion import LoggedJoints, LoggedPoses
from core.recording.logs.tables import Log, LogTable
from core.recording.recording import Recording, RobotDescription
from core.recording.samples import name_column
from core.words.message import Message

HOLE_S = 0.1
"""Nothing is known of the motion between two rows that are further apart: readings of the wrench there are left out."""
POSE_S = 1.0
"""From one averaged pose to the next, which have no times."""
MARGIN = 64
"""Rows before and after a block that a curve through its rows takes into account; farther ones change nothing."""
BLOCK = 200_000
"""Rows that are converted at once."""
MAX_URDF_BYTES = 20_000_000


class Clock:
    """The times of a table, s, that increase; `rows`: where each stands in it."""

    def __init__(self, table: LogTable, part: LogPart) -> None:
        if part.time is None:
            self.rows = np.arange(len(table))
            self.t: Array = POSE_S * self.rows.astype(float)
        else:
            t = table.numbers(part.time)[:, 0] * TIME_UNITS[part.time_unit]
            steps: Array = np.diff(t, prepend=-np.inf)
            if (steps < 0).any():
                row = int(np.flatnonzero(steps < 0)[0])
                raise BadRecording(name_column(table.where, part.time, row + 1), "import-time-back", by_s=-float(steps[row]))
            self.rows = np.flatnonzero(steps > 0)
            self.t = t[self.rows] + part.begins_s
        self.repeated = len(table) - len(self.rows)


class LoggedMotion(Protocol):
    """What is known of the motion: columns of the recording at times (N,), from the rows of the table beside them."""

    def at(self, t: Array, seen: Array, rows: slice, kept: NDArray[np.intp]) -> dict[str, Array]:
        """Columns at t (N,), s, from the table's rows `rows`, of which those of `kept` are at the times `seen` (K,)."""
        ...


class Conversion:
    """A log under a mapping; rows are read when they are asked for, so that a long log need not be in memory.

    Args:
        log: it.
        mapping: what its columns mean.
        beside: folder in which the URDF is.

    Attributes:
        t: (N,), s, of the rows that are kept, from 0.
        read: rows of the wrench in the log; of the joints, where it has no wrench.
        repeated: of them, rows with the time of the row before; they are left out.
        outside: rows at times without an attitude, likewise.
        moved_hz: rate of the attitudes, where they have a clock of their own.

    Raises:
        BadRecording: a table or column that is missing or cannot be used, with file, column and row; times that go back; no time at which
            both wrench and attitude are known.
    """

    def __init__(self, log: Log, mapping: Mapping, beside: Path) -> None:
        self.mapping = mapping
        part, lead = mapping.motion, mapping.rows
        table = log.table(part.file, "pose" if mapping.joints is None else "joints")
        self._table = table if lead is part else log.table(lead.file, "wrench")
        felt, moved = Clock(self._table, lead), Clock(table, part)
        if part.time is None and table is not self._table:
            raise BadRecording(Message.of("import-key", file=log.where, key="time"), "import-poses-of-two-files")
        self.together = bool(np.array_equal(felt.t, moved.t))
        kept = np.ones(len(felt.t), dtype=bool) if self.together else _is_known(felt.t, moved.t)
        if np.count_nonzero(kept) < 2:
            times = dict(zip(("begin_s", "end_s", "first_s", "last_s"), (*felt.t[[0, -1]], *moved.t[[0, -1]]), strict=True))
            raise BadRecording(log.where, "import-no-overlap", **{key: float(value) for key, value in times.items()})
        self._times, self._rows, self._moved = felt.t[kept], felt.rows[kept], moved
        self.t = self._times - self._times[0]
        self.read, self.repeated, self.outside = len(self._table), felt.repeated, int((~kept).sum())
        self.moved_hz = None if self.together else 1.0 / float(np.median(np.diff(moved.t)))
        self.robot: RobotDescription | None = None
        self._motion: LoggedMotion
        if isinstance(part, JointsPart):
            self.robot = _read_robot(part, log, beside)
            self._motion = LoggedJoints(table, part, self.robot.joints)
        else:
            self._motion = LoggedPoses(table, part)

    def __len__(self) -> int:
        return len(self.t)

    def under(self, mapping: Mapping) -> Conversion:
        """The same log under a mapping that differs in nothing but sign and axes of the wrench."""
        other = copy(self)
        other.mapping = mapping
        return other

    def recording(self, rows: slice = slice(None)) -> Recording:
        """The recording of these rows.

        Raises:
            BadRecording: a value that cannot be used, with file, column and row.
        """
        begin, end, _ = rows.indices(len(self))
        part = self.mapping.wrench
        wrench = None if part is None else self._wrench_at(part, begin, end)
        columns = self._motion_at(begin, end)
        orientation = columns.get("orientation")
        if part is not None and wrench is not None and part.axes == "base" and orientation is not None:
            wrench = np.einsum("nji,nkj->nki", orientation, wrench.reshape(-1, 2, 3)).reshape(-1, 6)
        gravity, source = np.array(self.mapping.gravity_m_s2), self.mapping.source
        stated: dict[str, Any] = {}
        if self.mapping.joints is not None:
            stated = {name: getattr(self.mapping.joints, name) for name in ("torque_gain_std", "link_mass_std")}
        return Recording(t=self.t[begin:end], gravity=gravity, wrench=wrench, robot=self.robot, source=source, **stated, **columns)

    def blocks(self, begin: int = 0) -> Iterator[Recording]:
        """The rows from `begin` on, block after block."""
        for at in range(begin, len(self), BLOCK):
            yield self.recording(slice(at, min(at + BLOCK, len(self))))

    def _wrench_at(self, part: WrenchPart, begin: int, end: int) -> Array:
        rows = self._rows[begin:end]
        values = self._table.numbers(*part.force, *part.torque, rows=slice(int(rows[0]), int(rows[-1]) + 1))[rows - rows[0]]
        return np.asarray(part.sign * values * _scales(part))

    def _motion_at(self, begin: int, end: int) -> dict[str, Any]:
        t, seen = self._times[begin:end], self._moved.t
        first = max(int(np.searchsorted(seen, t[0], side="right")) - 1 - MARGIN, 0)
        last = min(int(np.searchsorted(seen, t[-1])) + 1 + MARGIN, len(seen))
        rows = self._moved.rows[first:last]
        return self._motion.at(t, seen[first:last], slice(int(rows[0]), int(rows[-1]) + 1), rows - rows[0])


def _scales(part: WrenchPart) -> Array:
    return np.repeat([FORCE_UNITS[part.force_unit], TORQUE_UNITS[part.torque_unit]], 3)


def _read_robot(part: JointsPart, log: Log, beside: Path) -> RobotDescription:
    """The robot, with the joints between the two frames."""
    if part.urdf is not None:
        text, where = read_inside(beside, part.urdf, BadRecording, max_bytes=MAX_URDF_BYTES), str(beside / part.urdf)
    elif log.urdf is not None:
        text, where = log.urdf, f"{log.where}: robot_description"
    else:
        raise BadRecording(Message.of("import-key", file=log.where, key="joints.urdf"), "import-no-urdf")
    urdf = check_urdf(text, where)
    for key in ("base_frame", "sensor_frame"):
        if getattr(part, key) not in urdf.links:
            raise BadRecording(f"{where}: {key}", "recording-unknown-link", link=getattr(part, key), links=list(urdf.links))
    chain = urdf.chain(part.base_frame, part.sensor_frame)
    missing = [name for name in chain if name not in part.names]
    if missing or not chain:
        raise BadRecording(
            Message.of("import-key", file=log.where, key="joints.names"), "import-other-chain", joints=part.names, chain=chain
        )
    return RobotDescription(text, chain, part.base_frame, part.sensor_frame)


def _is_known(t: Array, moved: Array) -> NDArray[np.bool_]:
    """Which of the times t (N,) lie between two rows of the motion (K,) that are close together."""
    if len(moved) < 2:
        return np.zeros(len(t), dtype=bool)
    after = np.searchsorted(moved, t, side="left")
    inside = (t >= moved[0]) & (t <= moved[-1])
    after = np.clip(after, 1, len(moved) - 1)
    return np.asarray(inside & (moved[after] - moved[after - 1] <= HOLE_S))
