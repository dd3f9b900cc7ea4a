"""The database: SQLite in the data folder by default, PostgreSQL by URL; migrated when it is opened.

What is acknowledged is on disk: SQLite runs with a write-ahead log and `synchronous=FULL`, and a route answers only after `Store.write`
has ended.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from sqlite3 import Connection as SqliteConnection

from sqlalchemy import Connection, DateTime, Dialect, Engine, MetaData, TypeDecorator, create_engine, event, inspect, text
from sqlalchemy.orm import DeclarativeBase, Session
from sqlalchemy.pool import ConnectionPoolEntry

MIGRATIONS = Path(__file__).parent / "migrations"
BUSY_S = 5.0  # how long a write waits for another
AWAY_S = 10.0  # how long a database that is somewhere else may take to answer
MIGRATION_LOCK, WRITE_LOCK = 0x48454654, 0x48454655  # any numbers that all services on one database agree on

NAMES = {
    "ix": "ix_%(column_0_label)s",
    "uq": "uq_%(table_name)s_%(column_0_name)s",
    "ck": "ck_%(table_name)s_%(constraint_name)s",
    "fk": "fk_%(table_name)s_%(column_0_name)s_%(referred_table_name)s",
    "pk": "pk_%(table_name)s",
}


class UtcTime(TypeDecorator[datetime]):
    """A time with its offset, kept in UTC; SQLite itself would forget the offset."""

    impl = DateTime(timezone=True)
    cache_ok = True

    def process_bind_param(self, value: datetime | None, dialect: Dialect) -> datetime | None:  # noqa: ARG002 - SQLAlchemy passes it
        """To UTC."""
        return None if value is None else value.astimezone(UTC)

    def process_result_value(self, value: datetime | None, dialect: Dialect) -> datetime | None:  # noqa: ARG002 - SQLAlchemy passes it
        """From UTC."""
        return None if value is None else value.replace(tzinfo=UTC) if value.tzinfo is None else value.astimezone(UTC)


class Table(DeclarativeBase):
    """Root of all tables."""

    metadata = MetaData(naming_convention=NAMES)
    type_annotation_map = {datetime: UtcTime}  # noqa: RUF012 - SQLAlchemy's own, read once and never changed


class Store:
    """The open database.

    Args:
        url: SQLAlchemy's, with the driver.
    """

    def __init__(self, url: str) -> None:
        self._engine = _engine(url)
        self._reading = self._engine.execution_options(isolation_level="REPEATABLE READ") if not url.startswith("sqlite") else self._engine
        self._writing = self._engine.execution_options(begin="BEGIN IMMEDIATE")

    @contextmanager
    def read(self) -> Iterator[Session]:
        """A session that sees one state of the database; nothing that it changes is kept."""
        with Session(self._reading) as session:
            yield session

    @contextmanager
    def write(self) -> Iterator[Session]:
        """A session whose changes are all on disk when it ends, or none is; one writes at a time, on either database."""
        with Session(self._writing, expire_on_commit=False) as session, session.begin():
            _wait_for_turn(session.connection(), WRITE_LOCK)
            yield session

    def migrate(self) -> None:
        """Brings the tables to the newest version."""
        with self._writing.begin() as connection:
            _wait_for_turn(connection, MIGRATION_LOCK)
            if not is_up_to_date(connection):
                from server.store.migration import upgrade  # noqa: PLC0415 - most starts need no Alembic, which takes its time to import

                upgrade(connection, MIGRATIONS)

    def check(self) -> None:
        """Raises SQLAlchemy's error where the database does not answer."""
        with self._engine.connect() as connection:
            connection.execute(text("SELECT 1"))

    def check_writable(self) -> None:
        """Waits for the turn to write, as `write` does, and writes nothing; raises SQLAlchemy's error where the turn does not come."""
        with self._writing.connect() as connection, connection.begin():
            _wait_for_turn(connection, WRITE_LOCK)

    def close(self) -> None:
        """Closes all connections; one that a thread still uses, as soon as that gives it back."""
        event.listen(self._engine, "checkin", _close_given_back)
        self._engine.dispose()


def _wait_for_turn(connection: Connection, lock: int) -> None:
    """On PostgreSQL what `BEGIN IMMEDIATE` is on SQLite: nobody else is between its first read and its commit."""
    if connection.dialect.name == "postgresql":
        connection.execute(text("SELECT pg_advisory_xact_lock(:lock)"), {"lock": lock})


def is_up_to_date(connection: Connection) -> bool:
    """Whether the tables are those of the newest migration; its file's name begins with its revision."""
    if not inspect(connection).has_table("alembic_version"):
        return False
    newest = max(file.name for file in (MIGRATIONS / "versions").glob("[0-9]*.py")).partition("_")[0]
    return bool(connection.scalar(text("SELECT version_num FROM alembic_version")) == newest)


def _engine(url: str) -> Engine:
    """Its errors, which are logged, do not say what was to be written: that may be a secret."""
    if not url.startswith("sqlite"):
        return create_engine(url, pool_pre_ping=True, hide_parameters=True, connect_args={"timeout": AWAY_S})
    engine = create_engine(url, hide_parameters=True, connect_args={"timeout": BUSY_S, "check_same_thread": False})
    event.listen(engine, "connect", _make_durable)
    event.listen(engine, "begin", _begin)
    return engine


def _make_durable(connection: SqliteConnection, _record: object) -> None:
    connection.isolation_level = None  # the driver would begin transactions by itself, and too late
    for pragma in ("journal_mode=WAL", "synchronous=FULL", "foreign_keys=ON", f"busy_timeout={round(BUSY_S * 1000)}"):
        connection.execute(f"PRAGMA {pragma}")


def _close_given_back(_connection: object, entry: ConnectionPoolEntry) -> None:
    entry.invalidate()


def _begin(connection: Connection) -> None:
    connection.exec_driver_sql(connection.get_execution_options().get("begin", "BEGIN"))
