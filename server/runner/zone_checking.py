"""Whether a robot can stand at home in a cell: with the bodies of its whole arm, which the service itself does not know."""

from __future__ import annotations

from multiprocessing.connection import Connection

from core.cell.cell import Cell
from core.errors import BadInput, HeftError
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from server.http.flaws import dump_flaws
from server.runner.messages import Answered, Failed
from server.runner.work import give_way


def main(cell: Cell, connection: Connection) -> None:
    """Answers with what the models of planning find wrong, as `server.http.flaws` dumps it."""
    give_way()
    try:
        connection.send(Answered(dump_flaws(_find_flaw(cell))))
    except HeftError as error:
        connection.send(Failed(type(error).__name__, error.message))


def _find_flaw(cell: Cell) -> BadInput | None:
    try:
        CollisionModel(cell, RobotModel.of_cell(cell), cell.payload_box)
    except BadInput as error:
        return error
    return None
