"""Starts the service, and looks after its store from the command line."""

from __future__ import annotations

import fcntl
import json
import secrets
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import uvicorn
from pydantic import ValidationError
from sqlalchemy import func, select

from core.errors import BadInput
from core.files.schema_flaw import schema_flaw
from core.files.whole_file import write_whole
from core.version import release_version
from core.words.catalogue import find_language
from core.words.message import Message
from server.app import create_app
from server.people import accounts, audit
from server.people.accounts import Account
from server.people.roles import Role
from server.runner.priority import Priority, take
from server.service import utc_now
from server.settings import STORE_FILE, Settings
from server.store.store import Store
from server.telemetry.logs import start_logging

ANYWHERE = {"0.0.0.0": "localhost", "::": "localhost"}
FIRST = "operator"
FIRST_ROLES = frozenset({Role.operator, Role.engineer, Role.admin})


def run_service(*, host: str | None = None, port: int | None = None, cells: Path | None = None, data: Path | None = None) -> None:
    """Serves until it is told to end (SIGINT, SIGTERM); requests under way may finish.

    Raises:
        BadInput: a setting cannot be used, or another service runs on the same folder.
    """
    settings = read_settings(host=host, port=port, cells=cells, data=data)
    start_logging(settings.log_level, settings.log_format)
    take(Priority.SERVICE)
    with only_one(settings.data):
        app = create_app(settings)
        greet(settings)
        uvicorn.run(
            app,
            host=settings.host,
            port=settings.port,
            log_config=None,
            access_log=False,
            server_header=False,
            proxy_headers=bool(settings.trusted_proxies),
            forwarded_allow_ips=list(settings.trusted_proxies),
            ws_ping_interval=2.0,  # who does not read does not answer either, and is closed within 5 s
            ws_ping_timeout=2.5,
            ws_per_message_deflate=False,  # halves what a core can send, and samples hardly shrink
            timeout_graceful_shutdown=settings.shutdown_seconds,
        )


def write_openapi(file: Path) -> None:
    """The description of the API as JSON; the file appears complete or not at all."""
    write_whole(file, json.dumps(create_app(read_settings()).openapi(), indent=2) + "\n")


def read_settings(**options: Any) -> Settings:
    """The options that are given, then the environment, then what stands in `Settings`.

    Raises:
        BadInput: one of them cannot be used.
    """
    try:
        return Settings(**{name: value for name, value in options.items() if value is not None})
    except ValidationError as error:
        flaw = schema_flaw(error.errors()[0])
        name = flaw.key.partition(".")[0]
        where = f"--{name}" if options.get(name) is not None else f"HEFT_{name.upper()}"
        raise BadInput(where, flaw.code, **flaw.parameters) from error


@contextmanager
def only_one(folder: Path) -> Iterator[None]:
    """Holds the data folder: a second service on it would take the first one's runs for dead.

    Raises:
        BadInput: another holds it.
    """
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "heft.lock").open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            raise BadInput(str(folder), "serve-data-in-use") from error
        yield


def greet(settings: Settings) -> None:
    """Says where the service is and writes down with what settings; makes the first account and shows its password, once."""
    store = Store(settings.store_url)
    store.migrate()
    password = first_account(store)
    with store.write() as db:
        audit.record(
            db, "service", "service.start", {"version": release_version(), "settings": settings.model_dump_json(exclude={"database_url"})}
        )
    store.close()
    sys.stdout.write("\n".join(_greeting(settings, password)) + "\n")
    sys.stdout.flush()


def _greeting(settings: Settings, password: str | None) -> list[str]:
    """What a person reads who starts the service; the address stands last and alone."""
    address = f"http://{ANYWHERE.get(settings.host, settings.host)}:{settings.port}"
    lines = [_say(Message.of("serve-started", version=release_version(), folder=str(settings.data.absolute())))]
    if password is None:
        return [*lines, "", f"  {address}"]
    # behind the `#`, which no browser sends: neither a server nor a proxy gets to log it
    link = f"{address}/#/first/{FIRST}/{password}"
    first = _say(Message.of("serve-first-account", account=FIRST, password=password))
    return [*lines, first, _say(Message.of("serve-open-once")), "", f"  {link}"]


def _say(message: Message) -> str:
    return message.say(find_language())


def first_account(store: Store) -> str | None:
    """Makes an operator who may do everything, where there is nobody yet; returns the password."""
    with store.write() as db:
        if db.scalar(select(func.count()).select_from(Account)):
            return None
        password = secrets.token_urlsafe(12)
        password_hash = accounts.hash_password(password)  # takes its time, so only where it is needed; nobody else writes before the start
        accounts.add_account(db, FIRST, password_hash, FIRST_ROLES, utc_now())
        audit.record(db, "service", "account.create", {"account": FIRST, "roles": " ".join(sorted(FIRST_ROLES))})
    return password


def verify_audit(data: Path | None, expect: str | None = None) -> Message:
    """Walks the audit log's chain.

    Raises:
        BadInput: the chain is broken, or does not contain the expected hash; or there is no store.
    """
    settings = read_settings(data=data)
    if settings.database_url is None and not (settings.data / STORE_FILE).is_file():
        raise BadInput(str(settings.data), "serve-no-store", file=STORE_FILE)
    store = Store(settings.store_url)
    seen = expect is None
    with store.read() as db:
        chain = list(audit.entries(db))
    store.close()
    count, last, flaw = audit.verify_chain(chain)
    seen = seen or any(entry.hash == expect for entry in chain[:count])
    if flaw is not None:
        raise flaw
    if not seen:
        raise BadInput(audit.LOG, "people-audit-hash-missing", entries=count, hash=expect or "")
    return Message.of("people-audit-unbroken", entries=count, hash=last)
