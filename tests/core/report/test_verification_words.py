"""How well a motion is predicted stands in words with its numbers, at the terminal as on the page."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from html import unescape
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from core.cli.main import app
from core.cli.tables import verification_lines
from core.estimation.estimate import Identification, Verification
from core.estimation.identification import identify_recording
from core.estimation.result import SecondsPart, result_of
from core.recording.folder import write_recording
from core.recording.recording import Recording
from core.report.rows import unseen_rows
from core.report.verification_words import verification_sentence
from tests.synthetic import payload, record, run_of

EXPECTED = np.array([0.3, 0.3, 0.3, 0.02, 0.02, 0.02])


@pytest.fixture(scope="module")
def recording() -> Recording:
    return record(run_of("lwr4_bench", 0), payload("steel_block"), np.random.default_rng(0))


def found(recording: Recording, times: float) -> Identification:
    """An answer whose rotation about y was predicted with so many times the expected error."""
    left_out = Verification(phase="rotate:y", windows=40, rms=times * EXPECTED, noise=EXPECTED / 2, expected=EXPECTED)
    return replace(identify_recording(recording), verified=partial(tuple, [left_out]))


def test_a_sentence_says_what_was_seen_and_what_was_expected_of_force_and_torque() -> None:
    rms = np.array([0.0, 0.0, 0.6 * np.sqrt(3), 0.04 * np.sqrt(3), 0.0, 0.0])
    said = verification_sentence("rotate:y", rms, EXPECTED, 2.0)
    assert "rotation about y" in said
    assert "to 0.6 N and 0.04 N m (rms), 2.00 times the 0.3 N and 0.02 N m" in said


@pytest.mark.parametrize(("times", "holds"), [(0.9, True), (1.4, True), (2.5, False)])
def test_terminal_and_page_say_the_same_of_an_answer_and_the_page_marks_what_does_not_hold(
    times: float, holds: bool, recording: Recording
) -> None:
    answer = found(recording, times)
    [line] = verification_lines(result_of(answer, recording, seconds=SecondsPart(estimate=0.1)))
    assert ("the result holds on it" in line) == holds
    assert f"{times:.2f} times the 0.3 N" in line
    [row] = unseen_rows(answer)
    assert (row.sentence, row.alarm) == (line, not holds)


def test_nothing_is_said_where_nothing_was_left_out(recording: Recording) -> None:
    answer = replace(found(recording, 1.0), verified=tuple)
    assert verification_lines(result_of(answer, recording, seconds=SecondsPart(estimate=0.1))) == []
    assert unseen_rows(answer) == []


@pytest.mark.thorough
def test_identify_prints_it_and_its_report_shows_it(recording: Recording, tmp_path: Path) -> None:
    write_recording(recording, tmp_path / "recording")
    page = tmp_path / "page.html"
    said = CliRunner().invoke(app, ["identify", str(tmp_path / "recording"), "--report", str(page)])
    assert said.exit_code == 0, said.output
    lines = verification_lines(result_of(identify_recording(recording), recording, seconds=SecondsPart(estimate=0.1)))
    assert len(lines) == 3
    shown, printed = (" ".join(text.split()) for text in (unescape(page.read_text()), said.output))
    assert "Motions that the fit did not see" in shown
    for line in lines:
        assert line in shown
        assert line in printed
