"""Control passes from one screen to another: never to two, never back, and a robot that moves is supervised throughout."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import Bundle, RuleBasedStateMachine, consumes, invariant, precondition, rule, run_state_machine_as_test

from core.sessions.leased import LEASE_S, Lease, Renewal
from server.http.errors import Conflict
from server.runs.handover import PASS_S, RequestOutcome
from server.runs.lease import SETTLE_S, STAMP_PERIOD_S, ControlRegistry
from tests.hand_clock import HandClock

CELL = "line"


class Floor:
    """A cell with its robot, and the screens round it. Whatever renews control reaches the robot, as in the service."""

    def __init__(self) -> None:
        self.clock = HandClock()
        self.control = ControlRegistry(self.clock)
        self.robot = Lease(LEASE_S, self.clock, stopped=lambda _: False)
        self.fence = 0
        self.numbers: dict[int, int] = {}

    def next_fence(self) -> int:
        self.fence += 1
        return self.fence

    def take(self, who: str) -> int:
        return self.control.take(CELL, who, self.next_fence(), LEASE_S, f"screen of {who}").fence

    def ask(self, who: str) -> int:
        return self.control.ask(CELL, who, self.next_fence(), LEASE_S, f"screen of {who}").asker.fence

    def answer(self, who: str, fence: int, *, age_s: float = 0.0, back: int = 0) -> bool:
        """A stamp that a screen sends back: so old, and with a number that goes so far back."""
        number = self.numbers[fence] = self.numbers.get(fence, -1) + 1
        renewal = Renewal(fence, number - back, self.clock.now - age_s)
        renewed = self.control.renew(CELL, who, renewal)
        if renewed:
            self.robot.renew(renewal)
        return renewed

    def holder(self) -> tuple[str, int] | None:
        found = self.control.holder(CELL)
        return None if found is None else (found.who, found.fence)

    def last(self) -> RequestOutcome | None:
        found = self.control.last_request(CELL)
        return None if found is None else found.outcome


@pytest.fixture
def floor() -> Floor:
    """Anna is in control."""
    found = Floor()
    found.take("anna")
    assert found.answer("anna", 1)
    return found


def test_control_stays_where_it_is_until_it_is_accepted_and_passes_with_the_askers_next_answer(floor: Floor):
    ben = floor.ask("ben")
    assert not floor.answer("ben", ben)
    assert floor.holder() == ("anna", 1)
    floor.control.answer(CELL, "anna", 1, ben, accept=True)
    assert floor.holder() == ("anna", 1)
    floor.clock.now += STAMP_PERIOD_S
    assert floor.answer("ben", ben)
    assert floor.holder() == ("ben", ben)
    assert floor.last() is RequestOutcome.accepted
    assert not floor.answer("anna", 1)
    with pytest.raises(Conflict, match="ben has it"):
        floor.control.command(CELL, "anna", Renewal(1, 0, floor.clock.now))
    floor.control.command(CELL, "ben", Renewal(ben, 0, floor.clock.now))


def test_the_robots_lease_is_never_interrupted_by_a_handover(floor: Floor):
    """Both answer every 50 ms, whoever asks 200 ms late: the robot never sees an answer older than that, and takes no more of the first."""
    ben = floor.ask("ben")
    oldest_s = 0.0
    for tick in range(200):
        floor.clock.now += STAMP_PERIOD_S
        if tick == 40:
            floor.control.answer(CELL, "anna", 1, ben, accept=True)
        floor.answer("anna", 1)
        floor.answer("ben", ben, age_s=0.2)
        oldest_s = max(oldest_s, floor.robot.age_s)
        assert floor.robot.refusal() is None
    assert floor.holder() == ("ben", ben)
    assert floor.robot.fence == ben
    assert oldest_s <= 0.25 + 1e-9


def test_control_that_nobody_answers_for_passes_by_time_and_not_sooner(floor: Floor):
    ben = floor.ask("ben")
    begin_s = floor.clock.now
    while floor.clock.now - begin_s < PASS_S - 2 * STAMP_PERIOD_S:
        floor.clock.now += STAMP_PERIOD_S
        assert floor.answer("anna", 1)
        assert not floor.answer("ben", ben)
    floor.clock.now += 3 * STAMP_PERIOD_S
    assert floor.answer("anna", 1)
    assert floor.answer("ben", ben)
    assert floor.holder() == ("ben", ben)
    assert floor.last() is RequestOutcome.unanswered


def test_a_request_that_is_declined_or_withdrawn_changes_nothing(floor: Floor):
    first = floor.ask("ben")
    floor.control.answer(CELL, "anna", 1, first, accept=False)
    assert floor.last() is RequestOutcome.declined
    second = floor.ask("ben")
    floor.control.let_go(CELL, "ben", second)
    assert floor.last() is RequestOutcome.withdrawn
    for fence in (first, second):
        assert not floor.answer("ben", fence)
    assert floor.holder() == ("anna", 1)


def test_a_screen_that_asks_and_goes_silent_does_not_get_control(floor: Floor):
    ben = floor.ask("ben")
    floor.answer("ben", ben)
    floor.control.answer(CELL, "anna", 1, ben, accept=True)
    for _ in range(round(1.1 * SETTLE_S / 0.5)):
        floor.clock.now += 0.5
        floor.answer("anna", 1)
    assert floor.last() is RequestOutcome.silent
    assert not floor.answer("ben", ben)
    assert floor.holder() == ("anna", 1)


def test_control_that_is_let_go_of_or_lost_passes_to_whoever_asks(floor: Floor):
    ben = floor.ask("ben")
    floor.control.let_go(CELL, "anna", 1)
    assert floor.answer("ben", ben)
    assert floor.last() is RequestOutcome.vacant
    cleo = floor.ask("cleo")
    assert not floor.answer("cleo", cleo)
    floor.clock.now += 1.01 * LEASE_S
    assert floor.answer("cleo", cleo)
    assert floor.holder() == ("cleo", cleo)


def test_nobody_has_to_ask_themselves_for_control_of_another_screen(floor: Floor):
    again = floor.ask("anna")
    floor.clock.now += STAMP_PERIOD_S
    assert floor.answer("anna", 1)
    assert floor.answer("anna", again)
    assert floor.holder() == ("anna", again)
    assert floor.last() is RequestOutcome.own
    assert not floor.answer("anna", 1)


def test_one_person_asks_at_a_time_and_whoever_takes_control_makes_the_request_void(floor: Floor):
    ben = floor.ask("ben")
    with pytest.raises(Conflict, match="ben has asked for it"):
        floor.ask("cleo")
    fence = floor.take("anna")
    assert floor.last() is RequestOutcome.overtaken
    assert not floor.answer("ben", ben)
    assert floor.holder() == ("anna", fence)


def test_only_whoever_is_in_control_decides_and_only_about_the_request_that_was_shown(floor: Floor):
    ben = floor.ask("ben")
    for who, fence in (("ben", ben), ("cleo", 1), ("anna", 2)):
        with pytest.raises(Conflict):
            floor.control.answer(CELL, who, fence, ben, accept=True)
    later = floor.ask("ben")
    with pytest.raises(Conflict, match="any more"):
        floor.control.answer(CELL, "anna", 1, ben, accept=True)
    floor.control.answer(CELL, "anna", 1, later, accept=True)


def test_of_two_who_were_given_a_fence_at_the_same_time_the_older_one_does_not_come_second(floor: Floor):
    older, newer = floor.next_fence(), floor.next_fence()
    floor.control.take(CELL, "anna", newer, LEASE_S)
    with pytest.raises(Conflict, match="faster"):
        floor.control.take(CELL, "anna", older, LEASE_S)
    with pytest.raises(Conflict, match="faster"):
        floor.control.ask(CELL, "ben", older, LEASE_S)
    assert floor.holder() == ("anna", newer)


PEOPLE = st.sampled_from(["anna", "ben", "cleo"])
AGES_S = st.sampled_from([0.0, 0.05, 0.3, 0.9, 1.1, 2.5, -0.5])


class Handover(RuleBasedStateMachine):
    """Three people with as many screens as they like, in whatever order, over lines that delay, repeat and reorder."""

    given = Bundle("given")
    fences = Bundle("fences")

    def __init__(self) -> None:
        super().__init__()
        self.floor = Floor()
        self.owners: dict[int, str] = {}
        self.held: list[int] = []
        self.newest_stamp_s: dict[int, float] = {}
        self.newest_number: dict[int, int] = {}

    @rule(target=given)
    def give_a_fence(self) -> int:
        """Fences come from the database: of two requests at the same time the later one may be through first."""
        return self.floor.next_fence()

    @rule(target=fences, who=PEOPLE, fence=consumes(given))
    def take(self, who: str, fence: int) -> int:
        before, newest = self.floor.holder(), max(self.owners, default=0)
        self.owners[fence] = who
        try:
            self.floor.control.take(CELL, who, fence, LEASE_S)
        except Conflict:
            assert fence < newest or (before is not None and before[0] != who)
        else:
            assert before is None or before[0] == who
            assert self.floor.control.request(CELL) is None
        return fence

    @rule(target=fences, who=PEOPLE, fence=consumes(given))
    def ask(self, who: str, fence: int) -> int:
        before, asked, newest = self.floor.holder(), self.floor.control.request(CELL), max(self.owners, default=0)
        self.owners[fence] = who
        try:
            self.floor.control.ask(CELL, who, fence, LEASE_S)
        except Conflict:
            assert fence < newest or (asked is not None and asked.asker.who != who)
        assert self.floor.holder() == before
        return fence

    @rule(who=PEOPLE, fence=fences, asked=fences, accept=st.booleans())
    def decide(self, who: str, fence: int, asked: int, accept: bool) -> None:
        before = self.floor.holder()
        try:
            self.floor.control.answer(CELL, who, fence, asked, accept=accept)
        except Conflict:
            return
        assert before == (who, fence)
        assert self.floor.holder() == before

    @precondition(lambda self: self.floor.holder() is not None and self.floor.control.request(CELL) is not None)
    @rule(accept=st.booleans())
    def decide_as_shown(self, accept: bool) -> None:
        who, fence = self.floor.holder() or ("", 0)
        request = self.floor.control.request(CELL)
        assert request is not None
        with suppress(Conflict):  # of a holder who has not answered yet
            self.floor.control.answer(CELL, who, fence, request.asker.fence, accept=accept)

    @rule(who=PEOPLE, fence=fences)
    def let_go(self, who: str, fence: int) -> None:
        before = self.floor.holder()
        self.floor.control.let_go(CELL, who, fence)
        assert self.floor.holder() == (None if before == (who, fence) else before)

    @rule(fence=fences, age_s=AGES_S, back=st.sampled_from([0, 0, 0, 1, 3]))
    def answer(self, fence: int, age_s: float, back: int) -> None:
        """By the screen that was given the fence, whether or not it has control; stale answers are refused."""
        before, request = self.floor.holder(), self.floor.control.request(CELL)
        stamp_s, number = self.floor.clock.now - age_s, self.floor.numbers.get(fence, -1) + 1 - back
        renewed = self.floor.answer(self.owners[fence], fence, age_s=age_s, back=back)
        if not renewed:
            assert self.floor.holder() == before
            return
        assert 0.0 <= age_s < LEASE_S
        assert stamp_s > self.newest_stamp_s.get(fence, -1.0)
        assert number > self.newest_number.get(fence, -1)
        self.newest_stamp_s[fence], self.newest_number[fence] = stamp_s, number
        assert self.floor.holder() == (self.owners[fence], fence)
        if before != (self.owners[fence], fence) and request is not None and request.asker.fence == fence:
            assert self.floor.last() in {RequestOutcome.accepted, RequestOutcome.unanswered, RequestOutcome.vacant, RequestOutcome.own}

    @rule(fence=fences, other=PEOPLE)
    def answer_with_a_fence_of_somebody_else(self, fence: int, other: str) -> None:
        if other != self.owners[fence]:
            assert not self.floor.control.renew(CELL, other, Renewal(fence, 10**6, self.floor.clock.now))

    @rule(seconds=st.sampled_from([0.05, 0.3, 1.2, 4.0, 31.0]))
    def time_passes(self, seconds: float) -> None:
        self.floor.clock.now += seconds

    @rule(seconds=st.sampled_from([1.0, 4.0, 31.0]))
    def time_passes_while_the_screens_answer(self, seconds: float) -> None:
        """Whoever is in control, and whoever asks."""
        for _ in range(round(seconds / 0.5)):
            self.floor.clock.now += 0.5
            request, present = self.floor.control.request(CELL), self.floor.control.holder(CELL)
            for one in (present, None if request is None else request.asker):
                if one is not None:
                    self.answer(one.fence, 0.0, 0)

    @invariant()
    def one_at_most_is_in_control_and_may_command(self) -> None:
        present = self.floor.holder()
        allowed = []
        for fence, who in self.owners.items():
            try:
                self.floor.control.command(CELL, who, Renewal(fence, self._next_command(), self.floor.clock.now))
            except Conflict:
                continue
            allowed.append((who, fence))
        assert allowed in ([], [present])

    def _next_command(self) -> int:
        self.commands: int = getattr(self, "commands", 0) + 1
        return self.commands

    @invariant()
    def the_fence_of_control_and_of_the_robot_only_grows(self) -> None:
        present = self.floor.holder()
        if present is not None:
            assert not self.held or present[1] >= self.held[-1]
            self.held.append(present[1])
            assert self.floor.robot.fence <= present[1]

    @invariant()
    def whoever_asks_has_a_newer_fence_than_whoever_has_control(self) -> None:
        present, request = self.floor.holder(), self.floor.control.request(CELL)
        assert present is None or request is None or present[1] < request.asker.fence


def test_never_two_holders_a_fence_that_only_grows_and_no_stale_stamp_whatever_happens():
    careful: Any = settings(max_examples=150, stateful_step_count=40, deadline=None, derandomize=True, database=None)
    run_state_machine_as_test(Handover, settings=careful)
