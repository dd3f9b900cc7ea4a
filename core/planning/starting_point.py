"""Where a plan begins, as a person says it: joint positions, or a file that knows where the robot stands."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from pydantic import BaseModel, ConfigDict, ValidationError

from core.array import Array
from core.cell.cell import Cell
from core.errors import BadInput
from core.files.schema_flaw import schema_flaw
from core.recording.folder import read_recording
from core.recording.recording import check_same_robot
from core.robot.model import RobotModel

OPTION = "--from"
MAX_BYTES = 100_000


class RobotStands(BaseModel):
    """A file that says where a robot stands; what else stands in it does not matter."""

    model_config = ConfigDict(allow_inf_nan=False, strict=True)

    q_rad: list[float]


def starting_point(text: str | None, cell: Cell, robot: RobotModel) -> Array:
    """(n,), rad; home where nothing is said. Whether the robot may be there is for planning to say.

    Args:
        text: joint positions with commas between them, the folder of a recording of this robot (its last position), or a JSON file with
            `q_rad`.

    Raises:
        BadInput: none of these, or not as many positions as there are joints.
    """
    if text is None:
        return np.array(cell.robot.home_rad)
    if not text.strip():
        raise BadInput(OPTION, "planning-start-empty")
    path = Path(text)
    q = _numbers(text)
    if q is None:
        q = _last_of(path, cell, robot) if path.is_dir() else _read(path)
    if len(q) != robot.n or not np.isfinite(q).all():
        raise BadInput(OPTION, "planning-start-joints", q_rad=q.tolist(), count=robot.n, joints=robot.description.joints)
    return q


def _numbers(text: str) -> Array | None:
    """What is written as numbers; None where it is the name of something."""
    try:
        return np.array([float(each) for each in text.split(",")])
    except ValueError:
        return None


def _last_of(folder: Path, cell: Cell, robot: RobotModel) -> Array:
    """Where a recording of this robot ends: the last position that was commanded, or measured where no command was recorded."""
    recording = read_recording(folder)
    check_same_robot(recording, robot.description, cell.gravity_in_base)
    q = recording.q if recording.q_cmd is None else recording.q_cmd
    if q is None:
        raise BadInput(f"{OPTION} {folder}", "planning-start-recording-without-joints")
    return np.array(q[-1])


def _read(file: Path) -> Array:
    try:
        if file.stat().st_size > MAX_BYTES:
            raise BadInput(f"{OPTION} {file}", "planning-start-file-too-long", most_bytes=MAX_BYTES)
        return np.array(RobotStands.model_validate(json.loads(file.read_text(encoding="utf-8"))).q_rad)
    except (OSError, UnicodeDecodeError) as error:
        raise BadInput(OPTION, "planning-start-unreadable", text=str(file)) from error
    except (json.JSONDecodeError, RecursionError) as error:
        raise BadInput(f"{OPTION} {file}", "planning-start-no-json") from error
    except ValidationError as error:
        raise schema_flaw(error.errors()[0]).refusal(BadInput, f"{OPTION} {file}") from error
