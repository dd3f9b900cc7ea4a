"""What a plant can set: each setting is an environment variable `HEFT_<NAME>`; the command line's options go before it."""

from __future__ import annotations

from datetime import timedelta
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field
from pydantic.functional_validators import BeforeValidator
from pydantic_settings import BaseSettings, NoDecode, SettingsConfigDict

from server.telemetry.logs import LogForm


def _split(value: object) -> object:
    """`a, b` of the environment as ("a", "b")."""
    return tuple(word.strip() for word in value.split(",") if word.strip()) if isinstance(value, str) else value


STORE_FILE = "heft.sqlite"
"""In the data folder, where no other database is set."""

CommaSeparated = Annotated[tuple[str, ...], NoDecode, BeforeValidator(_split)]


class Settings(BaseSettings):
    """All settings with what they are when nothing is set; a start on 127.0.0.1 needs none of them."""

    model_config = SettingsConfigDict(env_prefix="HEFT_", frozen=True, extra="forbid")

    host: str = Field("127.0.0.1", description="Address that the service listens on.")
    port: int = Field(8000, ge=0, le=65535, description="Port that the service listens on; 0 takes a free one.")
    data: Path = Field(Path("data"), description="Folder of the database, the recordings and, unless set otherwise, the cells.")
    cells: Path | None = Field(
        None, description="Folder with one folder per cell; where it is not set, `cells` in the data folder, begun with the cells at hand."
    )
    database_url: str | None = Field(
        None, description="Database; where it is not set, SQLite in the data folder. `postgresql://user:password@host/name` for a plant."
    )
    session_hours: float = Field(12.0, gt=0, le=168, description="Hours after which a browser has to sign in again.")
    idle_minutes: float = Field(60.0, gt=0, description="Minutes without a request after which a browser has to sign in again.")
    secure_cookies: bool = Field(
        False, description="Send the session cookie over HTTPS only; set it where TLS ends in front of the service."
    )
    origins: CommaSeparated = Field((), description="Further origins, `https://console.plant`, whose pages may use a browser's session.")
    trusted_proxies: CommaSeparated = Field((), description="Addresses of proxies whose X-Forwarded-For is believed.")
    upload_max_bytes: int = Field(50_000_000, gt=0, description="Largest uploaded cell or recording.")
    body_max_bytes: int = Field(1_000_000, gt=0, description="Largest body of any other request.")
    shutdown_seconds: int = Field(10, gt=0, description="How long open requests may take to end when the service stops.")
    log_level: Literal["debug", "info", "warning", "error"] = Field("info", description="Least level that is logged.")
    log_format: LogForm = Field("auto", description="`text` for people, `json` for programs; `auto` is text on a terminal, else JSON.")

    @property
    def session_lasts(self) -> timedelta:
        """How long a browser stays signed in at most."""
        return timedelta(hours=self.session_hours)

    @property
    def idle_lasts(self) -> timedelta:
        """How long a browser stays signed in that asks for nothing."""
        return timedelta(minutes=self.idle_minutes)

    @property
    def cells_folder(self) -> Path:
        """Where the cells are."""
        return self.cells or self.data / "cells"

    @property
    def recordings_folder(self) -> Path:
        """Where runs leave their recordings."""
        return self.data / "recordings"

    @property
    def reports_folder(self) -> Path:
        """Where diagnoses leave their pages."""
        return self.data / "reports"

    @property
    def trials_folder(self) -> Path:
        """Where blind trials leave their outcomes."""
        return self.data / "trials"

    @property
    def imports_folder(self) -> Path:
        """Where logs are that are being imported."""
        return self.data / "imports"

    @property
    def store_url(self) -> str:
        """SQLAlchemy's URL of the store, with the driver named."""
        url = self.database_url or f"sqlite:///{(self.data / STORE_FILE).absolute()}"
        return url.replace("postgresql://", "postgresql+pg8000://", 1).replace("postgres://", "postgresql+pg8000://", 1)
