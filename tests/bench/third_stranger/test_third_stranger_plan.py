"""`bench.third_stranger.plan`: what is recorded stays what it was, and comes in many forms."""

from __future__ import annotations

from collections import Counter

from bench.third_stranger.plan import list_cases

BESIDE = {"sensor_interference", "sample_dropout", "payload_mismatch"}


def test_sixty_recordings_with_seeds_of_their_own() -> None:
    cases = list_cases()
    assert [case.number for case in cases] == [f"{number:03d}" for number in range(1, 61)]
    assert len({case.key for case in cases}) == 60
    assert Counter(case.order.kind for case in cases) == {"single": 33, "double": 9, "unknown": 9, "none": 9}
    assert sum(case.order.name in BESIDE for case in cases) == 3
    assert 15 <= sum(case.is_elastic for case in cases) <= 20


def test_every_cause_has_its_families_and_what_it_is_to_leave() -> None:
    for case in list_cases():
        order = case.order
        planted = len(order.makers) + sum(each is not None for each in (order.then, order.read, order.refer))
        assert planted == {"none": 0, "double": 2}.get(order.kind, 1)
        assert len(order.families) == (0 if order.kind == "unknown" else planted)
        assert len(order.wanted) == len(order.makers) + (order.then is not None)


def test_no_family_is_planted_alone_more_than_twice() -> None:
    singles = Counter(case.order.families for case in list_cases() if case.order.kind == "single")
    assert max(singles.values()) == 2


def test_a_third_or_so_comes_in_a_hard_form_of_every_kind() -> None:
    hard = Counter(case.order.kind for case in list_cases() if case.order.form.is_hard)
    assert 18 <= sum(hard.values()) <= 26
    assert set(hard) == {"single", "double", "unknown", "none"}
    streams = [case.order.form for case in list_cases() if not case.order.form.poses]
    assert {10, 20, 62.5, 125, 200, 333, 1000, 2000} <= {form.rate for form in streams}
