"""A console on a Wi-Fi whose connection breaks keeps control with its fence, and a run that was held for it goes on after one tap."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from tests.server.real_service import Console, RealService, wait_for
from tests.server.wifi_line import GOOD, WifiLine


@pytest.fixture
def far(real: RealService) -> Iterator[Console]:
    """In control, over a Wi-Fi."""
    with WifiLine(real.port, GOOD) as line:
        person = Console(real, address=line.address)
        person.returning.set()
        person.take_control()
        yield person
        person.http.delete(f"/api/control/{person.cell}")
        person.leave()


def events(person: Console, run: str, kind: str) -> list[dict[str, Any]]:
    return [each["event"] for each in person.http.get(f"/api/runs/{run}/events?kind=event").json() if each["event"]["kind"] == kind]


def test_a_lease_that_broke_is_opened_again_with_the_fence_it_had(far: Console):
    broken, fence = far.lease, far.fence
    assert broken is not None
    broken.close()
    wait_for(lambda: far.lease is not broken and far.linked, "the lease to be opened again")
    found = far.http.get(f"/api/control/{far.cell}").json()
    assert (found["holder"], found["fence"]) == ("account:operator", fence)


@pytest.mark.thorough
def test_a_run_that_was_held_for_a_silent_console_goes_on_after_one_tap_and_comes_through(far: Console):
    run = far.queue()
    far.wait(run, "Idle")
    assert far.release(run).status_code == 200
    far.wait_moving(run)
    far.answering.clear()
    held = far.wait(run, "Held")
    assert held["lateness"]["cause"] == "network"
    assert held["lateness"]["late_s"] > held["lateness"]["limit_s"]
    far.answering.set()
    wait_for(lambda: far.command(run, "resume").status_code == 200, "control to be back")
    assert far.wait(run, "Complete", "Aborted", "Stopped", "Held")["state"] == "Complete"
    assert [(stop["held"], stop["lateness"]["cause"]) for stop in events(far, run, "robot_stopped")] == [(True, "network")]
