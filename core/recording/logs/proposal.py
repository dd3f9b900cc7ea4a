"""What the columns of a log seem to mean, by their names and their steps in time; what cannot be known is left to a person."""

from __future__ import annotations

import re
from collections.abc import Mapping as Answers
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from core.cell.urdf import check_urdf
from core.cell.urdf_elements import UrdfJoint
from core.errors import BadRecording
from core.recording.logs.column_name import bare_name, unit_of
from core.recording.logs.mapping import ANGLE_UNITS, FORCE_UNITS, LENGTH_UNITS, TIME_UNITS, TORQUE_UNITS, Mapping, change_mapping
from core.recording.logs.question import OpenQuestion
from core.recording.logs.tables import Log, LogTable

FORCE = (r"ft_raw_wrench_{n}", r"f_?{}", r"(.*[_.])?force[_.]?{}", r"actual_tcp_force_{n}")
TORQUE = (r"ft_raw_wrench_{n3}", r"[tm]_?{}", r"(.*[_.])?(torque|moment)[_.]?{}", r"actual_tcp_force_{n3}")
POSITION = (r"p?_?{}", r"(.*[_.])?(pos|position|translation)[_.]?{}", r"actual_tcp_pose_{n}")
WAYS = {
    "matrix": (r"r_?{}", r"(.*[_.])?(rot|rotation|matrix)[_.]?{}"),
    "quaternion": (r"q_?{}", r"(.*[_.])?(quat|quaternion|orientation|rotation)[_.]?{}"),
    "rotation_vector": (r"r_?{}", r"(.*[_.])?rotvec[_.]?{}", r"actual_tcp_pose_{n3}"),
    "roll_pitch_yaw": (r"{w}", r"(.*[_.])?{w}"),
}
XYZ: tuple[str, ...] = ("x", "y", "z")
PARTS = {
    "matrix": tuple(f"{row}{column}" for row in (1, 2, 3) for column in (1, 2, 3)),
    "quaternion": tuple("xyzw"),
    "rotation_vector": XYZ,
    "roll_pitch_yaw": ("roll", "pitch", "yaw"),
}
JOINT = re.compile(r"position\.(.+)")
NUMBERED = (r"actual_q_{}", r"q_?{}", r"(joint|j|a)_?{}", r"(.*[_.])?(joint|position|q)_?{}")
NUMBERED_TORQUES = (r"tau_?{}", r"((joint|measured|msr)_)?torque_?{}", r"(.*[_.])?(tau|effort|joint_torque)_?{}")
TIME = re.compile(r"(.*[_.])?(t|time|timestamp|stamp|secs?|seconds)([_ ]?(s|ms|us|ns))?", re.IGNORECASE)
RATES_HZ = (5.0, 20_000.0)
"""Of a log of motion: the unit of time is the one that gives such a rate."""
TURNS_RAD = 8.0 * np.pi
"""More than a joint without limits is turned in a log."""
BEYOND_RAD = 0.5
"""By so much no joint is beyond its limits."""
MOST_POSES = 500
"""Rows of a list of averaged poses, which needs no time."""


WHY_FILE = {"wrench": "import-why-wrench-file", "pose": "import-why-pose-file"}


class Described(NamedTuple):
    """Columns for one meaning: the table's name, the table, and the columns."""

    name: str
    table: LogTable
    columns: tuple[str, ...]


def propose_mappings(log: Log, answers: Answers[str, str], urdf: str | None = None) -> list[Mapping]:
    """Mappings that names and steps speak for, the likeliest first; what no name tells, the sign of the wrench and its axes, is open.

    Args:
        answers: keys that a person has given, such as `wrench.file`, `wrench.axes`.
        urdf: text of the robot's description, where it is at hand; the attitude then comes from the joints.

    Raises:
        OpenQuestion: several columns could be meant.
        BadRecording: no columns look like a force, a torque, an attitude or a time; it says which key of `map.toml` names them.
    """
    if not _search(log, FORCE, XYZ, answers.get("wrench.file")) and (by_torques := _propose_by_torques(log, answers, urdf)) is not None:
        return [by_torques]
    wrench = _find(log, "wrench", FORCE, XYZ, answers)
    torque = _match(wrench.table, TORQUE, XYZ)
    if torque is None:
        raise _refuse(log, "wrench.torque", wrench.table)
    readings = {**_clock(log, wrench), "force": wrench.columns, "torque": torque}
    readings |= _units(wrench.columns, "force_unit", FORCE_UNITS) | _units(torque, "torque_unit", TORQUE_UNITS)
    motion = _propose_motion(log, wrench, answers, urdf)
    compensated = all(name.casefold().startswith("actual_tcp_force") for name in wrench.columns)
    axes = ("base", "sensor") if compensated else ("sensor", "base") if "pose" in motion else ("sensor",)
    proposed = [Mapping.model_validate({"wrench": {**readings, "axes": each, "sign": sign}, **motion}) for each in axes for sign in (1, -1)]
    given = {key: value for key, value in answers.items() if not key.endswith(".file")}
    changed = [change_mapping(each, given) for each in proposed]
    return [each for k, each in enumerate(changed) if each not in changed[:k]]


