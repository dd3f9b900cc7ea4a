"""The ten values of a certificate as controllers take them: mass, centre of mass, inertia about it; each with its budget."""

from __future__ import annotations

from pydantic import Field

from core.estimation.budget import REPEATABILITY, TITLES
from core.estimation.budget_part import BudgetPart, SourcePart
from core.estimation.result import EstimatePart
from core.estimation.result_part import Numbers, ResultPart
from core.payload.inertia import PHI_NAMES
from core.words.message import Message

NAMES = ("m", "c_x", "c_y", "c_z", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz")
UNITS = ("kg", "m", "m", "m", *["kg m2"] * 6)
COVERAGE_FACTOR = 1.96
"""Standard uncertainties on either side of a 95 % interval of a normal distribution."""


class Contribution(ResultPart):
    """One part of a value's budget."""

    source: str = Field(description="`repeatability`, or the name of a source of type B.", examples=["sensor_gain"])
    title: Message = Field(description="The same in words.")
    share: float = Field(description="Of the value's variance, 0 to 1.", examples=[0.83])


class CertifiedValue(ResultPart):
    """One of the ten; null is what is not determined, and `reason` says why."""

    name: str = Field(description="Mass, centre of mass, or inertia about the centre of mass.", examples=["c_x"])
    unit: str = Field(description="Of everything here.", examples=["m"])
    value: float | None = Field(description="Sensor frame, in `unit`.", examples=[0.0365])
    standard_uncertainty: float | None = Field(description="All sources together (type A and B), in `unit`.", examples=[0.0001])
    expanded_uncertainty: float | None = Field(description="`coverage_factor` times as much, in `unit`.", examples=[0.000196])
    repeatability: float | None = Field(
        description="Standard uncertainty by the recording alone (type A), in `unit`; null in results of earlier versions too.",
        examples=[0.00001],
    )
    contributions: list[Contribution] = Field(description="Where the uncertainty comes from, the largest first.")
    reason: Message | None = Field(default=None, description="Why it is not determined; null where it is.")


def list_values(estimate: EstimatePart | None, verdict: Message) -> list[CertifiedValue]:
    """All ten, in the order of `NAMES`.

    Args:
        verdict: why nothing is determined, where there is no estimate.
    """
    if estimate is None:
        nothing: Numbers = [None] * 10
        return [_describe(k, nothing, nothing, None, {}, verdict) for k in range(10)]
    values = [estimate.phi[0], *estimate.com_m, *estimate.inertia_com_kg_m2]
    stds = [estimate.std[0], *estimate.com_std_m, *estimate.inertia_com_std_kg_m2]
    return [_describe(k, values, stds, estimate.budget, estimate.reasons, verdict) for k in range(10)]


def _describe(
    k: int, values: Numbers, stds: Numbers, budget: BudgetPart | None, reasons: dict[str, Message], verdict: Message
) -> CertifiedValue:
    value, std = values[k], stds[k]
    known = value is not None and std is not None
    parts = {} if budget is None or not known else _parts(budget, k)
    return CertifiedValue(
        name=NAMES[k],
        unit=UNITS[k],
        value=value if known else None,
        standard_uncertainty=std if known else None,
        expanded_uncertainty=COVERAGE_FACTOR * std if known and std is not None else None,
        repeatability=parts.get(REPEATABILITY),
        contributions=_rank(parts, std or 0.0),
        reason=None if known else _find_reason(k, reasons, verdict),
    )


def _find_reason(k: int, reasons: dict[str, Message], verdict: Message) -> Message:
    """Its own, or else that of the first parameter from which it would follow."""
    return reasons.get(PHI_NAMES[k]) or next(iter(reasons.values()), verdict)


def _parts(budget: BudgetPart, k: int) -> dict[str, float | None]:
    """Name of each part -> its standard uncertainty in the k-th value."""
    first = budget.repeatability_std[0], budget.repeatability_com_std_m, budget.repeatability_inertia_com_std_kg_m2
    return {REPEATABILITY: _pick(k, *first), **{each.name: _pick_source(k, each) for each in budget.sources}}


def _pick_source(k: int, source: SourcePart) -> float | None:
    return _pick(k, source.std[0], source.com_std_m, source.inertia_com_std_kg_m2)


def _pick(k: int, mass: float | None, com: Numbers, inertia: Numbers) -> float | None:
    return [mass, *com, *inertia][k]


def _rank(parts: dict[str, float | None], std: float) -> list[Contribution]:
    if std <= 0.0:
        return []
    found = [Contribution(source=name, title=TITLES[name], share=((part or 0.0) / std) ** 2) for name, part in parts.items()]
    return sorted(found, key=lambda each: -each.share)
