"""On a terminal the log is for people, elsewhere for programs; either way it says the same."""

from __future__ import annotations

import io
import json
import logging
from collections.abc import Iterator
from typing import Any

import pytest

from server.telemetry.logs import LogForm, start_logging
from server.telemetry.request_context import run_id


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.fixture(autouse=True)
def as_it_was() -> Iterator[None]:
    root = logging.getLogger()
    handlers, level = list(root.handlers), root.level
    yield
    root.handlers[:] = handlers
    root.setLevel(level)


def log_to(stream: io.StringIO, form: LogForm, message: str, level: int = logging.INFO, **extra: Any) -> str:
    start_logging("info", form, stream)
    logging.getLogger("heft.tests").log(level, message, extra=extra)
    return stream.getvalue()


def test_a_terminal_gets_sentences_and_a_pipe_gets_json_unless_asked_otherwise() -> None:
    answered = {"method": "GET", "route": "/api/cells", "status": 401, "ms": 5.06}
    assert log_to(Terminal(), "auto", "request", **answered).endswith("GET /api/cells: 401 after 5 ms\n")
    assert json.loads(log_to(io.StringIO(), "auto", "request", **answered))["route"] == "/api/cells"
    assert json.loads(log_to(Terminal(), "json", "request", **answered))["status"] == 401
    assert log_to(io.StringIO(), "text", "audit", audit_action="run.release", audit_who="eva", audit_hash="ab", audit_number=3).endswith(
        "run.release (eva)\n"
    )


def test_a_person_is_not_told_of_every_request_that_was_answered_as_usual() -> None:
    answered = {"method": "GET", "route": "/api/now", "status": 200, "ms": 1.0}
    assert log_to(Terminal(), "auto", "request", **answered) == ""
    assert log_to(io.StringIO(), "auto", "request", **answered) != ""


def test_a_warning_is_called_one_with_its_run_and_what_came_with_it() -> None:
    token = run_id.set("run-7")
    try:
        said = log_to(Terminal(), "auto", "the disk is nearly full", logging.WARNING, free_mb=12)
    finally:
        run_id.reset(token)
    assert said.endswith("warning: the disk is nearly full  (run run-7, free_mb 12)\n")
