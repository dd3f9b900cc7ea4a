"""Brings the tables of an open database to the newest version, with Alembic."""

from __future__ import annotations

from pathlib import Path

import alembic.command
from alembic.config import Config
from sqlalchemy import Connection


def upgrade(connection: Connection, folder: Path, revision: str = "head") -> None:
    """In the transaction that is open.

    Args:
        folder: of the migrations.
        revision: how far; to the newest if not given.
    """
    config = Config()
    config.set_main_option("script_location", str(folder))
    config.attributes["connection"] = connection
    alembic.command.upgrade(config, revision)
