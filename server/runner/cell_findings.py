"""What is wrong or doubtful in cells, as `heft cell check` finds it: with models of planning that the service itself does not know."""

from __future__ import annotations

import json
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from core.errors import HeftError
from core.new_cell.findings import findings_of
from server.runner.messages import Answered
from server.runner.work import give_way


def main(folders: list[Path], connection: Connection) -> None:
    """Answers with the findings of each cell by the name of its folder, as JSON."""
    give_way()
    connection.send(Answered(json.dumps({folder.name: _find(folder) for folder in folders})))


def _find(folder: Path) -> list[dict[str, Any]]:
    """One that cannot be looked at says why."""
    try:
        return [each.model_dump(mode="json") for each in findings_of(folder)]
    except HeftError as error:
        return [{"severity": "wrong", "message": error.message.model_dump(mode="json")}]
