"""What this service is made of, down to the libraries and the database."""

from __future__ import annotations

import os
import platform
from datetime import datetime
from importlib.metadata import distributions

from pydantic import Field
from sqlalchemy import text
from sqlalchemy.orm import Session

from core.version import code_version, release_version
from server.http.schemas import Answer


class Package(Answer):
    """A library that is installed beside the service."""

    name: str = Field(description="As the package index has it.", examples=["mujoco"])
    version: str = Field(description="As it says itself.", examples=["3.3.1"])


class Versions(Answer):
    """What this service is made of."""

    release: str = Field(description="Of Heft.", examples=["0.1.0"])
    engine: str = Field(
        description="Release, and a digest of the engine's sources: the same made the same results.", examples=["0.1.0+3f9a1c2e"]
    )
    python: str = Field(description="Of the interpreter.", examples=["3.11.2"])
    system: str = Field(description="Operating system and processor.", examples=["Linux-6.1.0-x86_64"])
    processors: int = Field(description="Processors that the service may use.", examples=[4])
    database: str = Field(description="Kind and version of the database.", examples=["SQLite 3.40.1"])
    schema_revision: str = Field(description="Of the database's tables: the newest migration that it has seen.", examples=["0009"])
    started_at: datetime = Field(description="When the service started.", examples=["2026-03-01T05:58:12Z"])
    packages: list[Package] = Field(description="Libraries, by name.")


def read_versions(db: Session, started_at: datetime) -> Versions:
    """All of them."""
    return Versions(
        release=release_version(),
        engine=code_version(),
        python=platform.python_version(),
        system=platform.platform(),
        processors=len(os.sched_getaffinity(0)),
        database=_read_database(db),
        schema_revision=str(db.scalar(text("SELECT version_num FROM alembic_version"))),
        started_at=started_at,
        packages=_list_packages(),
    )


def _read_database(db: Session) -> str:
    if db.get_bind().dialect.name == "sqlite":
        return f"SQLite {db.scalar(text('SELECT sqlite_version()'))}"
    return f"PostgreSQL {db.scalar(text('SHOW server_version'))}"


def _list_packages() -> list[Package]:
    found = {each.metadata["Name"].lower(): each.version for each in distributions()}
    return [Package(name=name, version=version) for name, version in sorted(found.items())]
