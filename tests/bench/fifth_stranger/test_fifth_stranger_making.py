"""`bench.fifth_stranger.plan`: a case is the same whenever it is made, and what is planted is to be seen as is wanted."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet as pq

from bench.fifth_stranger.plan import list_cases
from bench.fourth_stranger.making import make_case
from bench.fourth_stranger.plan import Case


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
