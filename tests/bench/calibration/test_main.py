"""What `--write` leaves where the diagnosis reads it, and where what ships comes from."""

from __future__ import annotations

from pathlib import Path

import pytest

from bench.calibration import __main__ as calibration
from core.gap.weighing import FILE, Block, Figures, read_figures
from tests.bench.calibration.test_learning import trial

SHIPPED = read_figures()
EARLIER = {
    "log_draws": 0.3291, "schwarz": 0.6892, "log_bent": -5.6287, "none": 1.8719, "further": 7.8197, "unknown": -0.4942,
    "unknown_left": 1.5211, "lapse": -1.3672, "lapse_left": 0.8745,
}  # fmt: skip
LATER = {"gap": (0.02, 34.97), "moved": (-1.52, 1.8), "reference": (-0.75, 5.3)}


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


@pytest.mark.parametrize(
    ("block", "value", "learnt_from", "versions"),
    [
        ("figures", EARLIER, 312, ("0.1.0+db1d0ed04f", "0.1.0+fa8238a499")),
        ("matters", LATER, 301, ("0.1.0+905424ea08",)),
        ("outside", 0.401, 301, ("0.1.0+905424ea08",)),
        ("widened", 1.27, 301, ("0.1.0+905424ea08",)),
    ],
)
def test_each_block_that_ships_says_which_learning_it_is_of(
    block: Block, value: object, learnt_from: int, versions: tuple[str, ...]
) -> None:
    """Of these values, as the repository's history has them; what is learnt anew says its own."""
    if getattr(SHIPPED, block) != value:
        return
    provenance = SHIPPED.learnt_apart.get(block, SHIPPED.provenance)
    assert (provenance.learnt_from, provenance.versions) == (learnt_from, versions)


def test_what_ships_is_written_as_both_learnings_write_it() -> None:
    assert SHIPPED.model_dump_json(indent=2) + "\n" == FILE.read_text(encoding="utf-8")
