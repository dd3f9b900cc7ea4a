"""A run knows its payload by name, and who accepted its result."""

from __future__ import annotations

import json

import sqlalchemy as sa
from alembic import op

revision = "0004"
down_revision = "0003"


def upgrade() -> None:
    """Forward; there is no way back: restore the backup instead."""
    op.add_column("runs", sa.Column("payload", sa.String(64), nullable=True))
    op.add_column("runs", sa.Column("accepted_by", sa.String(80), nullable=True))
    op.add_column("runs", sa.Column("accepted_at", sa.DateTime(timezone=True), nullable=True))
    op.create_index("ix_runs_payload", "runs", ["payload"])
    _name_payloads()


def _name_payloads() -> None:
    """As the result has it, else as it was ordered; a run that never had a result may not have named one."""
    runs = sa.table("runs", sa.column("id"), sa.column("run_order"), sa.column("result"), sa.column("payload"))
    connection = op.get_bind()
    for row in connection.execute(sa.select(runs)).mappings().all():
        known = json.loads(row["result"] or row["run_order"])["payload"]
        connection.execute(runs.update().where(runs.c.id == row["id"]).values(payload=known))
