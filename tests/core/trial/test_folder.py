"""The folder of a run of trials survives being cut short."""

from __future__ import annotations

from pathlib import Path

import pytest

from core.errors import BadInput
from core.trial.draw import DrawnTrial
from core.trial.folder import OUTCOMES, SEALS, append, check_seals, open_folder, read_outcomes
from tests.core.trial.synthetic_outcomes import none, sealed, single


def drawn(seed: int, size: float = 1.0) -> DrawnTrial:
    """A trial of which nothing but the seal is used."""
    return DrawnTrial(None, None, sealed(seed, kind="none", size=size), None, ())  # type: ignore[arg-type]  # never run


def test_seals_stand_there_before_the_first_outcome(tmp_path: Path):
    open_folder(tmp_path / "run", [drawn(4), drawn(5)], {})
    assert (tmp_path / "run" / SEALS).read_text().splitlines() == [f"{k} {drawn(k).sealed.hash}" for k in (4, 5)]
    assert read_outcomes(tmp_path / "run") == {}


def test_seals_stand_there_once_however_often_a_run_goes_on(tmp_path: Path):
    for _ in range(3):
        open_folder(tmp_path, [drawn(4), drawn(5)], {4: none(4)} if (tmp_path / SEALS).exists() else {})
    assert (tmp_path / SEALS).read_text().splitlines() == [f"{k} {drawn(k).sealed.hash}" for k in (4, 5)]


def test_outcomes_come_back_as_they_were_written(tmp_path: Path):
    open_folder(tmp_path, [], {})
    written = [none(1), single(2, "time_delay", "base_tilt", gap_before=3.1)]
    for outcome in written:
        append(tmp_path, outcome)
    assert list(read_outcomes(tmp_path).values()) == written


def test_a_line_that_was_cut_off_is_dropped_and_run_again(tmp_path: Path):
    open_folder(tmp_path, [], {})
    append(tmp_path, none(1))
    append(tmp_path, none(2))
    file = tmp_path / OUTCOMES
    file.write_text(file.read_text()[:-20])
    done = read_outcomes(tmp_path)
    assert list(done) == [1]
    open_folder(tmp_path, [drawn(1), drawn(2)], done)
    append(tmp_path, none(2))
    assert list(read_outcomes(tmp_path)) == [1, 2]
    assert [line.split()[0] for line in (tmp_path / SEALS).read_text().splitlines()] == ["2"]


def test_outcomes_under_another_seal_do_not_belong_together():
    check_seals([drawn(1)], {1: none(1)})
    with pytest.raises(BadInput, match="seed 1"):
        check_seals([drawn(1, size=2.0)], {1: none(1)})


def test_a_folder_of_something_else_is_left_alone(tmp_path: Path):
    (tmp_path / "thesis.tex").write_text("")
    with pytest.raises(BadInput, match="not a run of trials"):
        read_outcomes(tmp_path)


def test_a_line_that_is_no_outcome_is_named(tmp_path: Path):
    (tmp_path / OUTCOMES).write_text("{}\n")
    with pytest.raises(BadInput, match="line 1"):
        read_outcomes(tmp_path)
