"""Why a run did not come through, or why it stands: a kind that every language has words for, and the sentence that says it exactly."""

from __future__ import annotations

from typing import NamedTuple

from core.errors import HeftError, slug
from server.run_tables import JobRow, RunRow
from server.runner.messages import Failed


class Reason(NamedTuple):
    """One of them.

    Args:
        kind: of a problem (`server.problems`), or one of `OWN`.
        sentence: in English, with what was measured against what limit.
    """

    kind: str
    sentence: str


SHUT_DOWN, SERVICE_ENDED, NOT_KEPT = "shut-down", "service-ended", "state-not-kept"
OWN = frozenset({
    "stop-asked", "abort-asked", "hold-asked", "clear-asked", "cancelled", SHUT_DOWN, SERVICE_ENDED, NOT_KEPT,
    "control-process-lost", "planner-lost", "work-lost", "no-room",
})  # fmt: skip
"""Kinds that are no problem of a request."""


def asked(command: str, who: str) -> Reason:
    """Somebody commanded it, by the command's name in the API."""
    return Reason(f"{command}-asked", f"{command} was asked for by {who}.")


def cancelled(who: str) -> Reason:
    """Nobody wants it any more."""
    return Reason("cancelled", f"cancelled by {who}.")


def failed(told: Failed) -> Reason:
    """What a process says."""
    return Reason(slug(told.error), told.message)


def of_error(error: HeftError | OSError) -> Reason:
    """What was refused here, or a folder that could not be written."""
    return Reason("no-room" if isinstance(error, OSError) else slug(type(error).__name__), str(error))


def because(row: RunRow | JobRow, reason: Reason | None) -> None:
    """Notes it; None where it holds no longer."""
    row.reason_kind, row.reason = (None, None) if reason is None else reason
