"""A run knows by which order it was asked for, and how it ended."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0011"
down_revision = "0010"

REFERENCES = ("order_id", "work_order", "serial_number")


def upgrade() -> None:
    """Forward; there is no way back: restore the backup instead."""
    for name in REFERENCES:
        op.add_column("runs", sa.Column(name, sa.String(100), nullable=True))
        op.create_index(f"ix_runs_{name}", "runs", [name])
    op.add_column("runs", sa.Column("outcome", sa.String(16), nullable=True))
    op.create_index("ix_runs_outcome", "runs", ["outcome"])
    _find_outcomes()


def _find_outcomes() -> None:
    """Of runs that are over, as the ledger does for new ones; an aborted run that was cleared since is Stopped, but was released."""
    runs = sa.table("runs", *(sa.column(name) for name in ("state", "outcome", "reason_kind", "aborted", "released", "ended_at")))
    over = runs.update().where(runs.c.ended_at.is_not(None), runs.c.outcome.is_(None))
    released = runs.c.released.is_(sa.true())
    for outcome, where in (
        ("completed", runs.c.state == "Complete"),
        ("aborted", sa.or_(runs.c.state.in_(("Aborted", "Clearing")), runs.c.reason_kind == "abort-asked")),
        ("cancelled", runs.c.reason_kind == "cancelled"),
        ("aborted", sa.and_(runs.c.aborted.is_(sa.true()), released)),
        ("refused", runs.c.aborted.is_(sa.true())),
        ("stopped", sa.true()),
    ):
        op.execute(over.where(where).values(outcome=outcome))
