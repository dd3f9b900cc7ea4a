"""Blind trials of the diagnosis, as jobs: what was planted is sealed before they begin and opened when all are done."""

from __future__ import annotations

from fastapi import APIRouter, Response
from pydantic import Field
from starlette.status import HTTP_202_ACCEPTED

from server import audit, jobs
from server.dependencies import Asking, Here, Now, Stored
from server.job_answer import JobAnswer, Limit, accepted
from server.job_kinds import TRIALS, TrialsOrder
from server.run_tables import JobRow
from server.schemas import Body
from server.service import Service
from server.trial_schemas import SEALS, OpenedTrial, Seal, TrialsResult

router = APIRouter(prefix="/api/trials", tags=["trials"])

TYPICAL_S = 60


class TrialsBody(Body):
    """So many trials, with the seeds from `seed` on."""

    count: int = Field(1, ge=1, le=1000)
    seed: int = Field(0, ge=0, lt=2**31)


class TrialsAnswer(JobAnswer):
    """Some trials.

    Args:
        seals: SHA-256 of what is planted in each, from the moment it is drawn; null before. The audit log has the SHA-256 of them all.
        opened, sheet: what was planted and what the diagnosis said of it, and the score sheet (Markdown); null until all are done.
    """

    trials: str
    count: int
    seed: int
    seals: list[Seal] | None
    opened: list[OpenedTrial] | None
    sheet: str | None


@router.post("", status_code=HTTP_202_ACCEPTED)
def queue_trials(body: TrialsBody, response: Response, here: Here, asking: Asking, now: Now) -> TrialsAnswer:
    """Queues blind trials; they run one after the other on one core, and give way to robots."""
    with here.store.write() as db:
        row = jobs.queue(db, TRIALS, TrialsOrder(count=body.count, seed=body.seed), None, asking.who, now)
        audit.record(db, asking.who, "trials.queue", {"trials": row.id, "count": body.count, "seed": body.seed}, now=now)
        found = _answer(here, row)
    here.trials.wake()
    accepted(response, f"/api/trials/{found.trials}", TYPICAL_S)
    return found


@router.get("")
def list_trials(here: Here, limit: Limit = 50) -> list[TrialsAnswer]:
    """Newest first, without their answers."""
    with here.store.read() as db:
        return [_answer(here, row, whole=False) for row in jobs.listed(db, TRIALS, limit)]


@router.get("/{trials}")
def read_trials(trials: str, here: Here, store: Stored) -> TrialsAnswer:
    """Some trials: their seals, and in the end their answers."""
    with store.read() as db:
        return _answer(here, jobs.load(db, TRIALS, trials))


@router.delete("/{trials}")
def cancel_trials(trials: str, here: Here, asking: Asking, now: Now) -> TrialsAnswer:
    """Ends trials that wait or run; what they have planted stays sealed."""
    with here.store.write() as db:
        row = jobs.cancel(db, TRIALS, trials, asking.who, now)
        audit.record(db, asking.who, "trials.cancel", {"trials": trials}, now=now)
        found = _answer(here, row)
    here.trials.drop(trials)
    return found


def _answer(here: Service, row: JobRow, *, whole: bool = True) -> TrialsAnswer:
    order = TrialsOrder.model_validate_json(row.order)
    result = TrialsResult.model_validate_json(row.result) if whole and row.result is not None else None
    return TrialsAnswer.of(
        row,
        here.trials,
        trials=row.id,
        count=order.count,
        seed=order.seed,
        seals=SEALS.validate_json(row.told) if whole and row.told is not None else None,
        opened=None if result is None else result.opened,
        sheet=None if result is None else result.sheet,
    )
