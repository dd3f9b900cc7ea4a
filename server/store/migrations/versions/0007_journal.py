"""A run has a journal that the database follows, keeps what was late, and counts the steps that it has finished."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0007"
down_revision = "0006"


def upgrade() -> None:
    """Forward; there is no way back: restore the backup instead."""
    op.add_column("runs", sa.Column("journaled", sa.Integer, nullable=False, server_default="0"))
    op.add_column("runs", sa.Column("steps", sa.Integer, nullable=False, server_default="0"))
    op.add_column("runs", sa.Column("finished_steps", sa.Integer, nullable=False, server_default="0"))
    op.add_column("runs", sa.Column("lateness", sa.Text, nullable=True))
    op.add_column("runs", sa.Column("held_since", sa.DateTime(timezone=True), nullable=True))
