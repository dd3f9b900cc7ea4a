"""`heft trial` from end to end."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from core.cli.main import app
from core.cli.trials import seeds_of
from core.errors import BadInput
from core.trial.draw import draw
from core.trial.folder import read_outcomes
from core.trial.judgement import right


def test_seeds_are_numbers_and_ranges_each_once():
    assert seeds_of("300, 305,303-306") == [300, 305, 303, 304, 306]
    for text in ("", "3x", "4-", "-4", "1,,2"):
        with pytest.raises(BadInput, match="--seeds"):
            seeds_of(text)


@pytest.mark.thorough
def test_trials_are_sealed_answered_kept_and_scored_and_a_finished_run_is_not_run_again(tmp_path: Path):
    short = [drawn.sealed for drawn in map(draw, range(300, 1000)) if drawn.plan.robot_s < 45.0]
    first = next(sealed.seed for sealed in short if sealed.kind == "none")
    second = next(s.seed for s in short if [(name, variant) for name, variant, _ in s.planted] == [("time_delay", "constant")])
    arguments = ["trial", "--seeds", f"{first},{second}", "--report", str(tmp_path / "run"), "--keep", str(tmp_path / "kept")]
    said = CliRunner().invoke(app, arguments)
    assert said.exit_code == 0, said.output
    lines = said.output.splitlines()
    assert lines[1] == f"trial {second}: sealed {draw(second).sealed.hash}"
    outcomes = read_outcomes(tmp_path / "run")
    assert right(outcomes[first])
    assert outcomes[first].verdict == "no_gap"
    delay = outcomes[second]
    assert (delay.bound.fault_sigma or 0.0) > 3.0
    assert delay.truth["time_delay"]["delay_s"] > 0.0
    assert abs(sum(effect.probability for effect in delay.effects) + delay.none_probability + delay.unknown_probability
               + sum(p for _, p in delay.pairs) - 1.0) < 1e-6  # fmt: skip
    assert (tmp_path / "kept" / str(second) / "samples.parquet").exists()
    before = (tmp_path / "run" / "trials.jsonl").read_bytes()
    again = CliRunner().invoke(app, [*arguments[:5]])
    assert again.exit_code == 0
    assert (tmp_path / "run" / "trials.jsonl").read_bytes() == before
    assert "sealed" not in again.output.split("# Blind trials")[0]


def test_a_recording_that_is_there_already_is_not_overwritten(tmp_path: Path):
    (tmp_path / "7").mkdir()
    said = CliRunner().invoke(app, ["trial", "--seed", "7", "--keep", str(tmp_path)])
    assert isinstance(said.exception, BadInput)
