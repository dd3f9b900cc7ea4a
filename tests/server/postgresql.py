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

from server.store.store import Store

FAST = "-c fsync=off -c synchronous_commit=off -c full_page_writes=off"  # what is lost with the machine is only a test


def binaries() -> Path | None:
    """The folder of the newest server's programs."""
    found = sorted(Path("/usr/lib/postgresql").glob("*/bin/initdb"), key=lambda file: int(file.parts[-3]))
    if found:
        return found[-1].parent
    on_path = shutil.which("initdb")
    return None if on_path is None else Path(on_path).resolve().parent


class Cluster:
    """A server with one database, cleared for each test: a database is some hundred files, a schema is none.

    Args:
        programs: of PostgreSQL.
        folder: empty, for its files.
        user: as whom it runs; ourselves where absent.
    """

    def __init__(self, programs: Path, folder: Path, user: str | None) -> None:
        self._programs, self._folder, self._user = programs, folder, user
        with socket.create_server(("127.0.0.1", 0)) as free:
            self._port = free.getsockname()[1]
        self.url = f"postgresql+pg8000://heft@127.0.0.1:{self._port}/postgres"
        self._call("initdb", "-A", "trust", "-U", "heft", "--no-sync", "-E", "UTF8", "--locale=C")

    def start(self) -> None:
        """Returns when it answers."""
        options = f"-p {self._port} -c listen_addresses=127.0.0.1 -k {self._folder} {FAST}"
        self._call("pg_ctl", "-w", "-l", self._folder / "log", "-o", options, "start")

    def stop(self) -> None:
        """Whoever is connected is not waited for."""
        self._call("pg_ctl", "-w", "-m", "fast", "stop")

    def _call(self, program: str, *options: Path | str) -> None:
        command = [str(part) for part in (self._programs / program, "-D", self._folder / "data", *options)]
        subprocess.run(command, check=True, user=self._user, cwd="/", stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)

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
        running = Cluster(programs, folder, _as_postgres(folder))
        running.start()
        try:
            yield running
        finally:
            running.stop()


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
