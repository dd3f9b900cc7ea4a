"""What is offered where a sensor axis has no room."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from core.errors import NoPath, NoStartConfiguration
from core.events import Event
from core.planning.fewer_axes import axes_with_room
from core.planning.settings import Scope
from core.planning.start_configuration import UNREACHABLE


class Planner:
    """Refuses whatever has an axis without room, the first such axis by name."""

    def __init__(self, without_room: str) -> None:
        self.without_room = without_room
        self.asked: list[Scope] = []

    def __call__(self, scope: Scope) -> Iterator[Event]:
        self.asked.append(scope)
        for axis in scope.axes:
            if axis in self.without_room:
                raise NoStartConfiguration(f"{axis}+", {})
        yield from ()


@pytest.mark.parametrize(("without_room", "offered"), [("z", "xy"), ("xz", "y"), ("y", "xz"), ("xyz", "")])
def test_the_axes_that_are_offered_are_those_that_can_be_planned(without_room: str, offered: str) -> None:
    plan = Planner(without_room)
    with pytest.raises(NoStartConfiguration) as refused:
        list(plan(Scope()))
    assert axes_with_room(Scope(), refused.value, plan) == offered


def test_the_rest_stays_as_it_was_asked_for() -> None:
    plan = Planner("x")
    axes_with_room(Scope(rotations=False), NoStartConfiguration("x-", {}), plan)
    assert plan.asked == [Scope("yz", rotations=False)]


def test_who_is_refused_for_something_else_than_an_axis_is_offered_none() -> None:
    plan = Planner("")
    assert axes_with_room(Scope(), NoPath("text", text="the way home is blocked."), plan) == ""
    assert plan.asked == []


def test_a_refusal_names_the_option_that_would_work() -> None:
    refusal = NoStartConfiguration("z+", {UNREACHABLE: 3})
    assert "--axes" not in str(refusal)
    refusal.offer_axes("xy")
    assert str(refusal).endswith("There is a plan for the other sensor axes: --axes x,y.")
