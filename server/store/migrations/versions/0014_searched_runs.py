"""An index with all that runs are searched by: a search reads it alone, and no plan or result of a run that it does not find."""

from __future__ import annotations

from alembic import op

revision = "0014"
down_revision = "0013"

SEARCHED = (
    "cell", "id", "payload", "saved_payload", "state", "outcome", "order_id", "work_order", "serial_number", "requested_by",
    "released_by", "accepted_by", "requested_at", "ended_at",
)  # fmt: skip


def upgrade() -> None:
    """Forward; there is no way back: restore the backup instead."""
    op.create_index("ix_runs_searched", "runs", list(SEARCHED))
