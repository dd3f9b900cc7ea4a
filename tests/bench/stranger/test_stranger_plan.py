"""`bench.stranger.plan`: what is recorded stays what it was."""

from __future__ import annotations

from collections import Counter

from bench.stranger.plan import list_cases


def test_eighty_recordings_with_seeds_of_their_own() -> None:
    cases = list_cases()
    assert [case.number for case in cases] == [f"{number:03d}" for number in range(1, 81)]
    assert len({case.seed for case in cases}) == 80
    assert Counter(case.order.kind for case in cases) == {"single": 50, "double": 10, "unknown": 10, "none": 10}
    by_number = {case.number: case.order.name for case in cases}
    assert (by_number["001"], by_number["033"], by_number["060"]) == ("follow_air_conditioning", "rub", "give_under_load")
