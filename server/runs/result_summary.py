"""A run's result in a few numbers, for lists and for how payload and offsets change over time."""

from __future__ import annotations

from pydantic import Field

from core.estimation.result import Result
from core.estimation.result_part import Numbers
from core.words.message import Message
from server.http.schemas import Answer


class ResultSummary(Answer):
    """What a run found; null is what is not determined."""

    verdict: Message = Field(description="The result in a sentence.")
    good_enough: bool | None = Field(
        default=None,
        description="Whether it is good enough for the cell's controller; null where that cannot be judged, and in results of earlier "
        "versions.",
        examples=[True],
    )
    determined: int = Field(description="How many of the ten parameters are determined.", examples=[10])
    mass_kg: float | None = Field(description="Mass, kg; null where it is not determined.", examples=[2.783])
    mass_std_kg: float | None = Field(description="Its standard uncertainty, kg.", examples=[0.002])
    com_m: Numbers = Field(description="Centre of mass, m, sensor frame.", examples=[[0.0, -0.0168, 0.0365]])
    com_std_m: Numbers = Field(description="Its standard uncertainties, m.", examples=[[0.0001, 0.0001, 0.0001]])
    offset: Numbers = Field(
        description="Offset of the sensor, fx fy fz (N) tx ty tz (N m).", examples=[[1.2, -0.4, 3.1, 0.02, 0.01, -0.03]]
    )
    offset_std: Numbers = Field(description="Its standard uncertainties, N and N m.", examples=[[0.01, 0.01, 0.02, 0.001, 0.001, 0.001]])


def summary_of(result: Result) -> ResultSummary:
    """The few numbers of a result."""
    found = result.estimate
    adequacy = None if result.requirement is None else result.requirement.adequacy
    return ResultSummary(
        verdict=result.verdict,
        good_enough=None if adequacy is None else adequacy.good_enough,
        determined=0 if found is None else sum(found.determined),
        mass_kg=None if found is None else found.phi[0],
        mass_std_kg=None if found is None else found.std[0],
        com_m=[None] * 3 if found is None else found.com_m,
        com_std_m=[None] * 3 if found is None else found.com_std_m,
        offset=[None] * 6 if found is None else found.offset,
        offset_std=[None] * 6 if found is None else found.offset_std,
    )
