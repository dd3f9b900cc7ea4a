"""`bench.second_stranger.plan`: what is recorded stays what it was."""

from __future__ import annotations

from collections import Counter

from bench.second_stranger.plan import list_cases


def test_seventy_two_recordings_with_seeds_of_their_own() -> None:
    cases = list_cases()
    assert [case.number for case in cases] == [f"{number:03d}" for number in range(1, 73)]
    assert len({case.key for case in cases}) == 72
    assert Counter(case.order.kind for case in cases) == {"single": 40, "double": 10, "unknown": 10, "none": 12}
    assert sum(case.is_elastic for case in cases) == 24
    by_number = {case.number: case.order.name for case in cases}
    assert (by_number["001"], by_number["034"], by_number["072"]) == ("drift_wander", "contact_once+shift_by_contact", "elast_hard")


def test_every_cause_has_its_families_and_what_it_is_to_leave() -> None:
    for case in list_cases():
        order = case.order
        planted = len(order.makers) + sum(each is not None for each in (order.then, order.read, order.refer))
        assert planted == {"none": 0, "double": 2}.get(order.kind, 1)
        assert len(order.families) == (0 if order.kind == "unknown" else planted)
        assert len(order.wanted) == len(order.makers) + (order.then is not None)
