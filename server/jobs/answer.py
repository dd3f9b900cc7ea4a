"""What every job of the API has in common: how far it is, who asked for it, where to ask again."""

from __future__ import annotations

from datetime import datetime
from typing import Any, Self

from core.words.message import Message
from server.http.schemas import Answer
from server.jobs.jobs import JobStatus, Worker
from server.runs.reason import read_reason
from server.runs.tables import JobRow


class JobAnswer(Answer):
    """A job as it stands now.

    Args:
        progress: 0 to 1.
        reason: why it failed or was cancelled; `reason_kind` is the kind of it, see docs/runs.md.
    """

    state: JobStatus
    progress: float
    reason: Message | None
    reason_kind: str | None
    requested_by: str
    requested_at: datetime
    ended_at: datetime | None

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
