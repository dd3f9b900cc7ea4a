"""Diagnoses become one kind of job among others."""

from __future__ import annotations

import json

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"

MOMENT = sa.DateTime(timezone=True)
KEPT = ("id", "state", "result", "reason", "requested_by", "requested_at", "ended_at")


def upgrade() -> None:
    """Forward; there is no way back: restore the backup instead."""
    jobs = op.create_table(
        "jobs",
        sa.Column("id", sa.String(32), primary_key=True),
        sa.Column("kind", sa.String(16), nullable=False, index=True),
        sa.Column("about", sa.String(64), nullable=True, index=True),
        sa.Column("job_order", sa.Text(), nullable=False),
        sa.Column("state", sa.String(16), nullable=False, index=True),
        sa.Column("told", sa.Text(), nullable=True),
        sa.Column("result", sa.Text(), nullable=True),
        sa.Column("reason", sa.Text(), nullable=True),
        sa.Column("requested_by", sa.String(80), nullable=False),
        sa.Column("requested_at", MOMENT, nullable=False),
        sa.Column("ended_at", MOMENT, nullable=True),
    )
    _move(jobs)
    op.drop_table("diagnoses")


def _move(jobs: sa.Table) -> None:
    columns = [sa.column(name, MOMENT) if name.endswith("_at") else sa.column(name) for name in (*KEPT, "recording", "run")]
    connection = op.get_bind()
    for row in connection.execute(sa.select(*columns).select_from(sa.table("diagnoses"))).mappings().all():
        kept = {name: row[name] for name in KEPT}
        order = json.dumps({"recording": row["recording"], "run": row["run"]})
        connection.execute(jobs.insert().values(**kept, kind="diagnosis", about=row["run"], job_order=order))
