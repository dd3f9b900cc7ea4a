"""The report says whether its result is good enough, with a sign, and by what that was judged."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from core.report.page import write_report
from core.requirement.answer import RequirementPart
from core.requirement.verdict import judge_estimate
from core.robot.model import RobotModel
from tests.core.report.test_page import CELL, case, words

ROBOT = RobotModel.of_cell(CELL)


def verdict(widened: float) -> RequirementPart:
    _, identification, _ = case()
    estimate = identification.estimate
    assert estimate is not None

    class Widened:
        phi, determined, covariance = estimate.phi, np.ones(10, dtype=bool), np.diag((widened * estimate.std) ** 2)

    return judge_estimate(CELL, ROBOT, Widened())


@pytest.mark.parametrize(
    ("widened", "language", "said"),
    [
        (1.0, "en", "✓ Good enough for this cell:"),
        (1.0, "de", "✓ Genau genug für diese Zelle:"),
        (1e4, "en", "▲ Not good enough for this cell:"),
        (1e4, "de", "▲ Nicht genau genug für diese Zelle:"),
    ],
)
def test_the_verdict_stands_below_the_result_with_its_sign(tmp_path: Path, widened: float, language: str, said: str) -> None:
    recording, identification, run = case()
    page = tmp_path / "report.html"
    write_report(page, recording=recording, identification=identification, run=run, requirement=verdict(widened), language=language)
    text = page.read_text(encoding="utf-8")
    assert said in words(text)
    assert ('class="enough alarm"' in text) == (widened > 1.0)
    assert "20 N" in text  # assumed, and said so


def test_what_cannot_be_judged_says_why_without_an_alarm(tmp_path: Path) -> None:
    recording, identification, run = case()
    page = tmp_path / "report.html"
    write_report(page, recording=recording, identification=identification, run=run, requirement=judge_estimate(CELL, ROBOT, None))
    assert "? Whether it is good enough cannot be judged: no payload was identified." in words(page.read_text(encoding="utf-8"))


def test_without_a_cell_nothing_is_said(tmp_path: Path) -> None:
    recording, identification, run = case()
    page = tmp_path / "report.html"
    write_report(page, recording=recording, identification=identification, run=run)
    assert "ood enough" not in words(page.read_text(encoding="utf-8"))
