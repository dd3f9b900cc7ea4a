"""Why a run did not come through, or why it stands: a kind for programs, and a message that says it exactly."""

from __future__ import annotations

from typing import NamedTuple

from core.errors import Cause, ControlLost, HeftError, Lateness, slug
from core.words.message import Message
from server.runner.messages import Failed
from server.runs.tables import JobRow, RunRow


class Reason(NamedTuple):
    """One of them.

    Args:
        kind: of a problem (`server.http.problems`), or one of `OWN`.
        message: with what was measured against what limit.
    """

    kind: str
    message: Message


CANCELLED, SHUT_DOWN, SERVICE_ENDED, NO_ROOM, NOT_KEPT = "cancelled", "shut-down", "service-ended", "no-room", "release-not-kept"
LATE: dict[Cause, str] = {cause: f"{cause.replace('_', '-')}-late" for cause in Cause if cause not in (Cause.SENSOR, Cause.ROBOT)}
"""What put a run on hold, by what was late; sensor and robot have errors of their own."""
OWN = frozenset({
    "stop-asked", "abort-asked", "hold-asked", "clear-asked", CANCELLED, SHUT_DOWN, SERVICE_ENDED, NO_ROOM,
    "control-process-lost", "planner-lost", "work-lost", NOT_KEPT, *LATE.values(),
})  # fmt: skip
"""Kinds that are no problem of a request."""


def explain_command(command: str, who: str) -> Reason:
    """Somebody commanded it, by the command's name in the API."""
    return Reason(f"{command}-asked", Message.of("runs-command-asked", command=str(command), who=who))


def explain_stop_of_nobody(address: str) -> Reason:
    """Somebody stopped it who was not signed in."""
    return Reason("stop-asked", Message.of("runs-stopped-by-nobody", address=address))


def explain_cancellation(who: str, why: str | None = None) -> Reason:
    """Nobody wants it any more; `why` is what they say."""
    if why:
        return Reason(CANCELLED, Message.of("runs-cancelled-because", who=who, why=why))
    return Reason(CANCELLED, Message.of("runs-cancelled", who=who))


def explain_failure(failure: Failed) -> Reason:
    """What a process says."""
    return Reason(find_reason_kind(failure.error, failure.lateness), failure.message)


def find_reason_kind(error: str, lateness: Lateness | None) -> str:
    """The kind of an error of the engine, by its name; where control was lost, by what was late."""
    if error == ControlLost.__name__ and lateness is not None:
        return LATE[lateness.cause]
    return slug(error)


def explain_error(error: HeftError | OSError) -> Reason:
    """What was refused here, or a folder that could not be made."""
    if isinstance(error, OSError):
        return Reason(NO_ROOM, Message.of("runs-folder-not-made", reason=error.strerror or ""))
    return Reason(slug(type(error).__name__), error.message)


def set_reason(row: RunRow | JobRow, reason: Reason | None) -> None:
    """Notes it; None where it holds no longer."""
    row.reason_kind, row.reason = (None, None) if reason is None else (reason.kind, dump_message(reason.message))


def read_reason(row: RunRow | JobRow) -> Message | None:
    """The message that was noted."""
    return None if row.reason is None else Message.model_validate_json(row.reason)


def dump_message(message: Message) -> str:
    """As the store keeps it: its words are made anew where somebody reads it."""
    return message.model_dump_json(exclude={"text"})
