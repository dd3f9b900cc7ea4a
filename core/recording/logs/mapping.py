"""What the columns of a log mean: `map.toml`, written by a person."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping as Changes
from pathlib import Path
from typing import Annotated, Literal, TypeAlias

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from core.errors import BadInput, together
from core.files.jail import read_inside
from core.files.schema_flaw import schema_flaw
from core.words.message import Message

MAX_BYTES = 100_000
TIME_UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
FORCE_UNITS = {"N": 1.0, "kN": 1e3, "kgf": 9.80665, "lbf": 4.4482216152605}
TORQUE_UNITS = {"N m": 1.0, "N mm": 1e-3, "N cm": 1e-2, "kgf m": 9.80665, "lbf in": 0.1129848290276167, "lbf ft": 1.3558179483314004}
LENGTH_UNITS = {"m": 1.0, "mm": 1e-3, "cm": 1e-2, "in": 0.0254}
ANGLE_UNITS = {"rad": 1.0, "deg": 0.017453292519943295}
"""In SI; kgf by standard gravity, lbf and inch by the international pound and yard of 1959."""

Column: TypeAlias = Annotated[str, BeforeValidator(lambda given: str(given) if isinstance(given, int) else given)]
"""A name, or a number counted from 1 where the file has no names."""
NotNegative: TypeAlias = Annotated[float, Field(ge=0.0)]
Three: TypeAlias = Annotated[tuple[Column, ...], Field(min_length=3, max_length=3)]


class MappingPart(BaseModel):
    """A part of the file, read strictly: an unknown key is an error."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


class LogPart(MappingPart):
    """Columns of one file with a clock of its own.

    Args:
        file: a file of the log or a topic of its bag; None where there is only one.
        time: None of poses that somebody averaged: rows without times, in the same file for all parts.
        begins_s: what its clock is behind that of the other files, s: added to its times.
    """

    file: str | None = None
    time: Column | None = None
    time_unit: Literal["s", "ms", "us", "ns"] = "s"
    begins_s: float = 0.0


class WrenchPart(LogPart):
    """The wrist sensor's readings about its own origin.

    Args:
        axes: in which they are; base axes are turned into the sensor's by its attitude.
        sign: 1 for what the sensor exerts on the payload, -1 for what the payload exerts on the sensor.
    """

    force: Three
    torque: Three
    force_unit: Literal["N", "kN", "kgf", "lbf"] = "N"
    torque_unit: Literal["N m", "N mm", "N cm", "kgf m", "lbf in", "lbf ft"] = "N m"
    sign: Literal[1, -1] = 1
    axes: Literal["sensor", "base"] = "sensor"

    @property
    def is_compensated(self) -> bool:
        """Whether it is UR's, from which the controller has taken off the payload that it is set to."""
        return all(name.casefold().startswith("actual_tcp_force") for name in self.force)


class PosePart(LogPart):
    """Sensor axes in the base frame, in one of four ways.

    Args:
        quaternion: columns of x, y, z and w.
        matrix: nine columns, row after row.
        rotation_vector: axis times angle.
        roll_pitch_yaw: about the fixed axes x, y and z, in this order.
        inverse: the columns are those of the base's axes in the sensor.
        position: of the sensor's origin in the base frame.
    """

    quaternion: Annotated[tuple[Column, ...], Field(min_length=4, max_length=4)] | None = None
    matrix: Annotated[tuple[Column, ...], Field(min_length=9, max_length=9)] | None = None
    rotation_vector: Three | None = None
    roll_pitch_yaw: Three | None = None
    angle_unit: Literal["rad", "deg"] = "rad"
    inverse: bool = False
    position: Three | None = None
    position_unit: Literal["m", "mm", "cm", "in"] = "m"

    @property
    def rotations(self) -> list[str]:
        """Names of the ways that are given."""
        return [name for name in ("quaternion", "matrix", "rotation_vector", "roll_pitch_yaw") if getattr(self, name) is not None]


class JointsPart(LogPart):
    """The joints, for a robot whose URDF is at hand.

    Args:
        urdf: file, beside the mapping; None where the log brings one.
        names: the URDF's, in the order of the columns; those that are not between the two frames are left out.
        velocity, command, torque: columns likewise, where they are logged; torque in N m.
        torque_gain_std, link_mass_std: relative standard uncertainties of the torques and of the masses in the URDF; None where nobody
            knows.
    """

    urdf: str | None = None
    names: Annotated[tuple[str, ...], Field(min_length=1)]
    base_frame: str
    sensor_frame: str
    position: tuple[Column, ...]
    velocity: tuple[Column, ...] | None = None
    command: tuple[Column, ...] | None = None
    torque: tuple[Column, ...] | None = None
    torque_gain_std: NotNegative | None = None
    link_mass_std: NotNegative | None = None
    angle_unit: Literal["rad", "deg"] = "rad"


