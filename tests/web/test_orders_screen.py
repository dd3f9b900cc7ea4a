"""The queue on a screen: who sent what, what it waits for, what STOP ends; told as it changes, and taken back with a reason."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, WebSocketRoute, expect

from tests.server.real_service import Console, RealService
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.people import PASSWORD, JobSystem
from tests.web.screens import on_page, show, signed_in
from tests.web.tablet import PATIENCE_MS, Tablet


@pytest.fixture
def at(service: RealService, browser: Browser, person: Console) -> Iterator[Tablet]:
    """A tablet on the page of orders, of which there are none."""
    with on_page(service, browser, "Orders", ".orders .empty") as found:
        yield found
        assert found.complaints == []


@pytest.fixture(scope="module")
def jobs(service: RealService) -> Iterator[JobSystem]:
    admin = Console(service)
    found = JobSystem(admin, "mes-line-3")
    admin.leave()
    yield found
    found.leave()


def cancel_all(jobs: JobSystem, runs: list[str]) -> None:
    for run in reversed(runs):
        jobs.http.delete(f"/api/runs/{run}")


def test_no_orders_say_where_they_would_come_from(at: Tablet):
    expect(at.page.locator(".empty")).to_contain_text("Orders from the plant’s job system appear here")
    check_looks(look(at.page, "no orders"))


def test_the_queue_is_told_as_it_changes_and_an_order_is_taken_back_with_its_reason(at: Tablet, jobs: JobSystem):
    asked: list[str] = []
    at.page.on("request", lambda request: asked.append(request.url) if "/api/orders" in request.url else None)
    runs = [jobs.order(seed=seed) for seed in range(2)]
    first, second = (at.page.locator(f".order[data-run='{run}']") for run in runs)
    expect(first).to_contain_text("Waits for a person to release it.", timeout=PATIENCE_MS)
    expect(first).to_contain_text("STOP of lwr4_bench ends this order.")
    expect(first).to_contain_text("Job system (mes-line-3)")
    expect(second).to_contain_text("No. 2 in the queue")
    expect(second).to_contain_text("Waits for the order before it. STOP of lwr4_bench does not end it.")
    check_looks(look(at.page, "orders"))
    at.tap(second.get_by_role("button", name="Cancel order…"))
    second.get_by_label("Why is it cancelled?").fill("wrong tool")
    check_looks(look(at.page, "cancelling an order"))
    at.tap(second.get_by_role("button", name="Cancel order"))
    expect(second).to_have_count(0)
    cancelled = jobs.http.get(f"/api/runs/{runs[1]}").json()
    assert cancelled["reason"]["parameters"] == {"who": "account:operator", "why": "wrong tool"}
    expect(at.page.locator(".remark")).to_have_text(re.compile("Order cancelled."))
    expect(at.page.locator(".remark")).to_have_count(0, timeout=12_000)  # goes by itself
    at.press("STOP")
    expect(at.page.locator(".orders .empty")).to_be_visible()
    assert asked == []


def test_what_the_sender_calls_an_order_is_shown(at: Tablet, jobs: JobSystem):
    names = {"order_id": "PO-4711", "work_order": "WO-12", "serial_number": "SN-0815"}

    def name(route: WebSocketRoute) -> None:
        server = route.connect_to_server()

        def pass_on(text: str | bytes) -> None:
            told = json.loads(text)
            for order in told["orders"] or []:
                order["run"] |= names
            route.send(json.dumps(told))

        server.on_message(pass_on)

    at.page.route_web_socket("**/api/orders/live", name)
    at.page.reload()
    run = jobs.order()
    try:
        facts = at.page.locator(f".order[data-run='{run}'] .facts")
        for value in names.values():
            expect(facts).to_contain_text(value)
    finally:
        cancel_all(jobs, [run])


def test_who_only_watches_cancels_nothing(service: RealService, browser: Browser, jobs: JobSystem, person: Console):
    person.http.post("/api/accounts", json={"name": "vera", "password": PASSWORD, "roles": ["viewer"]})
    run = jobs.order()
    try:
        with signed_in(service, browser, "vera", PASSWORD) as watching:
            show(watching, "orders")
            expect(watching.page.locator(f".order[data-run='{run}']")).to_contain_text("Sent by")
            expect(watching.page.get_by_role("button", name="Cancel order")).to_have_count(0)
    finally:
        cancel_all(jobs, [run])
