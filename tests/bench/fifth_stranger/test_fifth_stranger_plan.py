"""`bench.fifth_stranger.plan`: what is recorded stays what it was, is the same whenever it is made, and is to be seen as is wanted."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet as pq

from bench.fifth_stranger.machines import MACHINES
from bench.fifth_stranger.plan import list_cases
from bench.fourth_stranger.making import make_case
from bench.fourth_stranger.plan import Case

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


def find_case(name: str) -> Case:
    return next(case for case in list_cases() if case.order.name == name)


def test_a_pair_is_made_whole_and_the_same_again_and_both_of_it_count(tmp_path: Path) -> None:
    case = find_case("delay_queue+gain_aged")
    truth: dict[str, Any] = make_case(case, tmp_path / "once")
    assert truth == make_case(case, tmp_path / "again")
    for file in ("recording.json", "samples.parquet", "robot.urdf"):
        assert (tmp_path / "once" / file).read_bytes() == (tmp_path / "again" / file).read_bytes()
    np.testing.assert_allclose(truth["rms_each"], case.order.wanted, rtol=0.15)
    assert min(truth["rms_beside_the_other"]) > 1.5
    assert truth["families"] == ["time_delay", "sensor_gain"]
    table = pq.read_table(tmp_path / "once" / "samples.parquet")
    assert table.num_rows == truth["rows"]
    assert all(np.all(np.isfinite(table[column].to_numpy())) for column in table.schema.names if column != "phase")


def test_nothing_but_the_background_is_in_a_sound_one(tmp_path: Path) -> None:
    truth: dict[str, Any] = make_case(find_case("none1"), tmp_path)
    assert truth["families"] == []
    assert truth["visible_sigma"] == 0
    assert truth["background_rms_excess"] < 0.6
