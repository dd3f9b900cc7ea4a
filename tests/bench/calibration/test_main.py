"""What `--write` leaves where the diagnosis reads it, in the form that ships."""

from __future__ import annotations

from pathlib import Path

import pytest

from bench.calibration import __main__ as calibration
from core.gap.weighing import FILE, Figures, read_figures
from tests.bench.calibration.test_learning import trial

SHIPPED = read_figures()


def learn_anew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Figures:
    """What is there after a learning from eight trials."""
    trials = [trial(seed, ("a",) if seed % 2 else (), 1.0, 20.0) for seed in range(8)]
    (tmp_path / "trials.jsonl").write_text("".join(each.model_dump_json() + "\n" for each in trials))
    monkeypatch.setattr(calibration, "FILE", tmp_path / "probabilities.json")
    monkeypatch.setattr("sys.argv", ["calibration", str(tmp_path), "--count", "0", "--write"])
    calibration.main()
    return Figures.model_validate_json((tmp_path / "probabilities.json").read_text())


def test_a_learning_keeps_the_doubts_of_strangers_and_says_that_they_are_to_be_learnt_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    written = learn_anew(tmp_path, monkeypatch)
    assert written.figures != SHIPPED.figures
    assert SHIPPED.elsewhere is not None
    assert written.elsewhere == SHIPPED.elsewhere
    assert "bench.calibration.strangers" in capsys.readouterr().err


def test_a_learning_writes_one_provenance_for_all(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    written = learn_anew(tmp_path, monkeypatch)
    assert written.provenance.trials == 8
    assert written.learnt_apart == {}


def test_what_ships_is_written_as_both_learnings_write_it() -> None:
    assert SHIPPED.model_dump_json(indent=2) + "\n" == FILE.read_text(encoding="utf-8")
