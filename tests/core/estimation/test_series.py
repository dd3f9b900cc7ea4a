"""`core.estimation.series`: what stays the same from run to run is shared by the runs of a series."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.estimation.budget_part import BudgetPart, SourcePart
from core.estimation.result import Result
from core.estimation.series import measure_result
from core.payload.random_effects import difference_covariance
from core.words.message import Message
from tests.core.export.cloud import cloud
from tests.core.export.known_result import answer

STD = np.array([1e-4, *[3e-5] * 3, *[5e-6] * 6])
PULL = 10.0 * STD
"""What one joint's zero moves the parameters by: far more than they scatter."""


def run(phi: Array, directions: Array, name: str = "joint_zeros") -> Result:
    """An answer of a plan on which the zeros act by `directions` (n, 10)."""
    known = answer(cloud(0), "ur5e_line")
    assert known.estimate is not None
    nothing: list[float | None] = []
    source = SourcePart(
        name=name, title=Message.of("text", text=name), stated=True, std=nothing, com_std_m=nothing, inertia_com_std_kg_m2=nothing,
        directions=directions.tolist(),
    )  # fmt: skip
    budget = BudgetPart(
        repeatability=np.diag(STD**2).tolist(), repeatability_std=nothing, repeatability_com_std_m=nothing,
        repeatability_inertia_com_std_kg_m2=nothing, sources=[source], largest=[], assumptions=[],
    )  # fmt: skip
    return known.model_copy(update={"estimate": known.estimate.model_copy(update={"phi": phi.tolist(), "budget": budget})})


def test_runs_whose_plans_differ_are_not_called_different_for_the_zeros_that_they_share() -> None:
    rng = np.random.default_rng(0)
    truth = cloud(0).parameters(np.zeros((10, 10))).phi
    called = alone = 0
    for _ in range(300):
        zeros = rng.standard_normal(7)
        plans = [PULL * rng.standard_normal((7, 10)) for _ in range(2)]
        first, second = (measure_result(run(truth + zeros @ plan + STD * rng.standard_normal(10), plan)) for plan in plans)
        off = first.own.phi - second.own.phi
        called += off @ np.linalg.solve(difference_covariance(first, second), off) > 23.21  # the 99 % point of chi-square with ten
        alone += off @ off / (2.0 * STD @ STD) > 23.21
    assert called <= 9  # 1 % of 300, and three standard deviations
    assert alone > 250


def test_a_cause_that_two_runs_share_alike_takes_no_part_in_their_difference() -> None:
    truth = cloud(0).parameters(np.zeros((10, 10))).phi
    plan = PULL * np.random.default_rng(1).standard_normal((7, 10))
    first, second = (measure_result(run(truth, plan)) for _ in range(2))
    np.testing.assert_allclose(difference_covariance(first, second), 2.0 * np.diag(STD**2), atol=1e-12)


def test_a_twins_own_uncertainty_is_shared_by_no_other_run() -> None:
    truth = cloud(0).parameters(np.zeros((10, 10))).phi
    assert measure_result(run(truth, np.ones((1, 10)), name="twin")).shared == {}


def test_an_answer_without_a_budget_is_as_uncertain_as_it_says() -> None:
    known = answer(cloud(0), "ur5e_line")
    assert known.estimate is not None
    found = measure_result(known)
    assert found.shared == {}
    np.testing.assert_allclose(found.own.covariance, np.array(known.estimate.covariance, dtype=float))
