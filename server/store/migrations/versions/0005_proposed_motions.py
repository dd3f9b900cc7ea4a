"""A run may make the motion that a diagnosis proposes."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0005"
down_revision = "0004"


def upgrade() -> None:
    """Forward; there is no way back: restore the backup instead."""
    op.add_column("runs", sa.Column("motion", sa.Text, nullable=True))
