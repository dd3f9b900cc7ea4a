"""How exactly a payload is wanted to be known, and whether what is known so far is enough, or as much as repetitions can give.

Everything is a half-width of a 95 % interval, in whichever direction it is widest: of the mass, the centre of mass (norm) and the inertia
about it (Frobenius norm), as `core.requirement.requirement` counts what a controller allows.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Final

import numpy as np
from pydantic import Field

from core.array import Array
from core.cell.cell import Cell
from core.errors import BadInput
from core.payload.inertia import PHI_NAMES, InertialParameters
from core.payload.shapes import Model
from core.payload.uncertain_parameters import UncertainParameters, propagate
from core.requirement.motions import JointMotion, make_brisk_motion
from core.requirement.requirement import PayloadQuantity, judge, require

if TYPE_CHECKING:  # who only reads targets waits for no robot
    from core.robot.model import RobotModel

INTERVAL = 1.96
"""Standard uncertainties on either side of a 95 % interval."""
REQUIREMENT: Final = "requirement"
EXHAUSTED = 1.0 / 3.0
"""Repeatability over type B from which repetitions make the whole narrower by less than 6 %."""
FROBENIUS = np.sqrt([1.0, 2.0, 2.0, 1.0, 2.0, 1.0])
"""What stands off the diagonal of an inertia stands there twice."""
_AMOUNT = re.compile(r"(?P<number>\d+(?:\.\d*)?|\.\d+)\s*(?P<unit>%|mm|m)")
_FIELDS = {"mass": "mass_share", "com": "centre_of_mass_m", "inertia": "inertia_share"}
_UNITS = {"mass": {"%": 0.01}, "com": {"mm": 1e-3, "m": 1.0}, "inertia": {"%": 0.01}}

Share = Annotated[float, Field(gt=0.0, le=1.0)]


class Target(Model):
    """How exactly the payload is wanted to be known: half-widths of 95 % intervals with all sources of uncertainty together."""

    mass_share: Share | None = Field(
        default=None,
        description="Of the mass, as a share of it without a unit: 0.001 is 0.1 %; null where it does not matter.",
        examples=[0.001],
    )
    centre_of_mass_m: Annotated[float, Field(gt=0.0, le=1.0)] | None = Field(
        default=None,
        description="Of the centre of mass in the direction in which it is known least, m; null where it does not matter.",
        examples=[0.0005],
    )
    inertia_share: Share | None = Field(
        default=None,
        description="Of the inertia about the centre of mass, as a share of it without a unit (Frobenius norms): 0.01 is 1 %; null "
        "where it does not matter.",
        examples=[0.01],
    )
    requirement: bool = Field(
        default=False, description="As exactly as the cell's controller requires, see `requirement` of a result.", examples=[False]
    )

    @property
    def names_something(self) -> bool:
        """Whether anything is wanted."""
        return self.requirement or any(each is not None for each in (self.mass_share, self.centre_of_mass_m, self.inertia_share))


def parse_target(text: str, where: str = "--target") -> Target:
    """A target as people type it: `mass=0.1%,inertia=1%`, `com=0.5mm`, `requirement`.

    Raises:
        BadInput: it is none.
    """
    found: dict[str, float | bool] = {}
    for part in (each.strip().lower() for each in text.split(",")):
        name, _, amount = (each.strip() for each in part.partition("="))
        key = REQUIREMENT if part == REQUIREMENT else _FIELDS.get(name, "")
        if not key or key in found:
            raise BadInput(where, "target-unreadable", text=text)
        found[key] = True if key == REQUIREMENT else _read_amount(name, amount, text, where)
    return Target.model_validate(found)


def _read_amount(name: str, amount: str, text: str, where: str) -> float:
    match = _AMOUNT.fullmatch(amount)
    factor = None if match is None else _UNITS[name].get(match["unit"])
    if match is None or factor is None:
        raise BadInput(where, "target-unreadable", text=text)
    value = factor * float(match["number"])
    if not 0.0 < value <= 1.0:
        raise BadInput(where, "target-out-of-range", text=f"{name}={amount}")
    return value


class Standing(StrEnum):
    """How far a target is met."""

    REACHED = "reached"
    OPEN = "open"
    TYPE_B = "type_b"
    """Not reached, and what stays the same in every repetition is above it alone."""


@dataclass(frozen=True)
class QuantityStanding:
    """One quantity against what is wanted of it, as half-widths of 95 % intervals; NaN where it is not determined.

    Args:
        quantity: None for the cell's requirement as a whole, whose numbers are shares of what it allows.
        wanted, total: kg, m, kg m2, or a share.
        repeatability, systematic: type A and type B alone.
    """

    quantity: PayloadQuantity | None
    wanted: float
    total: float
    repeatability: float
    systematic: float

    @property
    def standing(self) -> Standing:
        """Repetitions are worth their time as long as type B alone would be within reach, or hides behind the repeatability."""
        if self.total <= self.wanted:
            return Standing.REACHED
        if self.systematic > self.wanted and self.repeatability < EXHAUSTED * self.systematic:
            return Standing.TYPE_B
        return Standing.OPEN


@dataclass(frozen=True)
class TargetStanding:
    """All that a target names."""

    quantities: tuple[QuantityStanding, ...]

    @property
    def standing(self) -> Standing:
        """Type B where it is what keeps everything that is not reached from being so."""
        all_of = {each.standing for each in self.quantities}
        if all_of == {Standing.REACHED}:
            return Standing.REACHED
        return Standing.OPEN if Standing.OPEN in all_of else Standing.TYPE_B


@dataclass(frozen=True)
class CellRequirement:
    """What a cell's controller requires along moves as brisk as its robot allows, for one covariance after the other."""

    cell: Cell
    robot: RobotModel

    @cached_property
    def _motion(self) -> JointMotion:
        return make_brisk_motion(self.cell, self.robot)

    def find_used(self, phi: Array, covariance: Array) -> float:
        """Share of what the thresholds allow that errors of this covariance (10, 10) of the parameters use, as a verdict counts it."""
        return judge(require(self.cell, self.robot, InertialParameters(phi), self._motion), covariance).used


