"""`bench.fourth_stranger.plan`: what is recorded stays what it was, on every machine and in many forms."""

from __future__ import annotations

from collections import Counter

from bench.fourth_stranger.machines import MACHINES
from bench.fourth_stranger.plan import list_cases

BESIDE = {"sensor_interference", "payload_mismatch"}


def test_forty_eight_recordings_with_seeds_of_their_own() -> None:
    cases = list_cases()
    assert [case.number for case in cases] == [f"{number:03d}" for number in range(1, 49)]
    assert len({case.key for case in cases}) == 48
    assert Counter(case.order.kind for case in cases) == {"single": 26, "double": 8, "unknown": 8, "none": 6}
    assert sum(case.order.name in BESIDE for case in cases) == 2
    assert 8 <= sum(case.is_elastic for case in cases) <= 14


def test_every_cause_has_its_families_and_what_it_is_to_leave() -> None:
    for case in list_cases():
        order = case.order
        planted = len(order.makers) + sum(each is not None for each in (order.read, order.refer))
        assert planted == {"none": 0, "double": 2}.get(order.kind, 1)
        assert len(order.families) == (0 if order.kind == "unknown" else planted)
        assert len(order.wanted) == len(order.makers)


def test_no_family_is_planted_alone_more_than_once() -> None:
    singles = Counter(case.order.families for case in list_cases() if case.order.kind == "single")
    assert max(singles.values()) == 1


def test_every_machine_is_sound_at_times_and_half_of_the_recordings_are_odd() -> None:
    orders = [case.order for case in list_cases()]
    assert {order.machine for order in orders if order.kind == "none"} == set(MACHINES)
    odd = Counter(order.kind for order in orders if order.is_odd)
    assert 20 <= sum(odd.values()) <= 28
    assert set(odd) == {"single", "double", "unknown", "none"}
    assert {word for order in orders for word in order.form.words} >= {
        "poses without joints",
        "orientations alone",
        "uneven",
        "every other row from some time on",
        "epoch time",
        "noise not stated",
        "gravity a direction with a site",
        "single precision",
    }
