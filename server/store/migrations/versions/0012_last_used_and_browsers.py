"""A session keeps which browser it is of, and a key when it was last used: whoever ends one can tell which."""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op

revision = "0012"
down_revision = "0011"


def upgrade() -> None:
    """Forward; there is no way back: restore the backup instead."""
    op.add_column("sessions", sa.Column("browser", sa.String(200), nullable=True))
    op.add_column("api_keys", sa.Column("used_at", sa.DateTime(timezone=True), nullable=True))
