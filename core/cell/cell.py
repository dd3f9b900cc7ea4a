"""A cell: robot, sensor, obstacles, protected zones and limits; data only, read from `cells/<name>/cell.toml`.

Everything that stands in the cell is given in the world frame; the robot's base is placed in it by `robot.base`.
"""

from __future__ import annotations

import difflib
import tomllib
from functools import cached_property
from pathlib import Path
from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, ValidationError
from pydantic_core import ErrorDetails

from core.cell.contradictions import contradictions
from core.cell.tool import Tool
from core.cell.tool_checks import tool_flaws
from core.cell.urdf import Urdf, check_urdf
from core.cell.urdf_elements import MAX_BYTES as MAX_URDF_BYTES
from core.errors import BadCell, BadInput, BadRobot, refuse, together
from core.files.jail import read_inside
from core.files.schema_flaw import SchemaFlaw, schema_flaw
from core.payload.inertia import InertialParameters
from core.payload.shapes import (
    Angle,
    Box,
    Capsule,
    Cylinder,
    Model,
    NotNegative,
    Number,
    Pose,
    Positive,
    Shape,
    Six,
    SixPositive,
    Sphere,
    Vector3,
)

__all__ = [
    "Box", "Capsule", "Cell", "CellRead", "Control", "Cylinder", "Friction", "Limits", "Obstacle", "Payload", "Pose", "Robot", "Sensor",
    "Shape", "Sphere", "Tool", "Zone", "check_robot", "contradictions_of", "find_cell", "list_cell_folders", "load_cell",
    "read_cell_folder",
]  # fmt: skip

Array = NDArray[np.float64]
Name = Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{1,64}$")]
Text = Annotated[str, Field(min_length=1, max_length=200)]

CELL_FILE = "cell.toml"
TWIN_FILE = "twin.json"
MAX_CELL_BYTES = 1_000_000


class Obstacle(Model):
    """Something solid that stands in the cell."""

    name: Name
    shape: Shape


class Zone(Model):
    """A protected zone: people may be anywhere in it; neither the robot nor a load that comes off may get into it."""

    name: Name
    shape: Shape


class Friction(Model):
    """Friction that the drives are known to have, one value for each joint: no news where a diagnosis finds it."""

    coulomb_n_m: tuple[NotNegative, ...]
    viscous_n_m_s: tuple[NotNegative, ...]
    """N m per rad/s."""


class Robot(Model):
    """The arm. Joints are those between `base_frame` and `sensor_frame`, in that order."""

    urdf: str = "robot.urdf"
    base_frame: str
    sensor_frame: str
    home_rad: tuple[Angle, ...]
    acceleration_rad_s2: tuple[Annotated[float, Field(strict=True, ge=0.1, le=200.0)], ...]
    """Joints of arms have 5 to 50 rad/s2; with less than 0.1 a plan takes hours."""
    velocity_rad_s: tuple[Annotated[float, Field(strict=True, ge=0.01, le=50.0)], ...] | None = None
    """The URDF's limits where absent. Joints of arms have 1 to 10 rad/s."""
    friction: Friction | None = None
    """None where nobody has said."""
    payload_limit_kg: Positive | None = None
    """What the arm may carry by its maker's word; None where nobody has said."""
    base: Pose = Pose()
    adjacent: tuple[tuple[str, str], ...] = ()
    """Pairs of links that are close to each other by construction: no distance between them is watched."""
    visual_shapes: tuple[str, ...] = ()
    """Links whose <visual> counts as their shape, since the URDF gives them no <collision>."""


class Sensor(Model):
    """The wrist force/torque sensor; six values each, force (N), then torque (N m)."""

    name: Text
    noise_std: SixPositive
    range: SixPositive
    resolution: SixPositive
    mount: Pose | None = None
    """The sensor frame in the flange from which the robot's controller counts; None where nobody has said."""


class Limits(Model):
    """What no point of the robot may exceed.

    Args:
        cartesian_speed_m_s: of every point of every link and every corner of the boxes of payload and tools. At most four times what
            ISO 10218-1 calls reduced speed, 0.25 m/s: room for cells whose own safety functions allow more, none for 25 or 250 by a slip
            of the unit. Below 5 mm/s a plan takes hours.
        clearance_m: smallest distance to obstacles, protected zones and the floor. At most 0.5 m, all round: no arm has room for more.
        self_clearance_m: smallest distance between links. At most 0.2 m: links of one arm are no farther apart.
    """

    cartesian_speed_m_s: Annotated[float, Field(strict=True, ge=0.005, le=1.0)] = 0.25
    clearance_m: Annotated[float, Field(strict=True, gt=0, le=0.5)] = 0.03
    self_clearance_m: Annotated[float, Field(strict=True, gt=0, le=0.2)] = 0.01


class Control(Model):
    """How the robot depends on whoever is in control of it.

    Args:
        lease_s: how long the robot moves on without an answer from the console; then it brakes and keeps its place. Shorter than 0.3 s no
            Wi-Fi lasts; longer than 5 s nobody would take it for supervision. It is no emergency stop.
        hold_limit_s: how long a robot on hold waits for somebody to be in control again before its run ends.
    """

    lease_s: Annotated[float, Field(strict=True, ge=0.3, le=5.0)] = 1.0
    hold_limit_s: Annotated[float, Field(strict=True, ge=10.0, le=3600.0)] = 120.0


