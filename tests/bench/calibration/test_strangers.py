"""Doubts learnt from what strangers have made: right names that leave much are trusted more, and what others decided stays."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from bench.calibration import strangers
from bench.calibration.learning import PRIOR
from bench.calibration.strangers import Case, answer_again, can_teach, judge, learn_doubts, read_cases
from bench.stranger.answer import Answer, Weighed
from bench.stranger.score import Planted
from core.gap.weighing import DOUBTS, find_doubts, read_figures

FIGURES = read_figures().figures
ROWS = 6000


def weighed(name: str, left: float) -> Weighed:
    """Of a gap of 50, a fit that leaves so much."""
    effects = 0 if name == "none" else len(name.split("+"))
    return Weighed(name=name, effects=effects, free=3, rows=ROWS, chi_square=ROWS * (1.0 + left))


def case(number: int, kind: str, families: tuple[str, ...], left: float, verdict: str | None = None, stranger: str = "s") -> Case:
    """The fit of effect `a` leaves so much, that of `b` nearly all; answered by what trials have taught where nothing is said."""
    truth = Planted(kind=kind, families=families, variant="", visible_sigma=100.0)
    fits = (weighed("none", 50.0), weighed("a", left), weighed("b", 45.0))
    answer = Answer(
        case=f"{number:03d}", verdict="unknown", summary="", gap=(7.0, 1.0), none=0.0, unknown=0.5, effects=(), pairs=(), also=(),
        minor=(), tied=(), weighed=fits, cpu=1.0,
    )  # fmt: skip
    found = Case(truth, answer, stranger)
    decided = "unknown" if np.argmax(found.weigh(FIGURES)[1:]) == 0 else "explained"
    return found._replace(answer=answer.model_copy(update={"verdict": verdict or decided}))


def set_of(stranger: str) -> list[Case]:
    """Names are right up to what leaves a fifth of the gap, and what leaves more is unknown."""
    shares = np.geomspace(0.002, 0.9, 30)
    return [
        case(k, *(("single", ("a",)) if share < 0.2 else ("unknown", ())), left=50.0 * float(share), stranger=stranger)
        for k, share in enumerate(shares)
    ]


def test_where_right_names_leave_more_than_trials_let_expect_they_are_doubted_less() -> None:
    learnt = {**FIGURES, **learn_doubts(set_of("s"), FIGURES)}
    few = np.array([0.03, 0.08])
    assert np.all(find_doubts(few, learnt)[0] < find_doubts(few, FIGURES)[0])
    assert float(find_doubts(np.array(0.8), learnt)[0]) > 0.5


def test_nothing_learnt_is_what_trials_have_taught() -> None:
    silent = [case(0, "single", ("a",), left=0.0)]
    assert learn_doubts(silent, FIGURES) == pytest.approx({name: FIGURES.get(name, PRIOR[name][0]) for name in DOUBTS}, abs=0.1)


def test_an_answer_that_contacts_or_left_out_motions_decided_teaches_nothing_and_stays() -> None:
    touched = case(0, "single", ("a",), left=40.0, verdict="explained")
    assert not can_teach(touched, FIGURES)
    sure = {**FIGURES, "unknown": -9.0, "unknown_left": 0.0}
    assert answer_again(touched, FIGURES, sure) == touched.answer
    open_one = case(1, "single", ("a",), left=40.0)
    assert can_teach(open_one, FIGURES) and open_one.answer.verdict == "unknown"
    assert answer_again(open_one, FIGURES, sure).named == "a"


def test_what_is_read_off_beside_the_wrench_or_found_not_to_matter_teaches_nothing() -> None:
    assert not can_teach(case(0, "single", ("sensor_noise",), left=1.0), FIGURES)
    assert not can_teach(case(0, "none", (), left=1.0), FIGURES)
    assert not can_teach(case(0, "single", ("a",), left=0.0, verdict="no_gap"), FIGURES)


def test_each_stranger_is_judged_by_what_the_others_teach() -> None:
    cases = [*set_of("s"), *set_of("t")]
    before = judge(cases, FIGURES, dict.fromkeys(("s", "t"), FIGURES))
    learnt = {**FIGURES, **learn_doubts(set_of("s"), FIGURES)}
    after = judge(cases, FIGURES, {"s": learnt, "t": learnt})
    kind = "single in the wrench"
    assert after[kind] > before[kind]
    assert after["log_loss"] < before["log_loss"]
    assert after[f"{kind}, of"] == sum(each.truth.kind == "single" for each in cases)


def test_folders_are_read_and_what_they_teach_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for stranger in ("s", "t"):
        folder = tmp_path / stranger
        folder.mkdir()
        cases = set_of(stranger)
        (folder / "truth.json").write_text(json.dumps({each.answer.case: each.truth.model_dump() for each in cases}))
        (folder / "diagnoses.jsonl").write_text("".join(each.answer.model_dump_json() + "\n" for each in cases))
    assert [each.answer for each in read_cases(tmp_path / "s")] == [each.answer for each in set_of("s")]
    monkeypatch.setattr(strangers, "FILE", tmp_path / "probabilities.json")
    monkeypatch.setattr("sys.argv", ["strangers", str(tmp_path / "s"), str(tmp_path / "t"), "--write"])
    strangers.main()
    written = json.loads((tmp_path / "probabilities.json").read_text())
    assert written["figures"] == FIGURES
    assert written["learnt_apart"] == read_figures().model_dump(mode="json")["learnt_apart"]
    assert set(written["elsewhere"]["doubts"]) == set(DOUBTS)
    assert written["elsewhere"]["recordings"] == 60


def test_one_stranger_alone_cannot_be_judged(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.argv", ["strangers", str(tmp_path)])
    with pytest.raises(SystemExit, match="at least 2"):
        strangers.main()
