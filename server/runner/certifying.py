"""The certificate of a run: its statement of conformity takes a model of the robot, which the service itself does not know."""

from __future__ import annotations

from base64 import b64encode
from multiprocessing.connection import Connection
from pathlib import Path

from core.cell.cell import Cell
from core.certificate.certificate import dump_certificate
from core.certificate.issue import issue_certificate
from core.certificate.page import render_certificate
from core.errors import HeftError
from core.estimation.result import Result
from core.report.record import Record
from core.words.catalogue import Language
from server.runner.messages import Answered, Failed
from server.runner.work import give_way


def main(result: Result, record: Record, recording: Path, cell: Cell | None, language: Language | None, connection: Connection) -> None:
    """Answers with the page in a language, or where none is named with the JSON, in base 64."""
    give_way()
    try:
        found = issue_certificate(result, record, recording, cell)
        content = dump_certificate(found) if language is None else render_certificate(found, language)
        connection.send(Answered(b64encode(content).decode()))
    except HeftError as error:
        connection.send(Failed(type(error).__name__, error.message))
