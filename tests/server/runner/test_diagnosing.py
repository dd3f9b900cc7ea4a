"""A diagnosis says where the gap is largest as soon as that is known, and its progress while it seeks the cause."""

from __future__ import annotations

from multiprocessing import Pipe
from pathlib import Path

import pytest

from core.effects.base_tilt import BaseTilt
from core.effects.time_delay import TimeDelay
from core.gap.basis import basis_of
from core.gap.evidence import gather
from core.gap.residual import Residual
from core.gap.windows import Windows
from core.recording.folder import read_recording
from core.words.message import Message
from server.runner.diagnosing import fit_with_progress
from server.runner.messages import Advanced
from tests.web.tilted import tilted_recording


@pytest.fixture(scope="module")
def windows(tmp_path_factory: pytest.TempPathFactory) -> Windows:
    folder: Path = tmp_path_factory.mktemp("tilted")
    tilted_recording(folder)
    return Windows(basis_of(read_recording(folder / "recording")))


def test_where_the_gap_is_largest_is_said_once_and_first_and_is_what_the_answer_says(windows: Windows) -> None:
    ours, theirs = Pipe(duplex=False)
    evidence = gather(windows, (BaseTilt(), TimeDelay()), fit_with_progress(theirs))
    words: list[Advanced] = []
    while ours.poll():
        words.append(ours.recv())
    first, *others = words
    assert first.told is not None
    assert Message.model_validate_json(first.told) == Residual(windows, evidence.nominal).describe()
    assert [word.told for word in others] == [None] * len(others)
    assert 0.0 == first.done < others[0].done <= others[-1].done < 1.0
