"""`bench.stranger.sets`: recordings of each stranger are made in any process, and can be scored."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest

from bench.stranger.score import KINDS, Planted, find_kind
from bench.stranger.sets import SETS, Recording


@pytest.mark.parametrize(("of", "count"), [("first", 80), ("second", 72), ("third", 60), ("fourth", 48), ("fifth", 100)])
def test_every_recording_has_a_number_and_goes_to_another_process(of: str, count: int) -> None:
    recordings = SETS[of]()
    assert [each.number for each in recordings] == [f"{number:03d}" for number in range(1, count + 1)]
    sent: list[Recording] = pickle.loads(pickle.dumps(recordings))
    assert [each.name for each in sent] == [each.name for each in recordings]


@pytest.mark.parametrize("of", ["second", "third", "fourth"])
def test_the_truth_about_a_recording_of_another_stranger_can_be_scored(of: str, tmp_path: Path) -> None:
    recording = next(each for each in SETS[of]() if each.name == "payload_mismatch")
    truth = Planted.model_validate(recording.make(tmp_path))
    assert find_kind(truth) == KINDS[1]
    assert truth.families == ("payload_mismatch",)
