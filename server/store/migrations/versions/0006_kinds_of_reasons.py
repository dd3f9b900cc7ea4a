"""The reason of a run or a job has a kind, for which every language has words."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0006"
down_revision = "0005"


def upgrade() -> None:
    """Forward; there is no way back: restore the backup instead."""
    for table in ("runs", "jobs"):
        op.add_column(table, sa.Column("reason_kind", sa.String(32), nullable=True))
