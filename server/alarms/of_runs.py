"""What of the runs needs a person: what stands, waits or has failed."""

from __future__ import annotations

from collections.abc import Iterable

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from core.errors import BadState, RobotStateLate, SensorFrozen, slug
from core.words.message import Message
from server.alarms.kinds import Condition
from server.runs import ledger as run_ledger
from server.runs.packml import State
from server.runs.reason import read_reason
from server.runs.tables import RunRow

SENSOR, ROBOT = ({slug(error.__name__) for error in errors} for errors in ((SensorFrozen,), (RobotStateLate, BadState)))
"""Kinds of reasons that are the sensor's or the robot's."""
ENDED = Message.of("runs-ended")


def find_waiting(db: Session) -> list[RunRow]:
    """Runs that may need a person: the first of each cell that is not over, and the last one that moved where it was stopped."""
    moved_last = select(func.max(RunRow.id)).where(RunRow.released).group_by(RunRow.cell)
    stopped = db.scalars(select(RunRow).where(RunRow.id.in_(moved_last), RunRow.state == State.STOPPED))
    return [run_ledger.copy_row(row) for row in (*run_ledger.list_first_runs(db), *stopped)]


def judge_runs(rows: Iterable[RunRow]) -> list[Condition]:
    """What there is to say of them."""
    return [found for row in rows if (found := _judge(row)) is not None]


def _judge(row: RunRow) -> Condition | None:
    cause = read_reason(row) or ENDED
    match State(row.state):
        case State.ABORTED | State.ABORTING:
            return _judge_aborted(row, cause)
        case State.STOPPED if row.released and not row.aborted:
            return _about(row, "run_stopped", Message.of("alarms-run-stopped", cause=cause))
        case State.HELD:
            return _about(row, "run_held", Message.of("alarms-run-held", cause=cause))
        case State.SUSPENDED:
            return _about(row, "run_blocked", Message.of("alarms-run-blocked", in_the_way=row.in_the_way or "?"))
        case State.IDLE if row.requested_by.startswith("key:"):
            return _about(row, "order_waits", Message.of("alarms-order-waits", sender=row.requested_by.removeprefix("key:")))
    return None


def _judge_aborted(row: RunRow, cause: Message) -> Condition:
    if row.reason_kind in SENSOR:
        return _about(row, "sensor_lost", Message.of("alarms-sensor-lost", cause=cause))
    if row.reason_kind in ROBOT:
        return _about(row, "robot_lost", Message.of("alarms-robot-lost", cause=cause))
    return _about(row, "run_aborted", Message.of("alarms-run-aborted", cause=cause))


def _about(row: RunRow, kind: str, message: Message) -> Condition:
    return Condition(kind, row.id, message, row.cell, row.id)
