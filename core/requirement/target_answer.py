"""How far a target was met, as it leaves the engine: JSON, SI units, and sentences."""

from __future__ import annotations

import math
from typing import Literal, Protocol

import numpy as np
from pydantic import Field

from core.array import Array
from core.payload.uncertain_parameters import UncertainParameters
from core.requirement.answer import GROUP_NAMES, UNITS, RequirementModel
from core.requirement.target import QuantityStanding, Standing, Target, TargetCheck, TargetStanding
from core.words.message import Message

REQUIREMENT_NAME = Message.of("target-requirement")


class TargetQuantityPart(RequirementModel):
    """One quantity that the target names; half-widths of 95 % intervals, null where it is not determined."""

    quantity: Literal["mass", "centre_of_mass", "inertia", "requirement"] = Field(
        description="What is wanted; of the cell's requirement the numbers are shares of what it allows.", examples=["inertia"]
    )
    unit: str = Field(
        description="Of the numbers: kg, m, kg m2 (Frobenius norm about the centre of mass), or 1 for a share.", examples=["kg m2"]
    )
    wanted: float | None = Field(description="Largest half-width that meets the target.", examples=[0.00005])
    half_width: float | None = Field(description="With all sources of uncertainty together.", examples=[0.00004])
    repeatability: float | None = Field(description="By this recording alone (type A).", examples=[0.00001])
    systematic: float | None = Field(description="By what is the same in every repetition (type B).", examples=[0.00003])
    standing: Literal["reached", "open", "type_b"] = Field(
        description="`reached`; `open` where more repetitions would help; `type_b` where they would not.", examples=["reached"]
    )
    message: Message = Field(description="The same in words.")


class LeftOutPart(RequirementModel):
    """What a run did not have to do."""

    made: int = Field(description="Holds and rotations that were recorded.", examples=[6])
    planned: int = Field(description="Holds and rotations of the plan.", examples=[9])
    repetitions: int = Field(description="Swings out and back that were left out, those of whole rotations included.", examples=[7])
    saved_s: float = Field(description="Robot time that was saved, s.", examples=[21.4])


class TargetPart(RequirementModel):
    """How far the answer meets the target that it was asked for with."""

    target: Target = Field(description="As it was asked for.")
    standing: Literal["reached", "open", "type_b"] = Field(
        description="Of all quantities together: `type_b` where what is missing is type B alone, so that more repetitions would not help.",
        examples=["reached"],
    )
    quantities: list[TargetQuantityPart] = Field(description="One for each that the target names.")
    left_out: LeftOutPart | None = Field(description="What the run left out; null where it left out nothing, and of a recording.")
    message: Message = Field(description="All of it in words.")


class Assessed(Protocol):
    """An estimate with what of its uncertainty is repeatability."""

    @property
    def phi(self) -> Array:
        """(10,), NaN where not determined."""

    @property
    def covariance(self) -> Array:
        """(10, 10), type A and type B together."""

    @property
    def repeatability(self) -> UncertainParameters:
        """The same with type A alone."""


def hold_against_target(check: TargetCheck, estimate: Assessed | None, left_out: LeftOutPart | None = None) -> TargetPart:
    """How far an estimate meets the target; None where nothing was identified."""
    if estimate is None:
        unknown = np.full(10, np.nan), np.full((10, 10), np.nan)
        found = check.find_standing(UncertainParameters(*unknown), unknown[1])
    else:
        total = UncertainParameters(estimate.phi, estimate.covariance)
        found = check.find_standing(total, estimate.repeatability.covariance)
    return _target_part(check.target, found, left_out)


def _target_part(target: Target, found: TargetStanding, left_out: LeftOutPart | None) -> TargetPart:
    return TargetPart(
        target=target,
        standing=found.standing.value,
        quantities=[_quantity_part(each) for each in found.quantities],
        left_out=left_out,
        message=say_standing(found, left_out),
    )


def say_standing(found: TargetStanding, left_out: LeftOutPart | None = None) -> Message:
    """One sentence about all of it."""
    match found.standing:
        case Standing.REACHED if left_out is not None and left_out.made < left_out.planned:
            return Message.of("target-reached-early", made=left_out.made, planned=left_out.planned, saved_s=left_out.saved_s)
        case Standing.REACHED if left_out is not None:
            return Message.of("target-reached-with-fewer", repetitions=left_out.repetitions, saved_s=left_out.saved_s)
        case Standing.REACHED:
            return Message.of("target-reached")
        case Standing.TYPE_B:
            return Message.of("target-type-b", names=_list_names(found, Standing.TYPE_B))
        case Standing.OPEN:
            return Message.of("target-open", names=_list_names(found, Standing.OPEN))


def _list_names(found: TargetStanding, standing: Standing) -> list[Message]:
    return [_name(each) for each in found.quantities if each.standing is standing]


def _name(each: QuantityStanding) -> Message:
    return REQUIREMENT_NAME if each.quantity is None else GROUP_NAMES[each.quantity]


def _quantity_part(each: QuantityStanding) -> TargetQuantityPart:
    return TargetQuantityPart(
        quantity="requirement" if each.quantity is None else each.quantity.value,
        unit="1" if each.quantity is None else UNITS[each.quantity],
        wanted=_finite(each.wanted),
        half_width=_finite(each.total),
        repeatability=_finite(each.repeatability),
        systematic=_finite(each.systematic),
        standing=each.standing.value,
        message=_say_quantity(each),
    )


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _say_quantity(each: QuantityStanding) -> Message:
    if not (math.isfinite(each.total) and math.isfinite(each.wanted)) or each.wanted <= 0.0:
        return Message.of("target-quantity-unknown", name=_name(each))
    parts = {"total": each.total, "repeatability": each.repeatability, "systematic": each.systematic}
    of_wanted = {name: _two_digits(value / each.wanted) for name, value in parts.items()}
    return Message.of("target-quantity", name=_name(each), **of_wanted)


def _two_digits(value: float) -> float:
    return float(f"{value:.2g}")