class Payload(Model):
    """A payload that the cell knows: what the simulated robot carries, and the reference to compare with."""

    title: Text
    mass_kg: Positive
    first_moment_kg_m: Vector3
    inertia_kg_m2: Six
    """Ixx Ixy Ixz Iyy Iyz Izz about the sensor origin."""
    box: Box
    """Bounding box in the sensor frame."""
    source: Text = "unknown"

    @property
    def parameters(self) -> InertialParameters:
        """The payload's ten parameters in the sensor frame."""
        return InertialParameters(np.array([self.mass_kg, *self.first_moment_kg_m, *self.inertia_kg_m2]))


class Cell(Model):
    """One robot cell, everything the procedure needs to know of it.

    Every value is right by itself; whether they go together says `contradictions_of`.
    """

    name: Name
    title: Text
    robot: Robot
    sensor: Sensor
    limits: Limits = Limits()
    control: Control = Control()
    gravity_m_s2: Vector3 = (0.0, 0.0, -9.81)
    """In the world frame."""
    floor_z_m: Number = 0.0
    """Height at which a load that comes off stops falling, in the world frame."""
    payload_box: Box
    """Used where a payload is not known by name; in the sensor frame, without the boxes of tools."""
    obstacles: tuple[Obstacle, ...] = ()
    zones: tuple[Zone, ...] = ()
    payloads: dict[Name, Payload] = Field(default_factory=dict)
    tools: dict[Name, Tool] = Field(default_factory=dict)
    """What is bolted between the sensor and the payload."""
    folder: Path = Field(default=Path(), exclude=True)
    """Where cell.toml and the URDF are."""

    @property
    def gravity(self) -> Array:
        """(3,), world frame, m/s2."""
        return np.array(self.gravity_m_s2)

    @property
    def gravity_in_base(self) -> Array:
        """(3,), base frame, m/s2."""
        return np.asarray(self.robot.base.rotation.T @ self.gravity)

    @cached_property
    def urdf(self) -> str:
        """Text of the robot's URDF."""
        where = f"{self.folder / CELL_FILE}: robot.urdf"
        return read_inside(self.folder, self.robot.urdf, BadRobot, max_bytes=MAX_URDF_BYTES, where=where)

    def with_pose_of(self, name: str, pose: Pose) -> Cell:
        """The same cell with the obstacle or zone of that name elsewhere (world frame)."""
        moved = {
            field: tuple(
                item.model_copy(update={"shape": item.shape.model_copy(update={"pose": pose})}) if item.name == name else item
                for item in getattr(self, field)
            )
            for field in ("obstacles", "zones")
        }
        return self.model_copy(update=moved)


class CellRead(NamedTuple):
    """A cell whose `cell.toml` could be read, whether or not it can be used.

    Args:
        robot_flaws: what of the robot's model cannot be used, or does not go with the cell.
    """

    cell: Cell
    robot_flaws: tuple[BadInput, ...] = ()

    @property
    def flaws(self) -> tuple[BadInput, ...]:
        """Why nothing can be planned in it; empty where nothing speaks against it."""
        return (*contradictions_of(self.cell), *self.robot_flaws)


def contradictions_of(cell: Cell) -> list[BadCell]:
    """What in a cell does not go together, wherever its zones have been moved to."""
    where = cell.folder / CELL_FILE
    return [BadCell(f"{where}: {key}", found, expected, name) for key, found, expected, name in contradictions(cell)]


def load_cell(folder: Path) -> Cell:
    """Reads and validates `cell.toml` and the URDF beside it.

    Raises:
        BadCell: cell.toml is malformed or contradicts itself or the URDF.
        BadRobot: the URDF is malformed or hostile.
    """
    found = read_cell_folder(folder)
    refuse(found.flaws)
    return found.cell


def read_cell_folder(folder: Path) -> CellRead:
    """Reads `cell.toml` and looks at the URDF beside it; what does not go together is told beside the cell.

    Raises:
        BadCell: cell.toml cannot be read as a cell.
    """
    cell = _parse(folder)
    try:
        _check_urdf(cell)
    except BadInput as flaw:
        return CellRead(cell, (flaw, *flaw.others))
    return CellRead(cell)


def _parse(folder: Path) -> Cell:
    where = str(folder / CELL_FILE)
    text = read_inside(folder, CELL_FILE, BadCell, max_bytes=MAX_CELL_BYTES)
    try:
        content = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise BadCell(where, f"TOML that does not parse ({str(error)[:120]})", "TOML") from error
    try:
        return Cell.model_validate({**content, "folder": folder})
    except ValidationError as error:
        raise together([_sentence(flaw, where) for flaw in error.errors()]) from error


