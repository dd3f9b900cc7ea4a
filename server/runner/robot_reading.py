"""Reads the description of a robot of which a cell is to be made: a xacro file is expanded in a process of its own, the rest is done with
limits here."""

from __future__ import annotations

import os
from multiprocessing.connection import Connection
from pathlib import Path

from core.errors import BadInput
from core.new_cell.expansion import description_text
from core.new_cell.frames import outline_robot
from core.new_cell.packages import Packages
from core.new_cell.robot_tree import RobotTree
from server.http.flaws import dump_refusal
from server.runner.confinement import confine
from server.runner.messages import Answered
from server.runner.work import give_way

SECONDS, MEMORY = 30.0, 1_000_000_000


def main(folder: Path, file: str, packages: tuple[str, ...], arguments: dict[str, str], expanded: str, connection: Connection) -> None:
    """Answers with a `RobotOutline`, or with what is wrong (`dump_refusal`).

    Args:
        folder: of the draft; every path is from there.
        file: the description. packages: folders with ROS packages. arguments: of a xacro file.
        expanded: where its URDF is written.
    """
    give_way()
    os.chdir(folder)  # errors name files as the upload does
    try:
        text = description_text(Packages(Path(file), tuple(map(Path, packages))), arguments)
        confine(folder, SECONDS, MEMORY)
        Path(expanded).write_text(text, encoding="utf-8")
        connection.send(Answered(outline_robot(RobotTree(text, file)).model_dump_json()))
    except BadInput as error:
        connection.send(Answered(dump_refusal(error)))
