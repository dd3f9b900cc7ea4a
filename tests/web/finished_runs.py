"""Runs that are over, with made-up results, for screens that show them."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import timedelta
from pathlib import Path

import numpy as np

from core.cell.folder import load_cell
from core.estimation.result import ReferencePart, Result
from core.payload.uncertain_parameters import UncertainParameters
from core.requirement.answer import RequirementPart
from core.requirement.verdict import judge_estimate
from core.robot.model import RobotModel
from server.service import utc_now
from server.store.store import Store
from tests.core.export.cloud import cloud, covariance
from tests.core.export.known_result import answer
from tests.server.finished_run import finished_run
from tests.server.real_service import RealService

CELL = "lwr4_bench"
TOOL = "gripper"


def drawn_result(seed: int, *, heavier_kg: float = 0.0, worse: float = 1.0, judged: bool = False, referenced: bool = False) -> Result:
    """Of one tool as a run finds it, off by what it states; `worse` times less exactly, judged by the cell or not, with CAD or without."""
    whole = answer(cloud(0), CELL)
    assert whole.estimate is not None
    spread = worse**2 * covariance(0)
    phi = np.array(whole.estimate.phi) + np.random.default_rng(seed).multivariate_normal(np.zeros(10), covariance(0))
    phi[0] += heavier_kg
    known = UncertainParameters(phi, spread)
    estimate = whole.estimate.model_copy(update={
        "phi": phi.tolist(), "std": known.std.tolist(), "covariance": spread.tolist(),
        "com_m": known.com_m.tolist(), "com_std_m": known.com_std.tolist(),
        "inertia_com_kg_m2": known.inertia_com.tolist(), "inertia_com_std_kg_m2": known.inertia_com_std.tolist(),
    })  # fmt: skip
    reference = ReferencePart(phi=whole.estimate.phi, source="drawing 7") if referenced else None
    result = whole.model_copy(update={"payload": TOOL, "estimate": estimate, "reference": reference})
    return result.model_copy(update={"requirement": requirement_of(result)}) if judged else result


def requirement_of(result: Result) -> RequirementPart:
    """As a run judges its own."""
    assert result.estimate is not None
    cell = load_cell(Path(__file__).parents[2] / "cells" / CELL)
    return judge_estimate(cell, RobotModel.of_cell(cell), result.estimate)


def finished_runs(service: RealService, results: Sequence[Result]) -> list[str]:
    """A run a day with each result, the last one today, earliest first."""
    store, now = Store(service.store_url), utc_now()
    runs = [
        finished_run(store, now - timedelta(days=len(results) - 1 - k), result, cell=CELL, payload=TOOL) for k, result in enumerate(results)
    ]
    store.close()
    return runs
