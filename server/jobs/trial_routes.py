"""Blind trials of the diagnosis, as jobs: what was planted is sealed before they begin and opened when all are done."""

from __future__ import annotations

from fastapi import APIRouter, Response
from pydantic import Field
from starlette.status import HTTP_202_ACCEPTED

from core.words.catalogue import Language
from server.http.dependencies import NowDep, StoreDep, set_accepted_headers
from server.http.parameters import LanguageQuery, LimitQuery, TrialsPath
from server.http.schemas import RequestBody
from server.jobs import jobs
from server.jobs.answer import JobPublic
from server.jobs.jobs import TrialsDep, Worker
from server.jobs.kinds import TRIALS, TrialsOrder
from server.people import audit
from server.people.auth import CallerDep
from server.runner.trial_schemas import SEALS, OpenedTrial, Seal, TrialsResult
from server.runs.tables import JobRow

router = APIRouter(prefix="/api/trials", tags=["trials"])

TYPICAL_S = 60


class TrialsCreate(RequestBody):
    """So many trials, with the seeds from `seed` on."""

    count: int = Field(default=1, ge=1, le=1000, description="How many trials.", examples=[10])
    seed: int = Field(default=0, ge=0, lt=2**31, description="Seed of the first; each further one has the next.", examples=[0])


class TrialsPublic(JobPublic):
    """Some trials."""

    trials: str = Field(description="Identifier of the job; sorts by the time of its making.", examples=["019ab1c2f7b2a6e01d5c33"])
    count: int = Field(description="How many trials.", examples=[10])
    seed: int = Field(description="Seed of the first.", examples=[0])
    seals: list[Seal] | None = Field(
        description="SHA-256 of what is planted in each, from the moment it is drawn; null before, and in lists."
    )
    opened: list[OpenedTrial] | None = Field(
        description="What was planted and what the diagnosis said of it; null until all are done, and in lists."
    )
    sheet: str | None = Field(description="The score sheet (Markdown); null until all are done, and in lists.", examples=["# Blind trials"])


@router.post("", status_code=HTTP_202_ACCEPTED)
def queue_trials(
    body: TrialsCreate, response: Response, store: StoreDep, worker: TrialsDep, caller: CallerDep, now: NowDep
) -> TrialsPublic:
    """Queues blind trials; they run one after the other on one core, and give way to robots."""
    with store.write() as db:
        row = jobs.add_job(db, TRIALS, TrialsOrder(count=body.count, seed=body.seed), None, caller.who, now)
        audit.record(db, caller.who, "trials.queue", {"trials": row.id, "count": body.count, "seed": body.seed}, now=now)
        found = _answer(worker, row)
    worker.wake()
    set_accepted_headers(response, f"/api/trials/{found.trials}", TYPICAL_S)
    return found


@router.get("")
def list_trials(store: StoreDep, worker: TrialsDep, limit: LimitQuery = 50) -> list[TrialsPublic]:
    """Newest first, without their answers."""
    with store.read() as db:
        return [_answer(worker, row, whole=False) for row in jobs.list_jobs(db, TRIALS, limit)]


@router.get("/{trials}")
def read_trials(trials: TrialsPath, store: StoreDep, worker: TrialsDep, language: LanguageQuery = "en") -> TrialsPublic:
    """Some trials: their seals, and in the end their answers; the score sheet in a language."""
    with store.read() as db:
        return _answer(worker, jobs.load_job(db, TRIALS, trials), language=language)


@router.delete("/{trials}")
def cancel_trials(trials: TrialsPath, store: StoreDep, worker: TrialsDep, caller: CallerDep, now: NowDep) -> TrialsPublic:
    """Ends trials that wait or run; what they have planted stays sealed."""
    with store.write() as db:
        row = jobs.cancel(db, TRIALS, trials, caller.who, now)
        audit.record(db, caller.who, "trials.cancel", {"trials": trials}, now=now)
        found = _answer(worker, row)
    worker.drop(trials)
    return found


def _answer(worker: Worker, row: JobRow, *, whole: bool = True, language: Language = "en") -> TrialsPublic:
    order = TrialsOrder.model_validate_json(row.order)
    result = TrialsResult.model_validate_json(row.result) if whole and row.result is not None else None
    return TrialsPublic.of(
        row,
        worker,
        trials=row.id,
        count=order.count,
        seed=order.seed,
        seals=SEALS.validate_json(row.told) if whole and row.told is not None else None,
        opened=None if result is None else result.opened,
        sheet=None if result is None else result.sheets.get(language, result.sheet),
    )
