"""What an event of a run says of what is in its way."""

from __future__ import annotations

from core.events import Event, PhaseStarted, RobotStopped
from server.runner.live_schemas import WaitingForZone
from server.runs.steps import update_in_the_way
from tests.server.sentence import sentence

WAITING = WaitingForZone(message=sentence("no way"), in_the_way="operator")
GOING_ON = PhaseStarted(phase="transfer", toward="x+", step=2, steps=9)
STOPPED = RobotStopped(error="TooClose", message=sentence("too close"), restart=1, final=False)


def after_all(*events: Event) -> str | None:
    found = None
    for event in events:
        found = update_in_the_way(event, found)
    return found


def test_what_the_robot_waits_for_is_in_the_way_until_it_goes_on() -> None:
    assert after_all(STOPPED, WAITING) == "operator"
    assert after_all(STOPPED, WAITING, STOPPED) == "operator"
    assert after_all(STOPPED, WAITING, GOING_ON) is None
