"""Whether a robot can stand at home in a cell: with the bodies of its whole arm, which the service itself does not know."""

from __future__ import annotations

import json
from multiprocessing.connection import Connection

from core.cell.cell import Cell
from core.errors import BadInput, HeftError
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from server.runner.messages import Answered, Failed
from server.runner.work import give_way


def main(cell: Cell, connection: Connection) -> None:
    """Answers with what the models of planning find wrong, as JSON: where, found, expected of each flaw."""
    give_way()
    try:
        connection.send(Answered(json.dumps(_flaws(cell))))
    except HeftError as error:
        connection.send(Failed(type(error).__name__, str(error)))


def _flaws(cell: Cell) -> list[tuple[str, str, str]]:
    try:
        CollisionModel(cell, RobotModel.of_cell(cell), cell.payload_box)
    except BadInput as error:
        return [(each.where, each.found, each.expected) for each in (error, *error.others)]
    return []
