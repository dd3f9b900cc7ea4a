"""How much room the links take that a cell's tools are made of: by shapes and meshes, which the service itself does not know."""

from __future__ import annotations

import json
from multiprocessing.connection import Connection

import numpy as np

from core.cell.cell import Box, Cell, Pose
from core.errors import HeftError
from core.robot.bodies import link_bodies
from core.robot.model import RobotModel
from server.runner.messages import Answered, Failed
from server.runner.work import give_way


def main(cell: Cell, connection: Connection) -> None:
    """Answers with a list of boxes for each tool that is made of links, by its name, as JSON."""
    give_way()
    try:
        connection.send(Answered(json.dumps(_find_boxes(cell))))
    except HeftError as error:
        connection.send(Failed(type(error).__name__, error.message))


def _find_boxes(cell: Cell) -> dict[str, list[object]]:
    robot = RobotModel.of_cell(cell)
    frame = robot.model.frames[robot.sensor_frame_id].placement
    found: dict[str, list[object]] = {name: [] for name, tool in cell.tools.items() if tool.links is not None}
    owner = {link: name for name, tool in cell.tools.items() for link in tool.links or ()}
    for body in link_bodies(cell, robot):
        if body.name in owner:
            corners = np.array([frame.actInv(corner) for corner in body.corners])
            found[owner[body.name]].append(_box_around(corners.min(axis=0), corners.max(axis=0)).model_dump(mode="json"))
    return found


def _box_around(low: np.ndarray, high: np.ndarray) -> Box:
    """Along the axes of the sensor frame."""
    size = np.maximum(high - low, 1e-4).round(4).tolist()
    centre = (0.5 * (low + high)).round(4).tolist()
    return Box(size_m=(size[0], size[1], size[2]), pose=Pose(xyz_m=(centre[0], centre[1], centre[2])))