def _propose_by_torques(log: Log, answers: Answers[str, str], urdf: str | None) -> Mapping | None:
    """A log of joints with their torques; None where it has none."""
    robot = urdf or log.urdf
    joints = None if robot is None else _find_joints(log, answers, robot)
    if robot is None or joints is None or "torque" not in joints[1]:
        return None
    proposed = Mapping.model_validate({"joints": {**_clock(log, joints[0]), **joints[1], **_frames(log, robot, None, answers)}})
    return change_mapping(proposed, {key: value for key, value in answers.items() if not key.endswith(".file")})


def _propose_motion(log: Log, wrench: Described, answers: Answers[str, str], urdf: str | None) -> dict[str, Any]:
    robot = urdf or log.urdf
    joints = _find_joints(log, answers, robot) if robot is not None else None
    if joints is not None and robot is not None:
        return {"joints": {**_clock(log, joints[0]), **joints[1], **_frames(log, robot, wrench.table.frame, answers)}}
    composed = log.compose(wrench.table.frame) if "pose.file" not in answers and wrench.table.frame is not None else None
    if composed is not None:
        log.tables[composed.where.rpartition(": ")[2]] = composed
    for way, patterns in WAYS.items():
        found = _search(
            log, patterns, PARTS[way], answers.get("pose.file") or (None if composed is None else composed.where.rpartition(": ")[2])
        )
        if found:
            pose = _one_of(log, "pose", found)
            position = _match(pose.table, POSITION, XYZ)
            units = _units(position or (), "position_unit", LENGTH_UNITS) | _units(pose.columns, "angle_unit", ANGLE_UNITS)
            return {"pose": {**_clock(log, pose), way: pose.columns, "position": position, **units}}
    raise _refuse(log, "pose", *log.tables.values())


def _find_joints(log: Log, answers: Answers[str, str], robot: str) -> tuple[Described, dict[str, Any]] | None:
    """Columns of joints: those that bear the names of the robot's, else numbered ones, as many as move."""
    joints = [joint for joint in check_urdf(robot, log.where).joints if joint.kind != "fixed"]
    moving = [joint.name for joint in joints]
    for name, table in _tables(log, answers.get("joints.file")):
        named = [match[1] for column in table.columns if (match := JOINT.fullmatch(column)) and match[1] in moving]
        if len(named) > 1:
            given = {key: tuple(f"{prefix}.{joint}" for joint in named) for key, prefix in PREFIXES.items()}
            there = {key: columns for key, columns in given.items() if set(columns) <= set(table.columns)}
            return Described(name, table, there["position"]), {"names": named, **there}
        for first in (0, 1):
            numbers = tuple(str(k + first) for k in range(len(moving)))
            columns, torques = _match(table, NUMBERED, numbers), _match(table, NUMBERED_TORQUES, numbers)
            if columns is not None:
                felt = {} if torques is None else {"torque": torques}
                unit = _units(columns, "angle_unit", ANGLE_UNITS) or _guess_angle_unit(table, columns, joints)
                return Described(name, table, columns), {"names": moving, "position": columns, **felt, **unit}
    return None


def _guess_angle_unit(table: LogTable, columns: Sequence[str], joints: Sequence[UrdfJoint]) -> dict[str, str]:
    """Degrees, where a joint would be far beyond its limits in rad."""
    largest = np.abs(table.numbers(*columns, rows=slice(0, 100_000))).max(axis=0)
    limits = [TURNS_RAD if each.kind == "continuous" else max(abs(each.lower or 0.0), abs(each.upper or 0.0)) for each in joints]
    return {"angle_unit": "deg"} if (largest > np.array(limits) + BEYOND_RAD).any() else {}


