"""Whatever is tapped, in whatever order: the robot moves after a release of the shown plan only, and the console stays whole.

For longer, and in another order:
`HEFT_TAPS=5000 HEFT_TAPS_SEED=7 python -m pytest -s -o faulthandler_timeout=0 tests/web/test_random_taps.py`
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from tests.server.real_service import Console, RealService, wait_for
from tests.web.patient_cells import console_service
from tests.web.people import BEN, PASSWORD, add_operator
from tests.web.random_hands import RandomHands
from tests.web.tablet import tablet

TAPS = int(os.environ.get("HEFT_TAPS", "75"))
SEED = int(os.environ.get("HEFT_TAPS_SEED", "1"))
REFUSED = re.compile(r"Failed to load resource: the server responded with a status of 40[39]|.*net::ERR_INTERNET_DISCONNECTED")
"""What the browser says of a refusal, which the page says in words: 409 where two tabs want the same, 403 after one of them signed out; and
that there is no link."""
UNREADABLE = re.compile(r"Failed .* a status of 422 .* at http://[^/]+/api/(runs|cells/[^/]+/zones/[^/]+)$")
"""The same of an order or a zone's place of nonsense, as of 1e9 kg; of nothing else that a page asks."""
NOT_RELEASED = {"Resetting", "Idle", "Stopped"}
"""States of a run that nobody has released; it may be stopped from there."""


@pytest.fixture(scope="module")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RealService]:
    """One that nobody uses afterwards: hands like these leave zones and runs wherever they like."""
    with console_service(tmp_path_factory.mktemp("taps")) as running:
        yield running


@pytest.fixture(scope="module")
def hands(service: RealService, browser: Browser, request: pytest.FixtureRequest) -> RandomHands:
    """Hands that have done all their tapping."""
    witness = Console(service)
    add_operator(witness)
    with tablet(browser, service) as first, tablet(browser, service) as second:
        found = RandomHands([(first, "operator", service.password), (second, BEN, PASSWORD)], witness, SEED)
        for _ in range(TAPS):
            found.act()
    witness.leave()
    did = f"{TAPS} acts: {dict(found.acts)}, {len(found.releases)} releases asked for"
    request.config.get_terminal_writer().line(did)
    return found


def test_no_page_is_blank_and_the_browser_complains_of_nothing(hands: RandomHands):
    assert sum(hands.acts.values()) == TAPS
    assert hands.blank == []
    assert [said for said in hands.complaints if not REFUSED.match(said) and not UNREADABLE.match(said)] == []


def test_no_screen_contradicts_the_service_for_longer_than_two_seconds(hands: RandomHands):
    assert hands.contradictions == []


def test_a_release_is_asked_for_only_by_start_after_release(hands: RandomHands):
    assert hands.releases_without_start == []


def test_no_run_has_moved_without_a_release_that_stands_in_the_audit_log(hands: RandomHands, service: RealService):
    console = Console(service)
    wait_for(lambda: all(run["state"] != "Stopping" for run in listed(console)), "what is being stopped to be stopped")
    runs = listed(console)
    released = {entry["detail"]["run"] for entry in audited(console) if entry["action"] == "run.release"}
    assert runs
    for run in runs:
        moved = any(message["event"]["kind"] == "phase_started" for message in events(console, run["run"]))
        if moved or run["state"] not in NOT_RELEASED:
            assert run["run"] in released, (run["state"], run["reason"], moved)
            assert run["released_by"] in ("account:operator", f"account:{BEN}"), run
    console.leave()


def listed(console: Console) -> list[dict]:
    """All runs, newest first."""
    found: list[dict] = []
    older: dict[str, str] = {}
    while page := console.http.get("/api/runs", params={"limit": 500, **older}).json():
        found += page
        older = {"before": page[-1]["run"]}
    return found


def audited(console: Console) -> list[dict]:
    """All of the log, from its end."""
    found: list[dict] = []
    before = 2**53
    while page := console.http.get("/api/audit", params={"limit": 1000, "before": before}).json():
        found += page
        before = page[-1]["number"]
    return found


def events(console: Console, run: str) -> list[dict]:
    return list(console.http.get(f"/api/runs/{run}/events", params={"kind": "event"}).json())
