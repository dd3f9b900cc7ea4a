"""How much is searched: never less with more effort, and always beginning the same."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from core.planning.effort import PATH_ITERATIONS, grid_rounds, path_iterations
from core.planning.settings import MAX_EFFORT
from core.planning.start_configuration import Grid

EFFORTS = st.integers(1, MAX_EFFORT)


@given(EFFORTS)
def test_so_much_more_effort_searches_at_least_so_much_more(effort: int) -> None:
    assert effort <= sum(path_iterations(effort)) / sum(PATH_ITERATIONS) < 2 * effort
    candidates = sum(2**k for k in range(grid_rounds(effort))) / sum(2**k for k in range(Grid().rounds))
    assert candidates >= effort


@given(EFFORTS, EFFORTS)
def test_more_effort_begins_with_what_less_effort_does(less: int, more: int) -> None:
    less, more = sorted((less, more))
    assert path_iterations(more)[: len(path_iterations(less))] == path_iterations(less)
    assert grid_rounds(more) >= grid_rounds(less)


def test_the_usual_effort_is_the_usual_search() -> None:
    assert path_iterations(1) == PATH_ITERATIONS
    assert grid_rounds(1) == Grid().rounds