class Mapping(MappingPart):
    """What a log holds.

    Args:
        source: where it is from, for the record.
        gravity_m_s2: in the base frame.
        wrench: None where no wrist sensor is logged, but the joints' torques are.
    """

    source: str | None = None
    gravity_m_s2: tuple[float, float, float] = (0.0, 0.0, -9.81)
    wrench: WrenchPart | None = None
    pose: PosePart | None = None
    joints: JointsPart | None = None

    @property
    def motion(self) -> JointsPart | PosePart:
        """What the attitude comes from."""
        part = self.joints if self.joints is not None else self.pose
        assert part is not None  # a mapping that was read has one of them
        return part

    @property
    def rows(self) -> LogPart:
        """The part whose rows become the recording's."""
        return self.motion if self.wrench is None else self.wrench


def read_mapping(file: Path) -> Mapping:
    """The mapping in a file.

    Raises:
        BadInput: it cannot be read, or says something that no log can mean; with key, value and what is expected.
    """
    text = read_inside(file.parent, file.name, BadInput, max_bytes=MAX_BYTES)
    try:
        content = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise BadInput(str(file), "import-no-toml", reason=str(error)[:120]) from error
    return validate_mapping(content, str(file))


def change_mapping(mapping: Mapping, changes: Changes[str, str]) -> Mapping:
    """The mapping with other values at keys such as `wrench.sign`.

    Args:
        changes: values as TOML has them; a word without quotation marks is a text.

    Raises:
        BadInput: a key that is not known, or a value that it cannot have.
    """
    content = mapping.model_dump(exclude_none=True)
    for key, value in changes.items():
        *parents, last = key.split(".")
        inner = content
        for parent in parents:
            inner = inner.setdefault(parent, {})
            if not isinstance(inner, dict):
                raise BadInput(f"--set {key}", "import-no-key", key=key)
        inner[last] = _read_value(value)
    return validate_mapping(content, "--set")


def _read_value(text: str) -> object:
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return text


def validate_mapping(content: object, where: str) -> Mapping:
    """A mapping of what a file or a person says.

    Raises:
        BadInput: what it says no log can mean; with key, value and what is expected.
    """
    try:
        mapping = Mapping.model_validate(content)
    except ValidationError as error:
        raise together([schema_flaw(flaw).refusal(BadInput, where) for flaw in error.errors()]) from error
    check_choices(mapping, where)
    return mapping


def write_mapping(mapping: Mapping) -> str:
    """The mapping as TOML."""
    content = mapping.model_dump(exclude_defaults=True, exclude_none=True)
    lines = [f"{key} = {_toml(value)}" for key, value in content.items() if not isinstance(value, dict)]
    for name, part in content.items():
        if isinstance(part, dict):
            lines += [f"[{name}]", *(f"{key} = {_toml(value)}" for key, value in part.items())]
    return "\n".join(lines) + "\n"


def _toml(value: object) -> str:
    """JSON's texts, numbers and lists are TOML's as well."""
    return json.dumps(value, ensure_ascii=False)


def check_choices(mapping: Mapping, where: str) -> None:
    """Raises BadInput where parts of a mapping do not belong together."""
    if mapping.pose is None and mapping.joints is None:
        raise BadInput(where, "import-no-attitude")
    if mapping.pose is not None and len(mapping.pose.rotations) != 1:
        raise BadInput(Message.of("import-key", file=where, key="pose"), "import-rotations", given=mapping.pose.rotations)
    wrench, joints = mapping.wrench, mapping.joints
    if wrench is None and (joints is None or joints.torque is None):
        raise BadInput(where, "import-nothing-felt")
    if wrench is not None and wrench.axes == "base" and mapping.pose is None:
        raise BadInput(Message.of("import-key", file=where, key="wrench.axes"), "import-base-axes-without-pose")
    times = {part.time is None for part in (wrench, mapping.pose, joints) if part is not None}
    if len(times) > 1:
        raise BadInput(Message.of("import-key", file=where, key="time"), "import-time-for-some")
    for name in () if joints is None else ("position", "velocity", "command", "torque"):
        columns = getattr(joints, name)
        if joints is not None and columns is not None and len(columns) != len(joints.names):
            key = Message.of("import-key", file=where, key=f"joints.{name}")
            raise BadInput(key, "import-columns-of-joints", count=len(columns), joints=len(joints.names))
