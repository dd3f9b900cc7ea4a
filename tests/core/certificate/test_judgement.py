"""The statement of conformity is that of `core.requirement`, and never made where it cannot be."""

from __future__ import annotations

from pathlib import Path

import pytest

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.certificate.judgement import state_conformity
from core.estimation.result import Result
from tests.core.export.cloud import cloud
from tests.core.export.known_result import answer

CELLS = Path(__file__).parents[3] / "cells"


@pytest.fixture(scope="module")
def cell() -> Cell:
    return load_cell(CELLS / "lwr4_bench")


def widened(by: float) -> Result:
    result = answer(cloud(0), "lwr4_bench")
    assert result.estimate is not None
    covariance = [[by**2 * (each or 0.0) for each in row] for row in result.estimate.covariance]
    return result.model_copy(update={"estimate": result.estimate.model_copy(update={"covariance": covariance})})


def test_values_conform_until_their_uncertainty_has_grown_by_the_margin(cell: Cell) -> None:
    first = state_conformity(widened(1.0), cell)
    assert first.conforms and first.assumed and first.margin is not None and first.criterion is not None and first.decides is not None
    assert first.statement.code == "requirement-good-enough"
    assert first.rule is not None and first.rule.parameters["risk"] == pytest.approx(0.05)
    then = state_conformity(widened(1.02 * first.margin), cell)
    assert then.conforms is False
    assert then.used == pytest.approx(1.02, rel=0.01)


def test_without_a_cell_or_all_ten_parameters_no_statement_is_made_and_the_reason_given(cell: Cell) -> None:
    result = answer(cloud(0), "lwr4_bench")
    assert result.estimate is not None
    partly = result.estimate.model_copy(update={"determined": [True] * 4 + [False] * 6})
    for found, code in (
        (state_conformity(result, None), "certificate-no-cell"),
        (state_conformity(result.model_copy(update={"estimate": None}), cell), "certificate-nothing-identified"),
        (state_conformity(result.model_copy(update={"estimate": partly}), cell), "requirement-not-determined"),
    ):
        assert (found.conforms, found.rule, found.margin) == (None, None, None)
        assert found.statement.code == code


def test_a_cell_whose_robot_cannot_be_used_is_named_as_the_reason(cell: Cell) -> None:
    broken = cell.model_copy(update={"robot": cell.robot.model_copy(update={"sensor_frame": "nowhere"})})
    found = state_conformity(widened(1.0), broken)
    assert (found.conforms, found.statement.code) == (None, "certificate-not-judged")
    assert "nowhere" in found.statement.text