PREFIXES = {"position": "position", "velocity": "velocity", "torque": "effort"}


def _frames(log: Log, robot: str, frame: str | None, answers: Answers[str, str]) -> dict[str, str]:
    """Base: the root of the robot. Sensor: the frame that the wrench's messages name."""
    urdf = check_urdf(robot, log.where)
    children = {joint.child for joint in urdf.joints}
    sensor = answers.get("joints.sensor_frame") or (frame or "").lstrip("/")
    if sensor not in urdf.links:
        tips = [link for link in urdf.links if link in children][::-1]
        raise OpenQuestion(log.where, "joints.sensor_frame", tips[:12], "import-why-sensor-frame", next(iter(tips), None))
    base = answers.get("joints.base_frame") or next(link for link in urdf.links if link not in children)
    return {"base_frame": base, "sensor_frame": sensor}


def _find(log: Log, key: str, patterns: Sequence[str], parts: Sequence[str], answers: Answers[str, str]) -> Described:
    """The one table with such columns."""
    found = _search(log, patterns, parts, answers.get(f"{key}.file"))
    if not found:
        raise _refuse(log, "wrench.force", *log.tables.values())
    return _one_of(log, key, found)


def _search(log: Log, patterns: Sequence[str], parts: Sequence[str], file: str | None) -> list[Described]:
    found = [(name, table, _match(table, patterns, parts)) for name, table in _tables(log, file)]
    return [Described(name, table, columns) for name, table, columns in found if columns is not None]


def _tables(log: Log, file: str | None) -> list[tuple[str, LogTable]]:
    """All that have more than a row, or the one that is asked for."""
    if file is not None:
        return [(file, log.table(file, "log"))]
    return [(name, table) for name, table in log.tables.items() if len(table) > 1 and ">" not in name]


def _one_of(log: Log, key: str, found: Sequence[Described]) -> Described:
    if len(found) > 1:
        raise OpenQuestion(log.where, f"{key}.file", [each.name for each in found], WHY_FILE[key])
    return found[0]


def _refuse(log: Log, key: str, *tables: LogTable) -> BadRecording:
    columns = [name for table in tables for name in table.columns]
    return BadRecording(log.where, "import-not-recognised", key=key, columns=columns[:20])


def _match(table: LogTable, patterns: Sequence[str], parts: Sequence[str]) -> tuple[str, ...] | None:
    """A column for each part (x, y, z ...), all after the same pattern."""
    names = {name: bare_name(name) for name in table.columns}
    for pattern in patterns:
        columns = []
        for k, part in enumerate(parts):
            filled = pattern.replace("{}", part).replace("{w}", part).replace("{n}", str(k)).replace("{n3}", str(k + 3))
            columns += [name for name, bare in names.items() if re.fullmatch(filled, bare, re.IGNORECASE)][:1]
        if len(columns) == len(parts):
            return tuple(columns)
    return None


def _units(columns: Sequence[str], key: str, units: Answers[str, float]) -> dict[str, str]:
    """The unit that the names of the columns bear."""
    unit = unit_of(columns[0], units) if columns else None
    return {} if unit is None else {key: unit}


def _clock(log: Log, found: Described) -> dict[str, Any]:
    """File, column of the time and its unit; a short table with everything in it may be a list of poses without times."""
    named = [(name, match) for name in found.table.columns if (match := TIME.fullmatch(bare_name(name)))]
    if not named:
        if len(log.tables) == 1 and len(found.table) <= MOST_POSES:
            return {"file": found.name}
        raise _refuse(log, "time", found.table)
    name, match = named[0]
    unit = unit_of(name, TIME_UNITS) or (match[4] or "").lower() or _guess_unit(found.table, name)
    return {"file": found.name, "time": name, "time_unit": unit}


def _guess_unit(table: LogTable, name: str) -> str:
    """The largest unit in which the rows follow each other as fast as those of a log do."""
    steps = np.diff(table.numbers(name, rows=slice(0, 100_000))[:, 0])
    step = float(np.median(steps[steps > 0])) if (steps > 0).any() else 0.0
    fitting = [unit for unit, seconds in TIME_UNITS.items() if step > 0 and RATES_HZ[0] <= 1.0 / (step * seconds) <= RATES_HZ[1]]
    if not fitting:
        raise BadRecording(table.where, "import-time-unit", column=name, step=step)
    return fitting[0]
