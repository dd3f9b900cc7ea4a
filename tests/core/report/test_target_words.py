"""The report says how far its result meets what was asked for."""

from __future__ import annotations

from pathlib import Path

import pytest

from core.report.page import write_report
from core.requirement.target import TargetCheck, parse_target
from core.requirement.target_answer import hold_against_target
from tests.core.report.test_page import case, words


@pytest.mark.parametrize(
    ("target", "language", "said"),
    [
        ("mass=50%", "en", "✓ Target reached."),
        ("mass=50%", "de", "✓ Ziel erreicht."),
        ("mass=0.00001%", "en", "▲ Target not reached (mass)"),
        ("mass=0.00001%", "de", "▲ Ziel nicht erreicht (Masse)"),
    ],
)
def test_what_was_asked_for_stands_below_the_result_with_its_sign(tmp_path: Path, target: str, language: str, said: str) -> None:
    recording, identification, run = case()
    met = hold_against_target(TargetCheck(parse_target(target)), identification.estimate)
    page = tmp_path / "report.html"
    write_report(page, recording=recording, identification=identification, run=run, target=met, language=language)  # type: ignore[arg-type]  # one of the two that there are
    assert said in words(page.read_text(encoding="utf-8"))


def test_a_result_without_a_target_says_nothing_of_one(tmp_path: Path) -> None:
    recording, identification, run = case()
    page = tmp_path / "report.html"
    write_report(page, recording=recording, identification=identification, run=run)
    assert "Target" not in words(page.read_text(encoding="utf-8"))
