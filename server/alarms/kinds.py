"""The kinds of alarms: how urgent, whether they stay until somebody has acknowledged them, and what a person is to do."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

from core.words.message import Message


class Severity(StrEnum):
    """How soon a person is needed: now, soon, or when there is time."""

    high = "high"
    medium = "medium"
    low = "low"


class Kind(NamedTuple):
    """Of an alarm.

    Args:
        stays: whether it is shown until somebody has acknowledged it, also when what it tells of is over.
        ends: whether acknowledging it ends it: it tells of something that happened, not of something that lasts.
        advice: code of the message that says what to do.
    """

    severity: Severity
    advice: str
    stays: bool = False
    ends: bool = False


KINDS: dict[str, Kind] = {
    "run_aborted": Kind(Severity.high, "alarms-run-aborted-do", stays=True),
    "sensor_lost": Kind(Severity.high, "alarms-sensor-lost-do", stays=True),
    "robot_lost": Kind(Severity.high, "alarms-robot-lost-do", stays=True),
    "run_held": Kind(Severity.medium, "alarms-run-held-do"),
    "run_blocked": Kind(Severity.medium, "alarms-run-blocked-do"),
    "run_stopped": Kind(Severity.low, "alarms-run-stopped-do", stays=True, ends=True),
    "order_waits": Kind(Severity.low, "alarms-order-waits-do"),
    "store_away": Kind(Severity.high, "alarms-store-away-do"),
    "disk_full": Kind(Severity.high, "alarms-disk-full-do"),
    "disk_nearly_full": Kind(Severity.medium, "alarms-disk-nearly-full-do"),
    "webhook_failing": Kind(Severity.medium, "alarms-webhook-failing-do", stays=True),
    "cell_flawed": Kind(Severity.medium, "alarms-cell-flawed-do"),
}


@dataclass(frozen=True)
class Condition:
    """Something that needs a person, as it is now.

    Args:
        kind: one of `KINDS`.
        about: tells two conditions of one kind apart: a run, a webhook, a cell.
        message: what there is to say.
        cell, run: where it belongs to one.
    """

    kind: str
    about: str
    message: Message
    cell: str | None = None
    run: str | None = None

    @property
    def key(self) -> str:
        """The same for the same condition, whenever it is looked at."""
        return f"{self.kind}:{self.about}"
