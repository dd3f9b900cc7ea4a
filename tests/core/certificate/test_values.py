"""The ten values with their budget, beside sums made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from core.certificate.values import NAMES, list_values
from core.estimation.budget_part import BudgetPart, SourcePart
from core.estimation.result import EstimatePart
from core.words.message import Message
from tests.core.export.cloud import cloud
from tests.core.export.known_result import answer

VERDICT = Message.of("text", text="nothing")


def known() -> EstimatePart:
    found = answer(cloud(0), None).estimate
    assert found is not None
    return found


def budget_of(found: EstimatePart, *, gain: float) -> BudgetPart:
    """Of which the gain makes this share of every variance, and the repeatability the rest."""

    def part(std: list[float | None], share: float) -> list[float | None]:
        return [float(np.sqrt(share)) * (each or 0.0) for each in std]

    stds = found.std, found.com_std_m, found.inertia_com_std_kg_m2
    of_gain, of_rest = ([part(std, share) for std in stds] for share in (gain, 1.0 - gain))
    source = SourcePart(
        name="sensor_gain", title=Message.of("estimation-source-sensor-gain"), stated=True, directions=[],
        std=of_gain[0], com_std_m=of_gain[1], inertia_com_std_kg_m2=of_gain[2],
    )  # fmt: skip
    return BudgetPart(
        repeatability=[], repeatability_std=of_rest[0], repeatability_com_std_m=of_rest[1],
        repeatability_inertia_com_std_kg_m2=of_rest[2], sources=[source], largest=[], assumptions=[],
    )  # fmt: skip


def test_they_are_those_of_a_cloud_of_points() -> None:
    body = cloud(0)
    inertia = body.inertia(body.com)
    six = [inertia[i, j] for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))]
    found = list_values(known(), VERDICT)
    assert tuple(each.name for each in found) == NAMES
    np.testing.assert_allclose([each.value or 0.0 for each in found], [body.masses.sum(), *body.com, *six], atol=1e-12)
    assert all(each.expanded_uncertainty == pytest.approx(1.96 * (each.standard_uncertainty or 0.0)) for each in found)


def test_each_has_the_parts_of_its_variance_the_largest_first() -> None:
    estimate = known().model_copy(update={"budget": budget_of(known(), gain=0.8)})
    for each in list_values(estimate, VERDICT):
        assert [part.source for part in each.contributions] == ["sensor_gain", "repeatability"]
        assert [part.share for part in each.contributions] == pytest.approx([0.8, 0.2])
        assert each.repeatability == pytest.approx(np.sqrt(0.2) * (each.standard_uncertainty or 0.0))


def test_without_a_budget_nothing_is_made_up() -> None:
    assert all(each.repeatability is None and each.contributions == [] for each in list_values(known(), VERDICT))


def test_what_is_not_determined_has_a_reason_its_own_or_of_what_it_would_follow_from() -> None:
    slow = Message.of("text", text="too slow")
    estimate = known()
    inertia = [None, *estimate.inertia_com_kg_m2[1:]]
    missing = estimate.model_copy(
        update={"com_m": [None, *estimate.com_m[1:]], "inertia_com_kg_m2": inertia, "reasons": {"mc_x": slow}},
    )
    found = {each.name: each for each in list_values(missing, VERDICT)}
    assert [name for name, each in found.items() if each.value is None] == ["c_x", "Ixx"]
    assert found["c_x"].reason == found["Ixx"].reason == slow
    assert found["c_x"].expanded_uncertainty is None
    assert {each.reason for each in list_values(None, VERDICT)} == {VERDICT}
