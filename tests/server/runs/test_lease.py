"""One person at a time is in control of a cell, and only as long as their screen answers."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from core.sessions.leased import LEASE_S, Renewal
from server.http.errors import Conflict
from server.runs.lease import COMMAND_AGE_S, SETTLE_S, ControlRegistry, next_fence
from server.settings import Settings
from tests.hand_clock import HandClock
from tests.server.kept import Kept, kept
from tests.server.made_people import Clock


@pytest.fixture
def clock() -> HandClock:
    return HandClock()


@pytest.fixture
def control(clock) -> ControlRegistry:
    return ControlRegistry(clock)


@pytest.fixture
def service(settings: Settings) -> Iterator[Kept]:
    with kept(settings, Clock()) as found:
        yield found


def taken(service: Kept, control: ControlRegistry, who: str) -> int:
    with service.store.write() as db:
        return control.take("line", who, next_fence(db, "line"), LEASE_S).fence


def test_a_second_person_has_to_wait_until_the_first_has_gone_silent(service, control, clock):
    first = taken(service, control, "anna")
    assert control.renew("line", "anna", Renewal(first, 0, clock.now))
    with pytest.raises(Conflict, match="anna has it"):
        taken(service, control, "ben")
    clock.now += 1.01 * LEASE_S
    assert control.holder("line") is None
    assert taken(service, control, "ben") == first + 1
    assert not control.renew("line", "anna", Renewal(first, 1, clock.now))


def test_control_that_is_never_answered_ends(service, control, clock):
    taken(service, control, "anna")
    clock.now += 1.01 * SETTLE_S
    assert control.holder("line") is None


def test_fences_never_count_back_also_not_in_a_new_service(service, control, clock):
    fences = [taken(service, control, "anna") for _ in range(3)]
    assert fences == sorted(set(fences))
    assert taken(service, ControlRegistry(clock), "anna") > fences[-1]


def test_answers_that_are_repeated_reordered_old_foreign_or_from_the_future_renew_nothing(service, control, clock):
    fence = taken(service, control, "anna")
    assert control.renew("line", "anna", Renewal(fence, 5, clock.now))
    clock.now += 0.05
    for who, wrong in (
        ("anna", Renewal(fence, 5, clock.now)),
        ("anna", Renewal(fence, 4, clock.now)),
        ("anna", Renewal(fence, 6, clock.now - LEASE_S)),
        ("anna", Renewal(fence, 6, clock.now + 1.0)),
        ("anna", Renewal(fence - 1, 6, clock.now)),
        ("ben", Renewal(fence, 6, clock.now)),
    ):
        assert not control.renew("line", who, wrong), wrong
    assert control.renew("line", "anna", Renewal(fence, 6, clock.now))


def test_a_command_counts_once_in_order_and_only_while_it_is_fresh(service, control, clock):
    fence = taken(service, control, "anna")
    with pytest.raises(Conflict, match="answer its stamps"):
        control.command("line", "anna", Renewal(fence, 0, clock.now))
    assert control.renew("line", "anna", Renewal(fence, 0, clock.now))
    control.command("line", "anna", Renewal(fence, 1, clock.now))
    for wrong, why in (
        (Renewal(fence, 1, clock.now), "repeated or out of order"),
        (Renewal(fence, 0, clock.now), "repeated or out of order"),
        (Renewal(fence, 2, clock.now + 1.0), "stamp"),
        (Renewal(fence, 2, clock.now - 1.01 * COMMAND_AGE_S), "stamp"),
        (Renewal(fence + 1, 2, clock.now), "fence"),
    ):
        with pytest.raises(Conflict, match=why):
            control.command("line", "anna", wrong)
    with pytest.raises(Conflict, match="fence"):
        control.command("line", "ben", Renewal(fence, 2, clock.now))
    control.command("line", "anna", Renewal(fence, 2, clock.now))


def test_letting_go_with_an_old_fence_takes_nothing_from_the_present_holder(service, control, clock):
    old = taken(service, control, "anna")
    new = taken(service, control, "anna")
    control.let_go("line", "anna", old)
    control.let_go("line", "ben", new)
    assert control.holder("line") is not None
    control.let_go("line", "anna", new)
    assert control.holder("line") is None


def test_a_connection_that_was_lost_goes_on_with_its_fence_as_long_as_nobody_else_has_taken_control(service, control, clock):
    fence = taken(service, control, "anna")
    assert control.renew("line", "anna", Renewal(fence, 0, clock.now))
    clock.now += 60.0
    assert control.holder("line") is None
    assert control.unattended_s("line") == pytest.approx(60.0 - LEASE_S)
    assert control.renew("line", "anna", Renewal(fence, 1, clock.now))
    assert control.holder("line").fence == fence
    assert control.unattended_s("line") is None


@pytest.mark.parametrize("lease_s", [0.3, 5.0])
def test_control_lasts_as_long_as_the_lease_of_its_cell(control, clock, lease_s):
    control.take("line", "anna", 1, lease_s)
    assert control.renew("line", "anna", Renewal(1, 0, clock.now))
    clock.now += 0.99 * lease_s
    assert control.holder("line") is not None
    clock.now += 0.02 * lease_s
    assert control.holder("line") is None
