"""The service's log on standard error: for people on a terminal, else one JSON object a line; with the request and the run it is about."""

from __future__ import annotations

import json
import logging
import sys
from datetime import UTC, datetime
from typing import Literal, TextIO

from server.telemetry.request_context import request_id, run_id

LogForm = Literal["auto", "text", "json"]

STANDARD = frozenset(vars(logging.makeLogRecord({}))) | {"message", "asctime", "color_message"}


class JsonLines(logging.Formatter):
    """A record as one line of JSON; what was given as `extra` stands beside the message."""

    def format(self, record: logging.LogRecord) -> str:
        """One line."""
        at = datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds")
        line: dict[str, object] = {"at": at, "level": record.levelname.lower(), "logger": record.name, "message": record.getMessage()}
        line |= {name: value for name, value in (("request_id", request_id.get()), ("run_id", run_id.get())) if value}
        line |= {name: value for name, value in vars(record).items() if name not in STANDARD}
        if record.exc_info:
            line["traceback"] = self.formatException(record.exc_info)
        return json.dumps(line, ensure_ascii=False, default=str)


SENTENCES = {"request": "{method} {route}: {status} after {ms:.0f} ms", "audit": "{audit_action} ({audit_who})"}
"""What is logged most, for people."""
ERRORS = 400


class PlainLines(logging.Formatter):
    """A record as a person reads it: the local time, what happened, and what was given as `extra` behind it."""

    def format(self, record: logging.LogRecord) -> str:
        """One line, and the traceback below it where there is one."""
        at = datetime.fromtimestamp(record.created).astimezone().strftime("%H:%M:%S")
        level = "" if record.levelno <= logging.INFO else f"{record.levelname.lower()}: "
        extra = {name: value for name, value in vars(record).items() if name not in STANDARD}
        message = record.getMessage()
        if message in SENTENCES:
            message, extra = SENTENCES[message].format(**extra), {}
        about = {"run": run_id.get()} if run_id.get() else {}
        more = ", ".join(f"{name} {value}" for name, value in (about | extra).items())
        line = f"{at}  {level}{message}{f'  ({more})' if more else ''}"
        return f"{line}\n{self.formatException(record.exc_info)}" if record.exc_info else line


def is_news(record: logging.LogRecord) -> bool:
    """Whether a person wants to see it: requests that were answered as usual come twice a second from every screen."""
    return record.getMessage() != "request" or vars(record).get("status", 0) >= ERRORS


def start_logging(level: str, form: LogForm, stream: TextIO = sys.stderr) -> None:
    """Sends every log of the process to one place.

    Args:
        form: `auto` is `text` on a terminal and `json` elsewhere.
    """
    plain = form == "text" or (form == "auto" and stream.isatty())
    handler = logging.StreamHandler(stream)
    handler.setFormatter(PlainLines() if plain else JsonLines())
    if plain:
        handler.addFilter(is_news)
    root = logging.getLogger()
    root.handlers[:] = [handler]
    root.setLevel(level.upper())
    for chatty in ("uvicorn.access", "httpx2", "httpcore2", "alembic", *(["uvicorn.error"] if plain else [])):
        logging.getLogger(chatty).setLevel(logging.WARNING)
