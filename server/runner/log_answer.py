"""What a log was taken for, as it is answered."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, get_args, get_origin

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.setup.clock_offset import ClockOffset, estimate_clock_offset
from core.estimation.setup.log_choice import ImportedLog
from core.payload.channels import CHANNELS
from core.recording.logs.mapping import JointsPart, LogPart, Mapping, PosePart
from core.recording.recording import Recording
from server.runner.log_schemas import LogChange, LogClock, LogColumns, LogLine, LogPreview, LogUnderstood

POINTS = 600
"""Of a plot, at most; a small one has hardly more columns."""
TURNS = ("rotation_vector", "roll_pitch_yaw")
"""Attitudes whose columns are angles."""


def describe_log(made: ImportedLog) -> LogUnderstood:
    """What the columns were taken for, and what the samples tell of them."""
    mapping, conversion, weighed = made.mapping, made.conversion, made.check.weighed
    wrench, late = mapping.wrench, _find_offset(made)
    part, motion = _find_motion(mapping)
    weighs = weighed is not None and weighed.upright
    return LogUnderstood(
        rows_read=conversion.read,
        rows_kept=len(conversion),
        rows_repeated=conversion.repeated,
        rows_outside=conversion.outside,
        rate_hz=1.0 / float(np.median(np.diff(conversion.t))),
        lasts_s=float(conversion.t[-1]),
        force=None if wrench is None else LogColumns(columns=list(wrench.force), unit=wrench.force_unit),
        torque=None if wrench is None else LogColumns(columns=list(wrench.torque), unit=wrench.torque_unit),
        clock=_clock(mapping.rows),
        sign=None if wrench is None else wrench.sign,
        axes=None if wrench is None else wrench.axes,
        is_compensated=wrench is not None and wrench.is_compensated,
        motion=motion,  # type: ignore[arg-type]  # one of the names of the mapping's own keys
        attitude=_attitude(part, motion),
        joint_torques=_joint_torques(part),
        is_inverse=isinstance(part, PosePart) and part.inverse,
        motion_clock=_clock(part),
        motion_hz=conversion.moved_hz,
        position=_position(part),
        base_frame=part.base_frame if isinstance(part, JointsPart) else None,
        sensor_frame=part.sensor_frame if isinstance(part, JointsPart) else None,
        late_s=None if late is None else late.late_s,
        late_std_s=None if late is None else late.std_s,
        mass_kg=weighed.mass if weighed is not None and weighs else None,
        mass_std_kg=weighed.mass_std if weighed is not None and weighs else None,
    )


def _find_offset(made: ImportedLog) -> ClockOffset | None:
    if made.conversion.moved_hz is None or made.check.contradiction is not None:
        return None
    return estimate_clock_offset(made.beginning)


def _find_motion(mapping: Mapping) -> tuple[JointsPart | PosePart, str]:
    part = mapping.motion
    return part, "joints" if isinstance(part, JointsPart) else part.rotations[0]


def _clock(part: LogPart) -> LogClock:
    return LogClock(file=part.file, time=part.time, unit=part.time_unit, begins_s=part.begins_s)


def _attitude(part: JointsPart | PosePart, motion: str) -> LogColumns:
    columns = part.position if isinstance(part, JointsPart) else getattr(part, motion)
    return LogColumns(columns=list(columns), unit=part.angle_unit if motion in {"joints", *TURNS} else None)


def _joint_torques(part: JointsPart | PosePart) -> LogColumns | None:
    if not isinstance(part, JointsPart) or part.torque is None:
        return None
    return LogColumns(columns=list(part.torque), unit="N m")


def _position(part: JointsPart | PosePart) -> LogColumns | None:
    if isinstance(part, JointsPart) or part.position is None:
        return None
    return LogColumns(columns=list(part.position), unit=part.position_unit)


def list_changes(made: ImportedLog) -> list[LogChange]:
    """The keys that may have been taken wrongly, with what else they may be."""
    mapping = made.mapping
    part, motion = _find_motion(mapping)
    name = "joints" if isinstance(part, JointsPart) else "pose"
    keys = [] if mapping.wrench is None else [("wrench", key) for key in ("sign", "force_unit", "torque_unit")]
    keys += [("wrench", "axes"), (name, "inverse")] if isinstance(part, PosePart) else []
    keys += [(name, "angle_unit")] if motion in {"joints", *TURNS} else []
    keys += [(name, "torque_gain_std"), (name, "link_mass_std")] if _joint_torques(part) is not None else []
    keys += [(name, "position_unit")] if _position(part) is not None else []
    keys += [(name if mapping.wrench is None else "wrench", "time_unit")] if mapping.rows.time is not None else []
    if made.conversion.moved_hz is not None:
        keys += [(name, "time_unit"), ("wrench", "begins_s")]
    parts: dict[str, LogPart] = {name: part} if mapping.wrench is None else {"wrench": mapping.wrench, name: part}
    return [_change(each, key, parts[each]) for each, key in keys]


def _change(name: str, key: str, part: LogPart) -> LogChange:
    value = getattr(part, key)
    annotation = type(part).model_fields[key].annotation
    choices = ["false", "true"] if isinstance(value, bool) else map(str, get_args(annotation) if get_origin(annotation) is Literal else ())
    shown = "" if value is None else str(value).lower() if isinstance(value, bool) else str(value)
    return LogChange(key=f"{name}.{key}", value=shown, choices=list(choices))


class LogThinner:
    """Some rows of a recording that comes block after block.

    Args:
        rows: how many there will be.
    """

    def __init__(self, rows: int) -> None:
        self._every = max(1, -(-rows // POINTS))
        self._t: list[Array] = []
        self._wrench: list[Array] = []
        self._torques: list[Array] = []
        self._motion: list[Array] = []
        self._joints: tuple[str, ...] = ()

    def add(self, block: Recording) -> None:
        """The next rows."""
        felt = block.tau if block.wrench is None else block.wrench[:, :3]
        assert felt is not None  # a log has one of them
        size = np.linalg.norm(felt, axis=1)
        unusual = np.abs(size - np.median(size))
        padded = np.concatenate((unusual, np.full(-len(size) % self._every, -1.0))).reshape(-1, self._every)
        rows = np.arange(len(padded)) * self._every + np.argmax(padded, axis=1)
        self._joints = () if block.robot is None else block.robot.joints
        self._t.append(block.t[rows])
        if block.wrench is not None:
            self._wrench.append(block.wrench[rows])
        if block.tau is not None:
            self._torques.append(block.tau[rows])
        self._motion.append(_find_down(block, rows) if block.q is None else block.q[rows])

    def preview(self) -> LogPreview:
        """What was kept."""
        motion = np.concatenate(self._motion)
        wrench = np.concatenate(self._wrench) if self._wrench else None
        return LogPreview(
            t_s=np.round(np.concatenate(self._t), 4).tolist(),
            force_n=[] if wrench is None else _lines(CHANNELS[:3], wrench[:, :3]),
            torque_n_m=[] if wrench is None else _lines(CHANNELS[3:], wrench[:, 3:]),
            joint_torques_n_m=_lines(self._joints, np.concatenate(self._torques)) if self._torques else [],
            joints_rad=_lines(self._joints, motion) if self._joints else [],
            down=[] if self._joints else _lines(("x", "y", "z"), motion),
        )


def _find_down(block: Recording, rows: NDArray[np.intp]) -> Array:
    """Gravity's direction in the sensor's axes, (M, 3)."""
    assert block.orientation is not None  # a log without joints has poses
    down = block.gravity / np.linalg.norm(block.gravity)
    return np.asarray(np.einsum("nji,j->ni", block.orientation[rows], down))


def _lines(names: Sequence[str], values: Array) -> list[LogLine]:
    return [LogLine(name=name, values=np.round(column, 5).tolist()) for name, column in zip(names, values.T, strict=True)]
