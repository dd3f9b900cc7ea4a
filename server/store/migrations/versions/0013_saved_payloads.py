"""The tool library: payloads that people save for a cell; a run knows which of them it carries, and what was known of it then."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0013"
down_revision = "0012"


def upgrade() -> None:
    """Forward; there is no way back: restore the backup instead."""
    op.create_table(
        "saved_payloads",
        sa.Column("id", sa.String(32), primary_key=True),
        sa.Column("cell", sa.String(64), nullable=False, index=True),
        sa.Column("name", sa.String(64), nullable=False),
        sa.Column("title", sa.String(200), nullable=False),
        sa.Column("note", sa.Text, nullable=True),
        sa.Column("box", sa.Text, nullable=False),
        sa.Column("mass_least_kg", sa.Double, nullable=True),
        sa.Column("mass_most_kg", sa.Double, nullable=True),
        sa.Column("reference", sa.Text, nullable=True),
        sa.Column("saved_by", sa.String(80), nullable=False),
        sa.Column("saved_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("changed_by", sa.String(80), nullable=True),
        sa.Column("changed_at", sa.DateTime(timezone=True), nullable=True),
        sa.UniqueConstraint("cell", "name", name="uq_saved_payloads_cell"),
    )
    op.add_column("runs", sa.Column("saved_payload", sa.String(32), nullable=True))
    op.add_column("runs", sa.Column("known_payload", sa.Text, nullable=True))
    op.create_index("ix_runs_saved_payload", "runs", ["saved_payload"])
