"""The sets of recordings that the command makes and diagnoses, each by a stranger of its own."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import NamedTuple

from bench.fifth_stranger import plan as fifth_plan
from bench.fourth_stranger import making as fourth_making
from bench.fourth_stranger import plan as fourth_plan
from bench.second_stranger import making as second_making
from bench.second_stranger import plan as second_plan
from bench.stranger import making, plan
from bench.stranger.making import Truth
from bench.third_stranger import making as third_making
from bench.third_stranger import plan as third_plan


class Recording(NamedTuple):
    """One of a set: the number of its folder, what is planted, joined by plus signs, and what writes a folder and tells the truth."""

    number: str
    name: str
    make: Callable[[Path], Truth]


def list_first() -> list[Recording]:
    """By number."""
    return [Recording(case.number, case.order.name, partial(making.make_case, case)) for case in plan.list_cases()]


def list_second() -> list[Recording]:
    """By number."""
    return [Recording(case.number, case.order.name, partial(second_making.make_case, case)) for case in second_plan.list_cases()]


def list_third() -> list[Recording]:
    """By number."""
    return [Recording(case.number, case.order.name, partial(third_making.make_case, case)) for case in third_plan.list_cases()]


def list_fourth() -> list[Recording]:
    """By number."""
    return [Recording(case.number, case.order.name, partial(fourth_making.make_case, case)) for case in fourth_plan.list_cases()]


def list_fifth() -> list[Recording]:
    """By number."""
    return [Recording(case.number, case.order.name, partial(fourth_making.make_case, case)) for case in fifth_plan.list_cases()]


SETS = {"first": list_first, "second": list_second, "third": list_third, "fourth": list_fourth, "fifth": list_fifth}
"""By the stranger."""
