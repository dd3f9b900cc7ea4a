"""What is kept of alarms: each from when it was raised until it was over, with who acknowledged it."""

from __future__ import annotations

from datetime import datetime

from sqlalchemy import String, Text
from sqlalchemy.orm import Mapped, mapped_column

from server.store.store import Table


class AlarmRow(Table):
    """One alarm; it is open until it is over and, where its kind stays, acknowledged."""

    __tablename__ = "alarms"

    id: Mapped[str] = mapped_column(String(32), primary_key=True)
    """Sorts by the time of its making."""
    condition: Mapped[str] = mapped_column(String(200), index=True)
    """Key of what it tells of (`server.alarms.kinds.Condition`)."""
    kind: Mapped[str] = mapped_column(String(32))
    cell: Mapped[str | None] = mapped_column(String(64), index=True)
    run: Mapped[str | None] = mapped_column(String(32))
    message: Mapped[str] = mapped_column(Text)
    """JSON (`core.words.message.Message`)."""
    raised_at: Mapped[datetime]
    cleared_at: Mapped[datetime | None]
    acknowledged_by: Mapped[str | None] = mapped_column(String(80))
    acknowledged_at: Mapped[datetime | None]
