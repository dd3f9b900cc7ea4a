"""A service in this process, on an empty folder, with somebody signed in for each role."""

from __future__ import annotations

import shutil
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from starlette.requests import HTTPConnection
from starlette.types import Receive, Scope, Send

from server.app import create_app
from server.cells.uploads import CellChecker
from server.http.openapi import COOKIE, CSRF_HEADER
from server.http.problem_answers import ProblemAnswer
from server.people import accounts
from server.people.accounts import Account
from server.people.roles import Role
from server.service import Service
from server.settings import STORE_FILE, Settings
from server.store.store import Store
from tests.server.declared_problems import find_undeclared
from tests.server.made_people import HASH, As, Clock
from tests.server.postgresql import Cluster, cluster
from tests.server.real_service import Console, RealService, real_service
from tests.server.scripted_process import ObedientProcess


@pytest.fixture
def unused_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as free:
        port: int = free.getsockname()[1]
    return port


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture(scope="session")
def postgresql() -> Iterator[Cluster]:
    with cluster() as running:
        yield running


@pytest.fixture
def database_url(request: pytest.FixtureRequest) -> str | None:
    """SQLite, unless a test is parametrised with BOTH_STORES and it is PostgreSQL's turn."""
    if getattr(request, "param", "sqlite") == "sqlite":
        return None
    running: Cluster = request.getfixturevalue("postgresql")
    return running.database()


@pytest.fixture(scope="session")
def checker() -> Iterator[CellChecker]:
    """The process that checks uploads: one for all tests, begun with the first."""
    shared = CellChecker()
    yield shared
    shared.close()


@pytest.fixture(scope="session")
def real(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RealService]:
    """A service in a process of its own: one for all tests, as each starts an engine beside it."""
    with real_service(tmp_path_factory.mktemp("real")) as running:
        yield running


@pytest.fixture(scope="module")
def console(service: RealService) -> Iterator[Console]:
    """Somebody in control of a service in a process of its own, which the test's module says by a `service` fixture of its own."""
    person = Console(service)
    person.take_control()
    yield person
    person.leave()


@pytest.fixture(scope="session")
def described_app(tmp_path_factory: pytest.TempPathFactory) -> FastAPI:
    """A service that is described and never started."""
    return create_app(Settings(data=tmp_path_factory.mktemp("described")))


@pytest.fixture(autouse=True)
def declared_problems(described_app: FastAPI, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Whatever problem a service in this process answers with is one that its operation declares."""
    send, undeclared = ProblemAnswer.__call__, list[str]()

    async def check(answer: ProblemAnswer, scope: Scope, receive: Receive, pass_on: Send) -> None:
        undeclared.extend(find_undeclared(described_app, HTTPConnection(scope), answer.found))
        await send(answer, scope, receive, pass_on)

    monkeypatch.setattr(ProblemAnswer, "__call__", check)
    yield
    assert undeclared == []


@pytest.fixture(scope="session")
def new_tables(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A file with new, empty tables; to make them takes longer than most tests."""
    file = tmp_path_factory.mktemp("tables") / STORE_FILE
    store = Store(f"sqlite:///{file}")
    store.migrate()
    store.close()
    return file


@pytest.fixture
def settings(tmp_path: Path, database_url: str | None, new_tables: Path) -> Settings:
    data = tmp_path / "data"
    if database_url is None:
        data.mkdir()
        shutil.copy(new_tables, data)
    return Settings(data=data, database_url=database_url)


@pytest.fixture
def nothing_planned(monkeypatch: pytest.MonkeyPatch) -> None:
    """Runs have their cell and do nothing; to be asked for before the app."""
    monkeypatch.setattr("server.runs.active_run.ControlProcess", ObedientProcess)
    monkeypatch.setattr("server.runs.conductor.warm_up", lambda: None)


@pytest.fixture
def app(settings: Settings, clock: Clock, checker: CellChecker, described_app: FastAPI) -> FastAPI:
    made = create_app(settings, now=clock, checker=checker)
    made.openapi_schema = described_app.openapi()  # that of every service; it takes a second to make
    return made


@pytest.fixture
def nobody(app: FastAPI) -> Iterator[TestClient]:
    """A client that shows nothing; the service runs while the fixture lives."""
    with TestClient(app, raise_server_exceptions=False) as client:
        yield client


@pytest.fixture
def service(app: FastAPI, nobody: TestClient) -> Service:
    """The running service."""
    found: Service = app.state.service
    return found


@pytest.fixture
def signed_in(app: FastAPI, service: Service) -> As:
    """`signed_in(Role.operator)` is a browser's client of an account with these roles; the CSRF token is sent along."""

    def client(*roles: Role) -> TestClient:
        name = "-".join(sorted(roles))
        with service.store.write() as db:
            account = db.get(Account, name) or accounts.add_account(db, name, HASH, frozenset(roles), service.now())
            db.flush()
            token, session = accounts.open_session(db, account, "testclient", service.now())
        return TestClient(
            app, cookies={COOKIE: token}, headers={CSRF_HEADER: session.csrf_token}, raise_server_exceptions=False, follow_redirects=False
        )

    return client


@pytest.fixture
def with_key(app: FastAPI, service: Service) -> As:
    """`with_key(Role.mes)` is a machine's client."""

    def client(role: Role) -> TestClient:
        with service.store.write() as db:
            key, _ = accounts.add_key(db, f"test-{role}-{len(list(db.query(accounts.ApiKey)))}", role, "test", service.now(), None)
        return TestClient(app, headers={"Authorization": f"Bearer {key}"}, raise_server_exceptions=False)

    return client
