"""A service with the built console, and the screens of the whole way, each looked at once."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from tests.server.real_service import Console, RealService, wait_for
from tests.web.patient_cells import console_service
from tests.web.tablet import chromium
from tests.web.way import Way, walked


@pytest.fixture(scope="package")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RealService]:
    with console_service(tmp_path_factory.mktemp("console")) as running:
        yield running


@pytest.fixture(autouse=True)
def nothing_left(request: pytest.FixtureRequest) -> Iterator[None]:
    """The next test finds a robot that stands still and no alarm, also after a test that failed half way."""
    service: RealService | None = request.getfixturevalue("service") if "service" in request.fixturenames else None
    yield
    if service is not None:
        last = Console(service)
        for run in last.http.get("/api/runs", params={"limit": 5}).json():
            if "stop" in run["commands"]:
                last.http.post(f"/api/runs/{run['run']}/commands", json={"command": "stop"})
        for alarm in last.http.get("/api/alarms/open").json():
            last.http.post(f"/api/alarms/{alarm['id']}/acknowledgement")
        last.http.delete("/api/session")
        last.leave()


@pytest.fixture
def person(service: RealService) -> Iterator[Console]:
    """Somebody at another screen, where nobody is in control any more, who leaves no run behind."""
    console = Console(service)
    wait_for(lambda: console.http.get(f"/api/control/{console.cell}").json()["holder"] is None, "nobody to be in control")
    yield console
    console.leave()


@pytest.fixture(scope="package")
def browser() -> Iterator[Browser]:
    with chromium() as found:
        yield found


@pytest.fixture(scope="package")
def way(service: RealService, browser: Browser) -> Way:
    return walked(service, browser)
