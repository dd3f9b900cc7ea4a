"""`bench.fifth_stranger.plan`: what is recorded stays what it was."""

from __future__ import annotations

from collections import Counter

from bench.fifth_stranger.machines import MACHINES
from bench.fifth_stranger.plan import list_cases

KINDS = {"single": 20, "double": 45, "unknown": 25, "none": 10}


def test_a_hundred_recordings_with_seeds_of_their_own() -> None:
    cases = list_cases()
    assert [case.number for case in cases] == [f"{number:03d}" for number in range(1, 101)]
    assert len({case.key for case in cases}) == 100
    assert Counter(case.order.kind for case in cases) == KINDS


def test_every_pair_is_of_two_families_that_no_other_pair_is_of_and_every_family_is_in_two() -> None:
    pairs = [case.order for case in list_cases() if case.order.kind == "double"]
    assert len({frozenset(order.families) for order in pairs}) == 45
    in_pairs = Counter(family for order in pairs for family in set(order.families))
    assert sum(in_pairs.values()) == 90
    assert len(in_pairs) == 24
    assert min(in_pairs.values()) == 2
    assert all(max(order.wanted) <= 4 * min(order.wanted) for order in pairs)


def test_no_cause_without_a_name_and_no_single_family_is_planted_twice() -> None:
    orders = [case.order for case in list_cases()]
    for kind in ("unknown", "single"):
        of_kind = [order.families or order.name for order in orders if order.kind == kind]
        assert len(set(of_kind)) == KINDS[kind]


def test_every_machine_is_sound_at_times_and_about_a_fifth_of_the_recordings_is_odd() -> None:
    orders = [case.order for case in list_cases()]
    assert {order.machine for order in orders if order.kind == "none"} == set(MACHINES)
    odd = Counter(order.kind for order in orders if order.is_odd)
    assert 16 <= sum(odd.values()) <= 26
    assert set(odd) == set(KINDS)
    assert not any(case.is_elastic for case in list_cases() if case.order.kind == "none")
