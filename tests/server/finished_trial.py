"""A blind trial in the store as its job leaves it behind, without the job."""

from __future__ import annotations

from datetime import UTC, datetime

from core.trial.draw import draw
from core.words.message import Message
from server.jobs import jobs
from server.jobs.kinds import TRIALS, TrialsOrder
from server.runner.trial_schemas import SEALS, NamedEffect, OpenedTrial, Seal, TrialsResult
from server.store.store import Store
from tests.server.real_service import RealService

SEED = 8


def finished_trial(service: RealService, sha256: str | None = None) -> str:
    """A trial that is done, as the service keeps it: what was planted is drawn, what the diagnosis said of it is made up."""
    sealed = draw(SEED).sealed
    opened = OpenedTrial(
        seed=SEED, sealed=sealed.model_dump_json(), planted=sealed.in_words, size=sealed.size, verdict="explained", named="base_tilt",
        effects=[NamedEffect(id="base_tilt", probability=0.93, closure=0.99)], none_probability=0.02, unknown_probability=0.05,
        gap_before=3.2, gap_after=1.01, mark=Message.of("trial-not-right"),
    )  # fmt: skip
    store = Store(service.store_url)
    now = datetime.now(UTC)
    with store.write() as db:
        row = jobs.add_job(db, TRIALS, TrialsOrder(count=1, seed=SEED), None, "account:operator", now)
        row.state, row.ended_at = jobs.JobStatus.done, now
        row.told = SEALS.dump_json([Seal(seed=SEED, sha256=sha256 or sealed.hash)]).decode()
        row.result = TrialsResult(opened=[opened], sheet="# Score sheet").model_dump_json()
        return str(row.id)
