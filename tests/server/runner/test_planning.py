"""The planning process keeps nothing of its maker's open."""

from __future__ import annotations

from multiprocessing import get_context

import pytest

from core.planning.stops import PROCEDURE
from server.runner.planning import PlanningProcess


def test_who_waits_for_the_makers_end_does_not_wait_for_the_planner() -> None:
    waiting, makers = get_context("fork").Pipe()
    planning = PlanningProcess(PROCEDURE, makers)
    makers.close()
    try:
        assert waiting.poll(20.0)
        with pytest.raises(EOFError):
            waiting.recv()
    finally:
        planning.close()