@dataclass(frozen=True)
class TargetCheck:
    """Holds estimates against a target.

    Args:
        required: by the cell; needed where the target names that, without it nothing is enough.
    """

    target: Target
    required: CellRequirement | None = None

    def find_standing(self, found: UncertainParameters, repeatability: Array, *, share: float = 1.0) -> TargetStanding:
        """How far an estimate meets the target.

        Args:
            found: with type A and type B together.
            repeatability: (10, 10), type A alone.
            share: of what the target allows that may be used.
        """
        target, total, parts = self.target, found.covariance, []
        kinds = (total, repeatability, np.asarray(total - repeatability))
        if target.mass_share is not None:
            widths = [_find_half_width(each[:1, :1]) for each in kinds]
            parts.append(QuantityStanding(PayloadQuantity.MASS, share * target.mass_share * float(found.phi[0]), *widths))
        if target.centre_of_mass_m is not None:
            widths = [_find_half_width(propagate(found.com_jacobian, each)) for each in kinds]
            parts.append(QuantityStanding(PayloadQuantity.COM, share * target.centre_of_mass_m, *widths))
        if target.inertia_share is not None:
            J = found.inertia_com_jacobian * FROBENIUS[:, None]
            widths = [_find_half_width(propagate(J, each)) for each in kinds]
            size = float(np.linalg.norm(found.inertia_com * FROBENIUS))
            parts.append(QuantityStanding(PayloadQuantity.INERTIA, share * target.inertia_share * size, *widths))
        if target.requirement:
            parts.append(self._hold_against_requirement(found.phi, kinds, share))
        return TargetStanding(tuple(parts))

    def find_standing_of_turns(self, phi: Array, repeatability: Array, about: str, *, share: float = 1.0) -> TargetStanding:
        """The same of what rotations about one sensor axis can still tell: the repeatability of its column of the inertia."""
        told = np.array([name.startswith("I") and about in name[1:] for name in PHI_NAMES])
        left = np.where(told[:, None] & told[None, :] | np.isnan(repeatability), repeatability, 0.0)
        return self.find_standing(UncertainParameters(phi, left), left, share=share)

    def _hold_against_requirement(self, phi: Array, kinds: tuple[Array, ...], share: float) -> QuantityStanding:
        """Shares of what the cell's thresholds allow, as the verdict of a result counts them."""
        known = np.isfinite(phi).all() and np.isfinite(kinds[0]).all() and phi[0] > 0.0
        if self.required is None or not known:
            return QuantityStanding(None, share, np.nan, np.nan, np.nan)
        return QuantityStanding(None, share, *(self.required.find_used(phi, each) for each in kinds))


def _find_half_width(covariance: Array) -> float:
    """Of the 95 % interval of a vector in the direction in which it is widest; NaN where a part of it is not determined."""
    if not np.isfinite(covariance).all():
        return float("nan")
    return float(INTERVAL * np.sqrt(max(np.linalg.eigvalsh(covariance)[-1], 0.0)))
