"""What every job of the API has in common: how far it is, who asked for it, where to ask again."""

from __future__ import annotations

from datetime import datetime
from typing import Any, Self

from pydantic import Field

from core.words.message import Message
from server.http.schemas import Answer
from server.jobs.jobs import JobStatus, Worker
from server.runs.reason import read_reason
from server.runs.tables import JobRow


class JobPublic(Answer):
    """A job as it stands now."""

    state: JobStatus = Field(description="How far it is.")
    progress: float = Field(description="Share that is done, 0 to 1.", examples=[0.4])
    reason: Message | None = Field(description="Why it failed or was cancelled; null where it did not.")
    reason_kind: str | None = Field(description="Kind of `reason`, see docs/runs.md.", examples=["cancelled"])
    requested_by: str = Field(description="Who asked for it.", examples=["account:anna"])
    requested_at: datetime = Field(description="When it was asked for.", examples=["2026-03-01T09:00:00Z"])
    ended_at: datetime | None = Field(description="When it ended; null before.", examples=["2026-03-01T09:00:24Z"])

    @classmethod
    def of(cls, row: JobRow, worker: Worker, **own: Any) -> Self:
        """The job of a row with the fields that its kind has of its own.

        Args:
            worker: that works through the jobs of this kind.
        """
        return cls(
            state=JobStatus(row.state),
            progress=1.0 if row.state == JobStatus.done else worker.progress.get(row.id, 0.0),
            reason=read_reason(row),
            reason_kind=row.reason_kind,
            requested_by=row.requested_by,
            requested_at=row.requested_at,
            ended_at=row.ended_at,
            **own,
        )
