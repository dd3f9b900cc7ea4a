"""A slower run than the cell allows, and never a faster one."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.cell.folder import load_cell
from core.errors import BadInput
from core.planning.slow_run import SLOWEST_M_S, limit_speed

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
LIMIT_M_S = CELL.limits.cartesian_speed_m_s


@given(st.floats(SLOWEST_M_S, LIMIT_M_S))
def test_only_the_speed_changes(speed_m_s: float) -> None:
    slow = limit_speed(CELL, speed_m_s, "--speed")
    assert slow.limits.cartesian_speed_m_s == speed_m_s
    assert limit_speed(slow, speed_m_s, "--speed").model_dump() == slow.model_dump()
    back = slow.model_copy(update={"limits": CELL.limits})
    assert back == CELL


@given(st.one_of(st.floats(max_value=SLOWEST_M_S, exclude_max=True), st.floats(LIMIT_M_S, exclude_min=True), st.just(float("nan"))))
def test_faster_than_the_cell_or_no_speed_at_all_is_refused_with_the_limit(speed_m_s: float) -> None:
    with pytest.raises(BadInput, match=rf"--speed: found .* m/s, expected 0\.01 to {LIMIT_M_S:g} m/s, the limit of the cell"):
        limit_speed(CELL, speed_m_s, "--speed")


def test_nothing_said_is_the_cells_own() -> None:
    assert limit_speed(CELL, None, "--speed") is CELL
