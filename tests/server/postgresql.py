"""A PostgreSQL of our own: a cluster in a temporary folder, run as `postgres` where we are root, gone when the tests end."""

from __future__ import annotations

import os
import pwd
import shutil
import socket
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from sqlalchemy import create_engine, text
from sqlalchemy.pool import NullPool

from server.store import Store

FAST = "-c fsync=off -c synchronous_commit=off -c full_page_writes=off"  # what is lost with the machine is only a test


def binaries() -> Path | None:
    """The folder of the newest server's programs."""
    found = sorted(Path("/usr/lib/postgresql").glob("*/bin/initdb"), key=lambda file: int(file.parts[-3]))
    if found:
        return found[-1].parent
    on_path = shutil.which("initdb")
    return None if on_path is None else Path(on_path).resolve().parent


class Cluster:
    """A running server with one database, cleared for each test: a database is some hundred files, a schema is none."""

    def __init__(self, address: str) -> None:
        self.url = f"{address}/postgres"

    def database(self) -> str:
        """URL of the database with new, empty tables."""
        store = Store(self.empty())
        store.migrate()
        store.close()
        return self.url

    def empty(self) -> str:
        """URL of the database without tables."""
        engine = create_engine(self.url, isolation_level="AUTOCOMMIT", poolclass=NullPool)
        with engine.connect() as connection:
            connection.execute(text("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE pid <> pg_backend_pid()"))
            connection.execute(text("DROP SCHEMA public CASCADE"))
            connection.execute(text("CREATE SCHEMA public"))
        return self.url


@contextmanager
def cluster() -> Iterator[Cluster]:
    """A cluster on a free port of 127.0.0.1; skips the test where PostgreSQL is not installed."""
    programs = binaries()
    if programs is None:
        pytest.skip("PostgreSQL's initdb is not installed (Debian: apt-get install postgresql); .ci/run installs it")
    with tempfile.TemporaryDirectory(prefix="heft-postgresql-") as name:
        folder = Path(name)
        user = _as_postgres(folder)
        with socket.create_server(("127.0.0.1", 0)) as free:
            port = free.getsockname()[1]
        _call(user, programs / "initdb", "-D", folder / "data", "-A", "trust", "-U", "heft", "--no-sync", "-E", "UTF8", "--locale=C")
        options = f"-p {port} -c listen_addresses=127.0.0.1 -k {folder} {FAST}"
        _call(user, programs / "pg_ctl", "-D", folder / "data", "-w", "-l", folder / "log", "-o", options, "start")
        try:
            yield Cluster(f"postgresql+pg8000://heft@127.0.0.1:{port}")
        finally:
            _call(user, programs / "pg_ctl", "-D", folder / "data", "-m", "immediate", "stop")


def _as_postgres(folder: Path) -> str | None:
    """The server refuses to run as root; the folder is handed to the user that Debian's package makes."""
    if os.geteuid() != 0:
        return None
    try:
        owner = pwd.getpwnam("postgres")
    except KeyError:
        pytest.skip("there is no user `postgres` to run PostgreSQL as, and it refuses to run as root")
    os.chown(folder, owner.pw_uid, owner.pw_gid)
    return "postgres"


def _call(user: str | None, *command: Path | str) -> None:
    subprocess.run([str(part) for part in command], check=True, user=user, cwd="/", stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
