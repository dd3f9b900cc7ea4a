"""Of a protected zone the place before its latest one is kept: the way back from a wrong move."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0008"
down_revision = "0007"


def upgrade() -> None:
    """Forward; there is no way back: restore the backup instead."""
    op.add_column("zone_positions", sa.Column("previous", sa.Text(), nullable=True))