def _check_urdf(cell: Cell) -> None:
    urdf = check_urdf(cell.urdf, str(cell.folder / cell.robot.urdf))
    check_robot(cell, urdf)
    urdf.check_bodies(cell.robot.base_frame, cell.robot.sensor_frame)
    _check_visual_shapes(cell, urdf)
    urdf.check_shapes(cell.robot.base_frame, cell.robot.sensor_frame, cell.robot.visual_shapes)
    urdf.check_meshes(cell.folder)
    where = cell.folder / CELL_FILE
    refuse([BadCell(f"{where}: {key}", found, expected) for key, found, expected, _ in tool_flaws(cell, urdf)])


def _check_visual_shapes(cell: Cell, urdf: Urdf) -> None:
    """Those that the cell names have looks, and nothing else that could count."""
    usable = [body.name for body in urdf.bodies if body.visual and not body.collision]
    for name in cell.robot.visual_shapes:
        if name not in usable:
            where = f"{cell.folder / CELL_FILE}: robot.visual_shapes"
            raise BadCell(where, repr(name), f"a link of {cell.robot.urdf} with a <visual> and without a <collision>, one of {usable}")


def check_robot(cell: Cell, urdf: Urdf) -> None:
    """The cell's robot fits its URDF: frames, a value for each joint, home and velocities within the URDF's limits.

    Raises:
        BadCell: it does not.
        BadRobot: the joints between the two frames are no chain of hinges with limits.
    """
    where = f"{cell.folder / CELL_FILE}: robot"
    robot = cell.robot
    for key in ("base_frame", "sensor_frame"):
        if getattr(robot, key) not in urdf.links:
            raise BadCell(f"{where}.{key}", repr(getattr(robot, key)), f"a link of {robot.urdf}, {list(urdf.links)}")
    for link in (link for pair in robot.adjacent for link in pair):
        if link not in urdf.links:
            raise BadCell(f"{where}.adjacent", repr(link), f"a link of {robot.urdf}, {list(urdf.links)}")
    joints = urdf.hinges(robot.base_frame, robot.sensor_frame)
    for key in ("home_rad", "acceleration_rad_s2", "velocity_rad_s"):
        values = getattr(robot, key)
        if values is not None and len(values) != len(joints):
            raise BadCell(f"{where}.{key}", f"{len(values)} values", f"{len(joints)}, for {[joint.name for joint in joints]}")
    for key, values in robot.friction or ():
        if len(values) != len(joints):
            raise BadCell(f"{where}.friction.{key}", f"{len(values)} values", f"{len(joints)}, for {[joint.name for joint in joints]}")
    for home, joint in zip(robot.home_rad, joints, strict=True):
        if not joint.lower < home < joint.upper:
            raise BadCell(f"{where}.home_rad", f"{home} for {joint.name!r}", f"a position in ({joint.lower}, {joint.upper})")
    for velocity, joint in zip(robot.velocity_rad_s or (), joints, strict=robot.velocity_rad_s is not None):
        if velocity > joint.velocity:
            raise BadCell(f"{where}.velocity_rad_s", f"{velocity} for {joint.name!r}", f"at most the URDF's {joint.velocity}")


def _sentence(error: ErrorDetails, where: str) -> BadCell:
    """One of pydantic's errors as one of ours."""
    flaw = schema_flaw(error)
    if error["type"] == "extra_forbidden":
        for close in difflib.get_close_matches(str(error["loc"][-1]), _keys(), n=1):
            flaw = flaw._replace(expected=f"{close!r}, if that is what was meant")
    elif error["type"] in ("union_tag_not_found", "union_tag_invalid"):
        found = repr(error["input"].get("kind")) if isinstance(error["input"], dict) else flaw.found
        flaw = SchemaFlaw(f"{flaw.key}.kind", found, "box, sphere, capsule or cylinder")
    return BadCell(*flaw.at(where))


def _keys() -> list[str]:
    """Every key of the format."""
    models = (Cell, Robot, Friction, Sensor, Limits, Control, Payload, Tool, Obstacle, Zone, Box, Sphere, Capsule, Cylinder, Pose)
    return sorted({key for model in models for key in model.model_fields} - {"folder"})


def list_cell_folders() -> list[Path]:
    """Folders of the known cells: those in `./cells`, then those that come with the program; a name counts once."""
    known: dict[str, Path] = {}
    for place in (Path("cells"), Path(__file__).parents[2] / "cells"):
        for file in sorted(place.glob(f"*/{CELL_FILE}")):
            known.setdefault(file.parent.name, file.parent)
    return sorted(known.values(), key=lambda folder: folder.name)


def find_cell(name: str | Path) -> Path:
    """Folder of a cell, given by its name (see `list_cells`) or by its path.

    Raises:
        BadCell: there is no such cell.
    """
    path = Path(name)
    if path.name == CELL_FILE and path.is_file():
        return path.parent
    if (path / CELL_FILE).is_file():
        return path
    known = {folder.name: folder for folder in list_cell_folders()}
    if str(name) in known:
        return known[str(name)]
    close = difflib.get_close_matches(str(name), known, n=1)
    hint = f"{close[0]!r}, if that is what was meant" if close else f"one of {list(known)}, or a folder with {CELL_FILE}"
    raise BadCell("cell", repr(str(name)), hint)
