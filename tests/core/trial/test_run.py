"""`core.trial.run`: a trial that is cut short can be made again."""

from __future__ import annotations

from pathlib import Path
from typing import NoReturn

import numpy as np
import pytest

from core.trial.draw import draw
from core.trial.run import run_trial
from tests.synthetic import payload, record, run_of


def test_a_trial_that_is_cut_short_leaves_no_recording_in_the_way_of_its_next_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made = record(run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0))

    def cut_short(*_: object, **__: object) -> NoReturn:
        assert not list(tmp_path.iterdir())
        raise KeyboardInterrupt

    monkeypatch.setattr("core.trial.run.record_procedure", lambda *_: made)
    monkeypatch.setattr("core.trial.run.examine", cut_short)
    with pytest.raises(KeyboardInterrupt):
        run_trial(draw(300), tmp_path)
    assert not list(tmp_path.iterdir())
