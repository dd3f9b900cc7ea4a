"""A cell's folder: cell.toml and the URDF read as the untrusted files they are, and held against each other."""

from __future__ import annotations

import difflib
import tomllib
from pathlib import Path
from typing import NamedTuple

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from core.cell.cell import CELL_FILE, MAX_CELL_BYTES, Cell, Control, Friction, Limits, Obstacle, Payload, Robot, Sensor, Zone
from core.cell.contradictions import contradictions
from core.cell.session import (
    DRIVER_NAMES,
    ROBOT_DRIVERS,
    SENSOR_DRIVERS,
    BotaSensor,
    NetFtSensor,
    RobotiqSensor,
    SimulatedRobot,
    UniversalRobot,
    XarmRobot,
)  # fmt: skip
from core.cell.tool import Tool
from core.cell.tool_checks import tool_flaws
from core.cell.urdf import Urdf, check_mesh_file, check_urdf
from core.errors import BadCell, BadInput, refuse, together
from core.files.jail import read_inside
from core.files.schema_flaw import MOST_LETTERS, schema_flaw
from core.payload.calibration import SensorCalibration
from core.payload.shapes import (
    Box,
    Capsule,
    Cylinder,
    Mesh,
    Pose,
    Sphere,
)
from core.payload.site import Site
from core.words.message import Message


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
    return list(contradictions(cell))


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
        raise BadCell(where, "cell-no-toml", reason=str(error)[:120]) from error
    try:
        return Cell.model_validate({**content, "folder": folder})
    except ValidationError as error:
        raise together([_flaw(flaw, where) for flaw in error.errors()]) from error


def _check_urdf(cell: Cell) -> None:
    urdf = check_urdf(cell.urdf, str(cell.folder / cell.robot.urdf))
    check_robot(cell, urdf)
    urdf.check_bodies(cell.robot.base_frame, cell.robot.sensor_frame)
    _check_visual_shapes(cell, urdf)
    urdf.check_shapes(cell.robot.base_frame, cell.robot.sensor_frame, cell.robot.visual_shapes)
    urdf.check_meshes(cell.folder)
    refuse(list(tool_flaws(cell, urdf)))
    for key, mesh in cell.standing_meshes.items():
        check_mesh_file(cell.folder, mesh.file, cell.locate(f"{key}.shape.file"), BadCell)


def _check_visual_shapes(cell: Cell, urdf: Urdf) -> None:
    """Those that the cell names have looks, and nothing else that could count."""
    usable = [body.name for body in urdf.bodies if body.visual and not body.collision]
    for name in cell.robot.visual_shapes:
        if name not in usable:
            where = cell.locate("robot.visual_shapes")
            raise BadCell(where, "cell-no-visual-shape", link=name, urdf=cell.robot.urdf, links=usable, count=len(usable))


def check_robot(cell: Cell, urdf: Urdf) -> None:
    """The cell's robot fits its URDF: frames, a value for each joint, home and velocities within the URDF's limits.

    Raises:
        BadCell: it does not.
        BadRobot: the joints between the two frames are no chain of hinges with limits.
    """
    robot = cell.robot
    named = [("base_frame", robot.base_frame), ("sensor_frame", robot.sensor_frame)]
    for key, link in [*named, *(("adjacent", link) for pair in robot.adjacent for link in pair)]:
        if link not in urdf.links:
            raise BadCell(cell.locate(f"robot.{key}"), "cell-no-such-link", link=link, urdf=robot.urdf, links=urdf.links)
    joints = urdf.hinges(robot.base_frame, robot.sensor_frame)
    names = [joint.name for joint in joints]
    of_joints = {f"robot.{key}": getattr(robot, key) for key in ("home_rad", "acceleration_rad_s2", "velocity_rad_s")}
    of_joints |= {f"robot.friction.{key}": values for key, values in robot.friction or ()}
    for key, values in (of_joints | {"thresholds.joint_torque_nm": cell.thresholds.joint_torque_nm}).items():
        if values is not None and len(values) != len(joints):
            raise BadCell(cell.locate(key), "cell-not-one-for-each-joint", count=len(values), joints=names, joint_count=len(names))
    for home, joint in zip(robot.home_rad, joints, strict=True):
        if not joint.lower < home < joint.upper:
            raise BadCell(
                cell.locate("robot.home_rad"), "cell-home-outside-limits",
                home_rad=home, joint=joint.name, lower_rad=joint.lower, upper_rad=joint.upper,
            )  # fmt: skip
    for velocity, joint in zip(robot.velocity_rad_s or (), joints, strict=robot.velocity_rad_s is not None):
        if velocity > joint.velocity:
            where = cell.locate("robot.velocity_rad_s")
            raise BadCell(where, "cell-velocity-too-high", velocity_rad_s=velocity, joint=joint.name, most_rad_s=joint.velocity)


def _flaw(error: ErrorDetails, where: str) -> BadCell:
    """One of pydantic's errors as one of ours."""
    flaw = schema_flaw(error)
    if error["loc"][:1] == ("session",):
        return _session_flaw(error, where)
    if error["type"] == "extra_forbidden":
        for close in difflib.get_close_matches(str(error["loc"][-1]), _keys(), n=1):
            return BadCell(f"{where}: {flaw.key}", "cell-unknown-key", close=close)
    elif error["type"] == "union_tag_not_found":
        return BadCell(f"{where}: {flaw.key}.kind", "cell-shape-without-kind")
    elif error["type"] == "union_tag_invalid":
        return BadCell(f"{where}: {flaw.key}.kind", "cell-unknown-shape", kind=str(error["ctx"]["tag"])[:MOST_LETTERS])
    return flaw.refusal(BadCell, where)


def _session_flaw(error: ErrorDetails, where: str) -> BadCell:
    """The same of the table [session], whose keys are those of its driver; pydantic has the driver's name among the keys."""
    named = tuple(part for part in error["loc"] if part not in DRIVER_NAMES)
    key = ".".join(str(part) for part in named)
    if error["type"] in {"union_tag_not_found", "union_tag_invalid"}:
        found = str(error["ctx"].get("tag", "-"))[:MOST_LETTERS]
        return BadCell(
            f"{where}: {key}.driver",
            "cell-unknown-driver",
            driver=found,
            drivers=SENSOR_DRIVERS if named[-1] == "sensor" else ROBOT_DRIVERS,
        )
    if error["type"] == "extra_forbidden":
        for close in difflib.get_close_matches(str(named[-1]), _keys(), n=1):
            return BadCell(f"{where}: {key}", "cell-unknown-key", close=close)
    return schema_flaw({**error, "loc": named}).refusal(BadCell, where)


def _keys() -> list[str]:
    """Every key of the format."""
    links = (SimulatedRobot, UniversalRobot, XarmRobot, NetFtSensor, BotaSensor, RobotiqSensor)
    shapes = (Box, Sphere, Capsule, Cylinder, Mesh, Pose)
    models = (Cell, Site, Robot, Friction, Sensor, SensorCalibration, Limits, Control, Payload, Tool, Obstacle, Zone, *shapes, *links)
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
    where = Message.of("cell-argument")
    if close:
        raise BadCell(where, "cell-nearly-named", name=str(name), close=close[0])
    raise BadCell(where, "cell-unknown", name=str(name), known=list(known), file=CELL_FILE)
