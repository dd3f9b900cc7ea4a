"""How exactly an exported payload is known: what goes into the file beside it, where that has a place, and into the answer where not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, get_args

import numpy as np
from pydantic import Field

from core.array import Array
from core.errors import BadPayload
from core.estimation.budget import ASSUMED, REPEATABILITY, TITLES
from core.estimation.budget_part import BudgetPart
from core.estimation.result import Result
from core.estimation.result_part import Numbers, ResultPart, to_json_numbers
from core.payload.shapes import Pose
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message

INTERVAL = 1.96
"""Standard uncertainties on either side of a 95 % interval."""
Part = Literal["mass", "centre_of_mass", "inertia"]
SourceName = Literal["repeatability", "sensor_gain", "sensor_crosstalk", "joint_zeros", "sensor_mount", "gravity", "twin"]

SOURCES: tuple[SourceName, ...] = get_args(SourceName)

PARTS = {
    "mass": Message.of("export-part-mass"),
    "centre_of_mass": Message.of("export-part-com"),
    "inertia": Message.of("export-part-inertia"),
}


class ExportUncertainty(ResultPart):
    """Half-widths of 95 % intervals, SI; null is what is not determined."""

    frame: Literal["flange"] = Field(
        default="flange", description="Along whose axes centre of mass and inertia are given.", examples=["flange"]
    )
    mass_half_width_kg: float | None = Field(description="Of the mass, all in, kg.", examples=[0.031])
    com_half_width_m: Numbers = Field(description="Of the centre of mass, all in, m.", examples=[[0.0002, 0.0002, 0.0004]])
    inertia_com_half_width_kg_m2: Numbers = Field(
        description="Of Ixx Ixy Ixz Iyy Iyz Izz about the centre of mass, all in, kg m2.",
        examples=[[0.00006, 0.00002, 0.00002, 0.00006, 0.00002, 0.00004]],
    )
    mass_repeatability_kg: float | None = Field(description="The mass repeats within this, kg.", examples=[0.0002])
    com_repeatability_m: Numbers = Field(description="The centre of mass repeats within this, m.", examples=[[0.00002, 0.00002, 0.00002]])
    inertia_com_repeatability_kg_m2: Numbers = Field(
        description="Ixx Ixy Ixz Iyy Iyz Izz about the centre of mass repeat within this, kg m2.",
        examples=[[0.00001, 0.00001, 0.00001, 0.00001, 0.00001, 0.00001]],
    )
    largest: dict[Part, SourceName] = Field(
        description="What contributes most to each; without what is not determined.",
        examples=[{"mass": "sensor_gain", "centre_of_mass": "sensor_crosstalk", "inertia": "repeatability"}],
    )
    assumed: list[SourceName] = Field(description="What nobody has stated, was assumed and matters.", examples=[["sensor_gain"]])
    repeatability_only: bool = Field(
        description="Whether it is the repeatability alone, as in results of earlier versions.", examples=[False]
    )


def uncertainty_of(result: Result, mount: Pose) -> ExportUncertainty:
    """Of what `core.export.exports.payload_of` gives for the sensor's pose in the flange's frame.

    Raises:
        BadPayload: nothing was identified.
    """
    found = result.estimate
    if found is None:
        raise BadPayload("estimate", "export-nothing-identified", verdict=result.verdict)
    phi, covariance = np.array(found.phi, dtype=float), np.array(found.covariance, dtype=float)

    def place(part: Array) -> UncertainParameters:
        return UncertainParameters(phi, part).in_frame(mount.rotation, mount.translation)

    parts = {name: place(part) for name, part in _parts(found.budget, covariance).items()}
    whole, repeats = place(covariance), parts[REPEATABILITY]
    return ExportUncertainty(
        mass_half_width_kg=to_json_numbers(INTERVAL * whole.std)[0],
        com_half_width_m=to_json_numbers(INTERVAL * whole.com_std),
        inertia_com_half_width_kg_m2=to_json_numbers(INTERVAL * whole.inertia_com_std),
        mass_repeatability_kg=to_json_numbers(INTERVAL * repeats.std)[0],
        com_repeatability_m=to_json_numbers(INTERVAL * repeats.com_std),
        inertia_com_repeatability_kg_m2=to_json_numbers(INTERVAL * repeats.inertia_com_std),
        largest=_find_largest(whole, parts),
        assumed=[] if found.budget is None else _find_assumed(found.budget),
        repeatability_only=found.budget is None,
    )


def _parts(budget: BudgetPart | None, covariance: Array) -> dict[SourceName, Array]:
    """Covariance (10, 10) that each part of the budget adds, sensor frame; without a budget it is the repeatability."""
    if budget is None:
        return {REPEATABILITY: covariance}
    directions = {source.name: np.array(source.directions, dtype=float).reshape(-1, 10) for source in budget.sources}
    return {
        REPEATABILITY: np.array(budget.repeatability, dtype=float),
        **{name: directions[name].T @ directions[name] for name in SOURCES if name in directions},
    }


def _find_largest(whole: UncertainParameters, parts: dict[SourceName, UncertainParameters]) -> dict[Part, SourceName]:
    """Which part has the largest variance, summed over the axes."""
    stds: dict[Part, Callable[[UncertainParameters], Array]] = {
        "mass": lambda of: of.std[:1],
        "centre_of_mass": lambda of: of.com_std,
        "inertia": lambda of: of.inertia_com_std,
    }
    return {
        name: max(parts, key=lambda part: float(np.nansum(std(parts[part]) ** 2)))
        for name, std in stds.items()
        if np.isfinite(std(whole)).any()
    }


def _find_assumed(budget: BudgetPart) -> list[SourceName]:
    said = [message.code for message in budget.assumptions]
    assumed = [name for name in SOURCES if name in ASSUMED and ASSUMED[name].code in said]
    return sorted(assumed, key=lambda name: said.index(ASSUMED[name].code))


def state_uncertainty(found: ExportUncertainty) -> list[Message]:
    """It in words, a line each."""
    lines = [Message.of("export-uncertainty")]
    mass = ([found.mass_half_width_kg], [found.mass_repeatability_kg])
    com = (found.com_half_width_m, found.com_repeatability_m)
    inertia = (found.inertia_com_half_width_kg_m2, found.inertia_com_repeatability_kg_m2)
    for part, (half_widths, repeats) in (("mass", mass), ("centre_of_mass", com), ("inertia", inertia)):
        if part in found.largest:
            lines.append(
                Message.of(
                    "export-uncertainty-part",
                    part=PARTS[part],
                    half_widths=_amounts(part, half_widths),
                    repeats=_amounts(part, repeats),
                    mostly=TITLES[found.largest[part]],
                )
            )
    if found.repeatability_only:
        lines.append(Message.of("export-uncertainty-earlier"))
    if found.assumed:
        lines.append(Message.of("export-uncertainty-assumed", sources=[TITLES[name] for name in found.assumed]))
    return lines


def _amounts(part: str, values: Numbers) -> list[Message]:
    """Each with its unit, so that nobody takes a decimal comma for the next value."""
    return [_amount(part, value) for value in values]


def _amount(part: str, value: float | None) -> Message:
    if value is None:
        return Message.of("export-unknown")
    match part:
        case "mass":
            return Message.of("export-kg", value_kg=value)
        case "centre_of_mass":
            return Message.of("export-mm", value_mm=1e3 * value)
    return Message.of("export-kg-m2", value_kg_m2=value)
