"""A run's result in a few numbers, for lists and for how payload and offsets change over time."""

from __future__ import annotations

from core.estimation.result import Numbers, Result
from core.words.message import Message
from server.http.schemas import Answer


class ResultSummary(Answer):
    """What a run found; null is what is not determined.

    Args:
        determined: how many of the ten parameters are.
        com_m: centre of mass, sensor frame.
        offset: of the sensor, fx fy fz (N) tx ty tz (N m), with its standard uncertainty.
    """

    verdict: Message
    determined: int
    mass_kg: float | None
    mass_std_kg: float | None
    com_m: Numbers
    com_std_m: Numbers
    offset: Numbers
    offset_std: Numbers


def summary_of(result: Result) -> ResultSummary:
    """The few numbers of a result."""
    found = result.estimate
    return ResultSummary(
        verdict=result.verdict,
        determined=0 if found is None else sum(found.determined),
        mass_kg=None if found is None else found.phi[0],
        mass_std_kg=None if found is None else found.std[0],
        com_m=[None] * 3 if found is None else found.com_m,
        com_std_m=[None] * 3 if found is None else found.com_std_m,
        offset=[None] * 6 if found is None else found.offset,
        offset_std=[None] * 6 if found is None else found.offset_std,
    )
