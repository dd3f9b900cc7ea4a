"""A generator of events is driven to its end by one function."""

from __future__ import annotations

from collections.abc import Generator

import pytest

from core.events import drive


def counting(upto: int, ended: list[str]) -> Generator[int, None, str]:
    """Numbers below `upto`, then a word; `ended` gets what ended it."""
    try:
        yield from range(upto)
    except GeneratorExit:
        ended.append("closed")
        raise
    except ValueError as error:
        ended.append(str(error))
        yield -1
    return "done"


def test_each_event_is_told_and_what_the_run_returns_is_returned() -> None:
    told: list[int] = []
    assert drive(counting(3, []), told.append) == "done"
    assert told == [0, 1, 2]
    assert drive(counting(3, [])) == "done"


def test_who_is_told_may_throw_into_the_run_which_goes_on_from_there() -> None:
    ended: list[str] = []
    run = counting(3, ended)

    def tell(number: int) -> None:
        if number == 1:
            assert run.throw(ValueError("enough")) == -1

    assert drive(run, tell) == "done"
    assert ended == ["enough"]


def test_a_run_is_closed_when_telling_fails() -> None:
    ended: list[str] = []

    def tell(number: int) -> None:
        raise OSError(number)

    with pytest.raises(OSError, match="0"):
        drive(counting(3, ended), tell)
    assert ended == ["closed"]
