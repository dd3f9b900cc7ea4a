"""What an uploaded recording says of itself before anybody diagnoses it: one of another robot has no place beside a cell's twin."""

from __future__ import annotations

from pathlib import Path

from core.cell.cell import Cell
from core.cell.kinematics import is_same_robot, joint_axes
from core.cell.urdf_elements import MAX_BYTES as MAX_URDF_BYTES
from core.errors import BadRecording
from core.files.jail import read_inside
from core.gap.addition import find_axes
from core.recording.manifest import read_manifest
from server.http.errors import Unprocessable


def check_made_in(folder: Path, cell: Cell) -> str | None:
    """A recording may have been made in a cell, as far as it says where and with what robot; answers what the robot carried.

    Raises:
        BadRecording, BadRobot: it cannot be read.
        Unprocessable: it names another cell, or its robot is another one.
    """
    manifest = read_manifest(folder)
    if manifest.cell is not None and manifest.cell != cell.name:
        raise Unprocessable("jobs-upload-of-other-cell", found=manifest.cell, cell=cell.name)
    robot = manifest.robot
    if robot is not None:
        text = read_inside(folder, robot.urdf, BadRecording, max_bytes=MAX_URDF_BYTES)
        if not is_same_robot(joint_axes(text, robot.joints, robot.base_frame, robot.urdf), find_axes(cell)):
            raise Unprocessable("jobs-upload-of-other-robot", cell=cell.name)
    return manifest.payload
