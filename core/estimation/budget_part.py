"""The uncertainty budget as it leaves the engine."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from pydantic import Field

from core.array import Array
from core.estimation.budget import TITLES, Source
from core.estimation.result_part import Numbers, ResultPart, to_json_numbers
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message

if TYPE_CHECKING:  # who only reads answers waits for no estimator
    from core.estimation.estimate import Estimate


class SourcePart(ResultPart):
    """One cause of uncertainty that stays the same from recording to recording (type B)."""

    name: str = Field(
        description="What is uncertain: `sensor_gain`, `sensor_crosstalk`, `joint_zeros`, `sensor_mount`, `gravity` or `twin`.",
        examples=["sensor_gain"],
    )
    title: Message = Field(description="The same in words.")
    stated: bool = Field(description="Whether the cell or the recording states its size; it is assumed otherwise.", examples=[False])
    std: Numbers = Field(
        description="Its standard uncertainty in mass (kg), first moment (kg m) and inertia about the sensor's origin (kg m2); "
        "null is what is not determined.",
        examples=[[0.016, 0.0002, 0.0003, 0.0006, 0.00004, 0.00001, 0.00001, 0.00004, 0.00001, 0.00002]],
    )
    com_std_m: Numbers = Field(description="The same in the centre of mass, m.", examples=[[0.00008, 0.0001, 0.0002]])
    inertia_com_std_kg_m2: Numbers = Field(
        description="The same in Ixx Ixy Ixz Iyy Iyz Izz about the centre of mass, kg m2.",
        examples=[[0.00003, 0.00001, 0.00001, 0.00003, 0.00001, 0.00002]],
    )
    directions: list[Numbers] = Field(
        description="Change of the ten parameters for one standard deviation of each of its independent causes: what two runs of one "
        "cell have in common.",
        examples=[[[0.016, 0.0, -0.0003, 0.0006, 0.00004, 0.0, 0.0, 0.00004, 0.0, 0.00002]]],
    )


class BudgetPart(ResultPart):
    """Where the uncertainty comes from, in the sense of the GUM: the repeatability (type A) and everything else (type B)."""

    repeatability: list[Numbers] = Field(
        description="Covariance of the ten parameters by this recording alone (type A), ten rows of ten.",
        examples=[[[1e-8, 0.0], [0.0, 9e-10]]],
    )
    repeatability_std: Numbers = Field(
        description="Its standard uncertainties: mass (kg), first moment (kg m), inertia about the sensor's origin (kg m2).",
        examples=[[0.0001, 0.00003, 0.00003, 0.00003, 0.000006, 0.000004, 0.000004, 0.000006, 0.000004, 0.000005]],
    )
    repeatability_com_std_m: Numbers = Field(description="The same of the centre of mass, m.", examples=[[0.00001, 0.00001, 0.00001]])
    repeatability_inertia_com_std_kg_m2: Numbers = Field(
        description="The same of Ixx Ixy Ixz Iyy Iyz Izz about the centre of mass, kg m2.",
        examples=[[0.000006, 0.000004, 0.000004, 0.000006, 0.000004, 0.000005]],
    )
    sources: list[SourcePart] = Field(description="What stays the same from recording to recording (type B); their variances add.")
    largest: list[str | None] = Field(
        description="Of each of the ten parameters, what contributes most: `repeatability` or the name of a source; null where it is "
        "not determined.",
        examples=[
            [
                "sensor_gain",
                "sensor_crosstalk",
                "sensor_gain",
                "sensor_gain",
                "sensor_gain",
                None,
                None,
                "sensor_gain",
                None,
                "repeatability",
            ]
        ],
    )
    assumptions: list[Message] = Field(description="What nobody has stated, was assumed and matters here.")


def budget_part(estimate: Estimate) -> BudgetPart:
    """The budget of an estimate; null is what is not determined."""
    budget, known, alone = estimate.budget, estimate.determined, estimate.repeatability
    return BudgetPart(
        repeatability=[to_json_numbers(row) for row in alone.covariance],
        repeatability_std=to_json_numbers(alone.std),
        repeatability_com_std_m=to_json_numbers(alone.com_std),
        repeatability_inertia_com_std_kg_m2=to_json_numbers(alone.inertia_com_std),
        sources=[_source_part(each, estimate) for each in budget.sources],
        largest=[name if flag else None for name, flag in zip(budget.largest, known.tolist(), strict=True)],
        assumptions=list(budget.assumptions(known)),
    )


def _source_part(source: Source, estimate: Estimate) -> SourcePart:
    directions = np.where(estimate.determined[:, None], source.directions, np.nan)
    alone = UncertainParameters(estimate.phi, directions @ directions.T)
    return SourcePart(
        name=source.name,
        title=TITLES[source.name],
        stated=source.stated,
        std=to_json_numbers(alone.std),
        com_std_m=to_json_numbers(alone.com_std),
        inertia_com_std_kg_m2=to_json_numbers(alone.inertia_com_std),
        directions=[to_json_numbers(column) for column in directions.T],
    )


def find_shared_covariance(first: BudgetPart, second: BudgetPart) -> Array:
    """(10, 10), covariance of the second estimate with the first, by what two runs of one cell have in common.

    NaN where one of them does not determine a parameter.
    """
    sources = {source.name: source for source in first.sources}
    total = np.zeros((10, 10))
    for source in second.sources:
        other = sources.get(source.name)
        if source.name != "twin" and other is not None and len(other.directions) == len(source.directions):
            total += np.array(source.directions, dtype=float).T @ np.array(other.directions, dtype=float)
    return total
