"""Administration from the console, on a tablet: what an administrator does, and what everybody does with their own account."""

from __future__ import annotations

import hashlib
import hmac
import io
import json
import re
import threading
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import httpx2 as httpx
import pytest
from playwright.sync_api import Browser, Page, expect

from tests.server.real_service import Console, RealService
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import show, signed_in
from tests.web.tablet import PATIENCE_MS, Tablet

PASSWORD = "correct horse battery"
SECTIONS = ["account", "people", "keys", "webhooks", "audit", "connections", "service"]
FORBIDDEN, SIGNED_OUT = "403 (Forbidden)", "401 (Unauthorized)"
"""What the browser says of the answer to somebody who gets a no."""


def make_account(person: Console, name: str, *roles: str) -> None:
    answer = person.http.post("/api/accounts", json={"name": name, "password": PASSWORD, "roles": roles})
    assert answer.status_code in (201, 409), answer.text


@pytest.fixture
def admin(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """The first operator's tablet, who is an administrator as well."""
    with signed_in(service, browser) as at:
        yield at
        assert at.complaints == []


@pytest.fixture
def webhook(person: Console) -> Iterator[None]:
    """One that nobody answers: for as long as it stands it is an alarm on every page."""
    found = person.http.post("/api/webhooks", json={"url": "http://127.0.0.1:9/nobody/is/here"}).json()["id"]
    person.http.post(f"/api/webhooks/{found}/test")
    yield
    person.http.delete(f"/api/webhooks/{found}")


def go(at: Tablet, section: str) -> Page:
    show(at, "admin", section)
    at.wait(".admin h1")
    return at.page


@pytest.mark.thorough
def test_every_section_can_be_read_and_hit(admin: Tablet, person: Console, webhook: None) -> None:
    make_account(person, "carla", "operator")
    person.http.post("/api/keys", json={"name": "reader", "role": "viewer"})
    person.take_control()
    page = go(admin, "account")
    admin.wait(".own-sessions li:nth-child(2)")
    page.get_by_role("button", name="Sign out").first.tap()
    check_looks(look(page, "account, asked first"))
    page = go(admin, "people")
    admin.wait(".tiles li")
    check_looks(look(page, "people"))
    page.locator("li", has_text="carla").get_by_role("button", name="Change").tap()
    page.get_by_role("button", name="New account").scroll_into_view_if_needed()
    check_looks(look(page, "people, one changed"))
    page.get_by_role("button", name="New account").tap()
    page.get_by_label("Name", exact=True).fill("not a name")
    check_looks(look(page, "people, a new one with a flaw"))
    page = go(admin, "keys")
    page.get_by_role("button", name="New key").tap()
    check_looks(look(page, "keys"))
    page.get_by_label("Name of the machine").fill("looked-at")
    page.get_by_role("button", name="Create key").tap()
    admin.wait(".shown-once")
    check_looks(look(page, "keys, shown once"))
    page = go(admin, "webhooks")
    page.get_by_role("button", name="New webhook").tap()
    page.locator("li", has_text="nobody").get_by_role("button", name="Deliveries").tap()
    page.locator("li", has_text="nobody").get_by_role("button", name="Send a test").tap()
    admin.wait(".tiles .abnormal")
    check_looks(look(page, "webhooks"))
    page = go(admin, "audit")
    admin.wait(".audit-entries tbody tr")
    page.locator(".verification summary").tap()
    page.get_by_role("button", name="Verify the log").tap()
    admin.wait(".verification .secret")
    check_looks(look(page, "audit"))
    page = go(admin, "connections")
    admin.wait(".tiles li")
    page.get_by_role("button", name="Measure").tap()
    admin.wait(".own-connection .facts")
    check_looks(look(page, "connections"))
    page = go(admin, "service")
    admin.wait(".libraries")
    admin.wait("caption")
    check_looks(look(page, "service"))
    person.http.delete("/api/keys/looked-at")


def test_nothing_is_wider_than_a_phone(admin: Tablet, webhook: None) -> None:
    admin.page.set_viewport_size({"width": 390, "height": 844})
    beside = """() => [...document.querySelectorAll('main *')].filter(each => each.checkVisibility() && !each.closest('option'))
        .filter(each => { const {left, right} = each.getBoundingClientRect(); return left < -1 || right > innerWidth + 1 })
        .map(each => `${each.className || each.tagName}: ${each.textContent.trim().slice(0, 40)}`)"""
    for section in SECTIONS:
        page = go(admin, section)
        admin.wait({"people": ".tiles li", "audit": ".audit-entries tbody tr", "service": ".libraries"}.get(section, ".admin"))
        assert page.evaluate(beside) == [], section
    admin.page.get_by_label("Section").select_option("keys")
    expect(admin.page.get_by_role("heading", level=1)).to_have_text("API keys")


@contextmanager
def somebody(service: RealService, browser: Browser, name: str) -> Iterator[Tablet]:
    """Somebody's tablet, which may hear a no."""
    with signed_in(service, browser, name, PASSWORD) as at:
        yield at
        assert [each for each in at.complaints if not re.search(r"40[13] \(", each)] == []


def test_a_new_password_signs_out_other_devices_and_stays_signed_in_here(service: RealService, browser: Browser, person: Console) -> None:
    make_account(person, "dora", "operator")
    new = "another long password"
    with somebody(service, browser, "dora") as other, somebody(service, browser, "dora") as here:
        assert here.page.get_by_role("link", name="Admin").count() == 0
        here.tap(here.page.get_by_role("link", name="Settings"))
        here.tap(here.page.get_by_role("link", name="Password and devices"))
        change = here.page.get_by_role("button", name="Change password")
        expect(change).to_be_disabled()
        here.page.get_by_label("Current password").fill("not this one at all")
        expect(here.page.locator("main")).to_contain_text("12 more characters needed")
        here.page.get_by_label("New password").fill(new)
        here.tap(change)
        expect(here.page.get_by_role("alert")).to_contain_text("password")
        here.page.get_by_label("Current password").fill(PASSWORD)
        here.tap(change)
        expect(here.page.get_by_role("status").filter(has_text="Password changed")).to_be_visible()
        other.wait(".sign-in")
        here.page.reload()
        here.wait(".admin h1")
    assert httpx.post(f"http://{service.address}/api/session", json={"name": "dora", "password": new}).status_code == 200
    assert httpx.post(f"http://{service.address}/api/session", json={"name": "dora", "password": PASSWORD}).status_code == 401


def test_a_device_that_is_signed_out_from_afar_asks_for_a_name_again(service: RealService, browser: Browser, person: Console) -> None:
    make_account(person, "emil", "viewer")
    with somebody(service, browser, "emil") as lost, somebody(service, browser, "emil") as here:
        page = go(here, "account")
        expect(page.locator(".own-sessions li")).to_have_count(2)
        expect(page.locator(".own-sessions li", has_text="this device")).to_contain_text("Chrome on Linux")
        page.locator(".own-sessions").get_by_role("button", name="Sign out").tap()
        expect(page.get_by_role("group", name=re.compile("has to sign in again"))).to_be_visible()
        page.get_by_role("button", name="Cancel").tap()
        expect(page.locator(".own-sessions li")).to_have_count(2)
        page.locator(".own-sessions").get_by_role("button", name="Sign out").tap()
        page.get_by_role("button", name="Sign it out").tap()
        expect(page.locator(".own-sessions li")).to_have_count(1)
        expect(page.locator(".own-sessions")).to_contain_text("on this device only")
        lost.wait(".sign-in")


def test_an_account_is_made_changed_and_disabled(admin: Tablet, service: RealService) -> None:
    def status(password: str) -> int:
        return httpx.post(f"http://{service.address}/api/session", json={"name": "fritz", "password": password}).status_code

    page = go(admin, "people")
    page.get_by_role("button", name="New account").tap()
    create = page.get_by_role("button", name="Create account")
    expect(create).to_be_disabled()
    expect(page.locator("main")).to_contain_text("Enter a name")
    page.get_by_label("Name", exact=True).fill("operator")
    expect(page.locator("main")).to_contain_text("There is an account of that name already")
    page.get_by_label("Name", exact=True).fill("fritz")
    page.get_by_label("First password").fill(PASSWORD)
    page.get_by_text("watches").tap()
    create.tap()
    row = page.locator("li.tile", has_text="fritz")
    expect(row).to_contain_text("Operator, Viewer")
    assert status(PASSWORD) == 200
    row.get_by_role("button", name="Change").tap()
    expect(row.get_by_role("button", name="Save")).to_be_disabled()
    row.get_by_text("watches").tap()
    row.get_by_label("New password").fill("a password of the third kind")
    row.get_by_role("button", name="Save").tap()
    expect(page.get_by_role("status").filter(has_text="fritz was saved")).to_be_visible()
    expect(row).not_to_contain_text("Viewer")
    assert status(PASSWORD) == 401
    assert status("a password of the third kind") == 200
    row.get_by_role("button", name="Disable").tap()
    row.get_by_role("button", name="Disable the account").tap()
    expect(row).to_contain_text("disabled")
    assert status("a password of the third kind") == 401
    row.get_by_role("button", name="Enable").tap()
    expect(row.get_by_role("button", name="Disable")).to_be_visible()
    own = page.locator("li.tile", has_text="You cannot disable your own account")
    expect(own.get_by_role("button", name="Disable")).to_have_count(0)


def test_a_key_is_shown_once_works_and_is_refused_when_revoked(admin: Tablet, service: RealService) -> None:
    def status(key: str) -> int:
        return httpx.get(f"http://{service.address}/api/runs", headers={"Authorization": f"Bearer {key}"}).status_code

    page = go(admin, "keys")
    page.get_by_role("button", name="New key").tap()
    page.get_by_label("Name of the machine").fill("line-9")
    page.get_by_label("Valid for").select_option("30")
    page.get_by_role("button", name="Create key").tap()
    key = page.locator(".shown-once .secret").inner_text()
    assert status(key) == 200
    row = page.locator("li.tile", has_text="line-9")
    expect(row).to_contain_text("Job system (MES)")
    page.get_by_role("button", name="I have copied it").tap()
    expect(page.locator(".shown-once")).to_have_count(0)
    page.reload()
    admin.wait(".tiles li")
    assert key not in page.content()
    row.get_by_role("button", name="Revoke").tap()
    expect(page.get_by_role("group", name=re.compile("refused at once"))).to_be_visible()
    row.get_by_role("button", name="Revoke the key").tap()
    expect(row).to_have_count(0)
    assert status(key) == 401


class Plant(HTTPServer):
    """Takes what is sent to it."""

    def __init__(self) -> None:
        super().__init__(("127.0.0.1", 0), Receiver)
        self.seen: list[tuple[dict[str, str], bytes]] = []


class Receiver(BaseHTTPRequestHandler):
    server: Plant

    def do_POST(self) -> None:
        self.server.seen.append((dict(self.headers), self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(204)
        self.end_headers()

    def log_message(self, *_: object) -> None:
        """The test says what matters."""


@pytest.fixture
def plant() -> Iterator[Plant]:
    with Plant() as found:
        thread = threading.Thread(target=found.serve_forever, args=(0.05,))
        thread.start()
        yield found
        found.shutdown()
        thread.join()


def test_a_webhook_is_added_tried_and_removed(admin: Tablet, plant: Plant) -> None:
    page = go(admin, "webhooks")
    page.get_by_role("button", name="New webhook").tap()
    add = page.get_by_role("button", name="Add webhook")
    page.get_by_label("Address").fill("plant.example/hook")
    expect(add).to_be_disabled()
    url = f"http://127.0.0.1:{plant.server_port}/ended"
    page.get_by_label("Address").fill(url)
    add.tap()
    secret = page.locator(".shown-once .secret").inner_text()
    row = page.locator("li.tile", has_text=url)
    row.get_by_role("button", name="Deliveries").tap()
    expect(row).to_contain_text("Nothing has been sent yet")
    row.get_by_role("button", name="Send a test").tap()
    expect(row).to_contain_text("The test was accepted")
    expect(row.locator(".deliveries")).to_contain_text("accepted")
    ((headers, body),) = plant.seen
    assert json.loads(body)["test"] is True
    expected = hmac.new(secret.encode(), f"{headers['Heft-Timestamp']}.".encode() + body, hashlib.sha256).hexdigest()
    assert headers["Heft-Signature"] == f"sha256={expected}"
    row.get_by_role("button", name="Remove").tap()
    row.get_by_role("button", name="Remove the webhook").tap()
    expect(row).to_have_count(0)


def test_the_audit_log_is_searched_and_verified(admin: Tablet, person: Console) -> None:
    make_account(person, "gerda", "viewer")
    person.http.patch("/api/accounts/gerda", json={"roles": ["operator"]})
    page = go(admin, "audit")
    rows = page.locator(".audit-entries tbody tr")
    page.get_by_label("What").select_option("account")
    page.get_by_label("Mentions").fill("gerda")
    expect(rows).to_have_count(2)
    expect(rows.first).to_contain_text("account.change")
    expect(rows.first).to_contain_text("roles: operator")
    page.get_by_label("What").select_option("account.create")
    expect(rows).to_have_count(1)
    page.get_by_label("To", exact=True).fill("2020-01-01")
    expect(page.locator("main")).to_contain_text("No entry fits")
    page.get_by_role("button", name="Clear filter").tap()
    expect(rows.nth(5)).to_be_visible()
    page.locator(".verification summary").tap()
    verify = page.get_by_role("button", name="Verify the log")
    page.get_by_label("Hash seen earlier").fill("0123")
    expect(verify).to_be_disabled()
    page.get_by_label("Hash seen earlier").fill("f" * 64)
    verify.tap()
    expect(page.locator(".verification").get_by_role("alert")).to_contain_text("none with the hash")
    page.get_by_label("Hash seen earlier").fill("")
    verify.tap()
    expect(page.locator(".verification").get_by_role("status")).to_contain_text("Unbroken")
    last = page.locator(".verification .secret").inner_text()
    assert last in {each["hash"] for each in person.http.get("/api/audit").json()}


def test_connections_are_measured_here_and_of_who_is_in_control(admin: Tablet, person: Console) -> None:
    person.take_control()
    page = go(admin, "connections")
    page.get_by_role("button", name="Measure").tap()
    expect(page.locator(".own-connection .facts")).to_contain_text("0 of 40", timeout=PATIENCE_MS)
    cell = page.locator(f"li[data-cell={person.cell}]")
    expect(cell).to_contain_text("operator")
    expect(cell).to_contain_text("Round trip")
    expect(page.locator("li[data-cell=ur5e_line]")).to_contain_text("nobody")


def test_the_service_tells_its_versions_and_room_and_gives_its_bundle(admin: Tablet, person: Console, tmp_path: Path) -> None:
    page = go(admin, "service")
    expect(page.locator("main")).to_contain_text(person.http.get("/health").json()["version"])
    expect(page.locator("main")).to_contain_text("of robot time")
    expect(page.get_by_role("row", name=re.compile("Database"))).not_to_have_count(0)
    with page.expect_download() as waiting:
        page.get_by_role("link", name="Download support bundle").tap()
    assert waiting.value.suggested_filename.startswith("heft-support-")
    waiting.value.save_as(tmp_path / "bundle.zip")
    with zipfile.ZipFile(io.BytesIO((tmp_path / "bundle.zip").read_bytes())) as bundle:
        assert {"contents.txt", "versions.json", "log.jsonl", "audit.json", "cells.json"} <= set(bundle.namelist())
        there = sorted(each["name"] for each in person.http.get("/api/cells").json())  # tests before this one may have brought some
        assert sorted(each["name"] for each in json.loads(bundle.read("cells.json"))) == there
        assert {"lwr4_bench", "ur5e_line"} <= set(there)
        assert json.loads(bundle.read("settings.json"))["port"] == person.service.port


def test_who_may_less_sees_less_and_is_told_why(service: RealService, browser: Browser, person: Console) -> None:
    make_account(person, "hans", "operator")
    make_account(person, "ina", "engineer")
    with somebody(service, browser, "hans") as at:
        page = go(at, "people")
        expect(page.locator("main")).to_contain_text("This section is for administrators.")
        expect(page.locator("main")).to_contain_text("Your roles: Operator.")
        expect(page.locator(".admin-sections")).to_have_count(0)
        check_looks(look(page, "closed"))
        page = go(at, "account")
        expect(page.get_by_label("Current password")).to_be_visible()
    with somebody(service, browser, "ina") as at:
        at.tap(at.page.get_by_role("link", name="Admin"))
        at.wait(".admin h1")
        shown = [each.inner_text() for each in at.page.locator(".admin-sections a").all()]
        assert shown == ["My account", "Audit log", "Connections", "Service"]
        go(at, "audit")
        at.wait(".audit-entries tbody tr")
        assert at.complaints == []


def test_a_section_that_there_is_not_is_told_as_that(service: RealService, browser: Browser) -> None:
    with signed_in(service, browser) as at:
        show(at, "admin", "nonsense")
        expect(at.page.get_by_role("heading", level=1)).to_have_text("Page not found")


def test_pages_that_do_not_come_are_told_with_a_way_on(service: RealService, browser: Browser) -> None:
    with signed_in(service, browser) as at:
        at.page.context.route("**/assets/admin-page*.js", lambda route: route.fulfill(status=404))
        show(at, "admin", "account")
        expect(at.page.locator("main")).to_contain_text("may have been updated", timeout=PATIENCE_MS)
        expect(at.page.get_by_role("button", name="Reload the console")).to_be_visible()
