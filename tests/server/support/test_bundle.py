"""The support bundle says how the service is, holds nothing that opens a door, and comes about whatever does not work."""

from __future__ import annotations

import io
import json
import logging
import zipfile
from typing import Any

import pytest
from fastapi.testclient import TestClient
from sqlalchemy import text
from sqlalchemy.exc import IntegrityError, OperationalError

from server.http.openapi import COOKIE, CSRF_HEADER
from server.people.roles import Role
from server.runs import ledger as run_ledger
from server.runs.schemas import RunOrder
from server.service import Service
from server.settings import Settings
from server.support.bundle import Bundle
from tests.server.made_people import HASH, As, Clock

WEBHOOK_SECRET = "plants own words"
TYPED_PASSWORD = "Sommer-2026-in-the-wrong-field"
FAILED_WRITE = "of-a-failed-write"
DATABASE_PASSWORD = "p4ss-of-the-database"


def opened(archive: bytes) -> dict[str, str]:
    with zipfile.ZipFile(io.BytesIO(archive)) as found:
        assert found.testzip() is None
        return {name: found.read(name).decode() for name in found.namelist()}


@pytest.fixture
def engineer(signed_in: As) -> TestClient:
    return signed_in(Role.engineer)


def bundle(client: TestClient) -> dict[str, str]:
    answer = client.get("/api/support/bundle")
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-type"] == "application/zip"
    assert answer.headers["content-disposition"].endswith('.zip"')
    return opened(answer.content)


def test_every_file_is_there_is_named_in_the_contents_and_says_what_it_should(engineer: TestClient, service: Service) -> None:
    with service.store.write() as db:
        run = run_ledger.add_run(db, RunOrder(cell="lwr4_bench"), "key:mes", service.now()).id
    logging.getLogger("heft.test").warning("a bearing squeaks")
    found = bundle(engineer)
    said: dict[str, Any] = {name: json.loads(each) for name, each in found.items() if name.endswith(".json")}
    assert all(name in found["contents.txt"] for name in found if name != "contents.txt")
    assert not any("not_read" in each for each in said.values())
    assert said["versions.json"]["release"] == engineer.get("/health").json()["version"]
    assert "numpy" in {each["name"] for each in said["versions.json"]["packages"]}
    assert said["settings.json"]["session_hours"] == service.settings.session_hours
    assert (said["health.json"]["store"], said["health.json"]["runs"]) == ("ok", {"Resetting": 1})
    assert said["health.json"]["logged"]["warning"] >= 1
    assert said["disk.json"]["free_bytes"] > 0
    assert [each["run"] for each in said["runs.json"]] == [run]
    assert said["verification.json"]["unbroken"] is True
    assert said["audit.json"][0]["action"] == "support.bundle"
    assert "heft_requests_total" in found["metrics.txt"]
    assert "a bearing squeaks" in [json.loads(line)["message"] for line in found["log.jsonl"].splitlines()]
    cells = {each["name"]: each for each in said["cells.json"]}
    assert set(cells) == set(service.cells.names())
    assert all(finding["message"]["text"] for each in cells.values() for finding in each["findings"])
    assert any(cells[name]["findings"] for name in cells)


def test_nothing_in_it_opens_a_door(signed_in: As, nobody: TestClient, service: Service) -> None:
    admin = signed_in(Role.admin)
    key = admin.post("/api/keys", json={"name": "line", "role": "mes"}).json()["key"]
    admin.post(
        "/api/webhooks", json={"url": "https://anna:pw-in-url@plant/hooks/path-is-secret?token=query-is-secret", "secret": WEBHOOK_SECRET}
    )
    drawn = admin.post("/api/webhooks", json={"url": "https://plant/other"}).json()["secret"]
    nobody.post("/api/session", json={"name": TYPED_PASSWORD, "password": "wrong"})
    nobody.post("/api/session", json={"name": "admin", "password": "wrong"})
    logger = logging.getLogger("heft.test")
    for secret in (key, drawn, WEBHOOK_SECRET, HASH, admin.cookies[COOKIE], str(admin.headers[CSRF_HEADER])):
        logger.error("this must not be told: %s", secret)
    with service.store.write() as db:
        try:
            db.execute(text("INSERT INTO webhooks (secret) VALUES (:secret)"), {"secret": FAILED_WRITE})
        except IntegrityError:
            logger.exception("a write failed")
    found = bundle(admin)
    everything = "\n".join(found.values())
    for secret in (
        key, key[5:], drawn, WEBHOOK_SECRET, HASH, admin.cookies[COOKIE], str(admin.headers[CSRF_HEADER]), TYPED_PASSWORD,
        "pw-in-url", "path-is-secret", "query-is-secret", FAILED_WRITE,
    ):  # fmt: skip
        assert secret not in everything, secret
    assert everything.count("this must not be told: [removed]") == 6
    refused = [each["detail"]["account"] for each in json.loads(found["audit.json"]) if each["action"] == "session.refuse"]
    assert refused == ["admin", "[removed]"]


def test_the_databases_password_is_in_no_setting_and_no_error(service: Service, clock: Clock) -> None:
    elsewhere = service.settings.model_copy(update={"database_url": f"postgresql://heft:{DATABASE_PASSWORD}@db.plant/heft"})
    logging.getLogger("heft.test").error("cannot reach db.plant as heft with %s", DATABASE_PASSWORD)
    found = opened(make(service, clock, elsewhere).make(clock()))
    assert DATABASE_PASSWORD not in "\n".join(found.values())
    assert json.loads(found["settings.json"])["database"] == "postgresql"


def make(service: Service, clock: Clock, settings: Settings) -> Bundle:
    return Bundle(settings, service.store, service.cells, service.metrics, service.recent_log, clock())


def test_it_comes_about_while_the_store_does_not_answer(service: Service, clock: Clock, monkeypatch: pytest.MonkeyPatch) -> None:
    def away() -> None:
        raise OperationalError("SELECT 1", {}, Exception("disk I/O error"))

    monkeypatch.setattr(service.store, "read", away)
    found = opened(make(service, clock, service.settings).make(clock()))
    assert "disk I/O error" in json.loads(found["audit.json"])["not_read"]
    assert json.loads(found["disk.json"])["free_bytes"] > 0
    assert "could not be read" in found["log.jsonl"]


def test_a_cell_that_cannot_be_read_is_told_as_one(engineer: TestClient, service: Service) -> None:
    broken = service.settings.cells_folder / "broken"
    broken.mkdir()
    (broken / "cell.toml").write_text("name = ")
    cells = {each["name"]: each for each in json.loads(bundle(engineer)["cells.json"])}
    assert cells["broken"]["flaws"][0]["code"]
    assert cells["broken"]["findings"][0]["severity"] == "wrong"


def test_who_only_watches_does_not_get_it(signed_in: As) -> None:
    for role in (Role.viewer, Role.operator, Role.mes):
        for what in ("bundle", "disk", "versions"):
            assert signed_in(role).get(f"/api/support/{what}").status_code == 403


def test_the_log_keeps_what_is_news_and_forgets_the_oldest(nobody: TestClient, service: Service) -> None:
    logger = logging.getLogger("heft.requests")
    for k in range(2500):
        logger.warning("line %d", k)
        logger.warning("request", extra={"status": 200, "method": "GET", "route": "/", "ms": 1.0})
    lines = [json.loads(line)["message"] for line in service.recent_log.lines()]
    assert lines == [f"line {k}" for k in range(500, 2500)]
