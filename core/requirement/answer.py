"""A requirement and a verdict as they leave the engine: JSON, SI units, and sentences."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any, Literal, Protocol

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from core.payload.inertia import PHI_NAMES
from core.requirement.motions import JointMotion
from core.requirement.requirement import TYPED_NAMES, Adequacy, Allowed, Criterion, CriterionKind, PayloadQuantity, Requirement, judge
from core.words.message import Message

INTERVAL = 1.96
"""Standard uncertainties on either side of a 95 % interval."""
LARGEST_MARGIN = 1e6
"""What is said of an answer without any uncertainty."""
GROUP_NAMES = {
    PayloadQuantity.MASS: Message.of("requirement-mass"),
    PayloadQuantity.COM: Message.of("requirement-centre-of-mass"),
    PayloadQuantity.INERTIA: Message.of("requirement-inertia"),
}
UNITS = {PayloadQuantity.MASS: "kg", PayloadQuantity.COM: "m", PayloadQuantity.INERTIA: "kg m2"}
GroupName = Literal["mass", "centre_of_mass", "inertia"]


class Judged(Protocol):
    """An estimate, as arrays or as it stands in a result; SI, the paper's order, what is not known is NaN or null."""

    @property
    def phi(self) -> Iterable[Any]:
        """(10,)."""

    @property
    def covariance(self) -> Iterable[Any]:
        """(10, 10)."""

    @property
    def determined(self) -> Iterable[bool]:
        """(10,)."""


class RequirementModel(BaseModel):
    """Frozen; an error that nothing limits is null, no number is infinite."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False)


class CriterionPart(RequirementModel):
    """What decides."""

    kind: Literal["joint_torque", "tcp_force", "guiding_force", "mass", "centre_of_mass"] = Field(
        description="What is compared with the threshold.", examples=["joint_torque"]
    )
    joint: int | None = Field(description="Which joint, counted from 1; null where it is about none.", examples=[2])
    threshold: float = Field(description="N m for a torque, N for a force, kg, or m.", examples=[20.0])
    message: Message = Field(description="It in words.")


class AllowedPart(RequirementModel):
    """How far one group may be off, the others right."""

    group: GroupName = Field(description="What is typed into a controller.", examples=["centre_of_mass"])
    error: float | None = Field(description="In `unit`, in whichever direction; null where nothing limits it.", examples=[0.021])
    unit: str = Field(description="Of `error`; of an inertia it is the Frobenius norm about the centre of mass.", examples=["m"])
    criterion: CriterionPart | None = Field(description="What decides; null where nothing limits it.")
    time_s: float = Field(description="When along the motion it decides, s.", examples=[3.2])


class DecidingPart(RequirementModel):
    """The parameter that decides."""

    name: Literal["m", "c_x", "c_y", "c_z", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz"] = Field(
        description="Mass, centre of mass or an entry of the inertia about the centre of mass, sensor frame.", examples=["Izz"]
    )
    error: float | None = Field(
        description="How far it may be off, all others right, in `unit`; null where nothing limits it.", examples=[0.02]
    )
    half_width: float = Field(description="Half-width of its 95 % interval, in `unit`.", examples=[0.005])
    unit: str = Field(description="Of both.", examples=["kg m2"])
    message: Message = Field(description="What it is called.")


class AdequacyPart(RequirementModel):
    """Whether an answer is good enough."""

    good_enough: bool = Field(description="Whether its error stays below every threshold with 95 % probability.", examples=[True])
    used: float = Field(description="Share of the deciding threshold that its error stays below with 95 % probability.", examples=[0.12])
    margin: float | None = Field(description="By how much the uncertainty might grow; null where it has none.", examples=[8.3])
    criterion: CriterionPart = Field(description="Of which most is used.")
    decides: GroupName = Field(description="Whose uncertainty uses most of it.", examples=["inertia"])
    parameter: DecidingPart = Field(description="Which parameter of that group uses most.")
    shares: dict[GroupName, float] = Field(description="Of the variance there, by group.", examples=[{"mass": 0.1, "inertia": 0.9}])


class RequirementPart(RequirementModel):
    """What a controller needs to know of a payload, and whether an answer says it well enough."""

    assumed: bool = Field(description="Whether the cell states no threshold, and a usual one is taken.", examples=[False])
    thresholds: list[CriterionPart] = Field(description="All that was judged against; empty where nothing was.")
    source: str | None = Field(description="Where the cell has its thresholds from.", examples=["safety configuration of line 3"])
    motion: Literal["brisk", "program"] = Field(
        description="The motion that it holds for: brisk moves, each as fast as the cell's limits allow, or those of a program.",
        examples=["brisk"],
    )
    motion_s: float = Field(description="How long the motion is that it holds for, s.", examples=[94.0])
    allowed: list[AllowedPart] = Field(description="One for each group; empty where the payload is not known well enough to say.")
    adequacy: AdequacyPart | None = Field(description="Of the answer; null where there is none, or it cannot be judged.")
    message: Message = Field(description="The verdict in words.")
    details: list[Message] = Field(description="What stands behind the verdict, in words: what decides, what is allowed, what is assumed.")


def requirement_part(requirement: Requirement, motion: JointMotion, estimate: Judged | None = None) -> RequirementPart:
    """All of it; with an estimate also whether that is good enough."""
    lacking = [] if estimate is None else list_undetermined(estimate)
    adequacy = None if estimate is None or lacking else judge(requirement, np.array(estimate.covariance, dtype=float))
    if adequacy is not None:
        verdict = _verdict(adequacy)
    else:
        verdict = Message.of("requirement-not-determined", names=lacking) if lacking else Message.of("requirement-no-answer")
    return RequirementPart(
        assumed=requirement.assumed,
        thresholds=[_criterion_part(each) for each in requirement.criteria],
        source=requirement.source,
        motion="program" if motion.stated else "brisk",
        motion_s=motion.duration_s,
        allowed=[_make_allowed_part(each) for each in requirement.allowed],
        adequacy=None if adequacy is None else _adequacy_part(adequacy),
        message=verdict,
        details=list(_details(requirement, motion, adequacy)),
    )


def list_undetermined(estimate: Judged) -> list[str]:
    """Names of the parameters without which nothing can be judged."""
    return [name for name, known in zip(PHI_NAMES, estimate.determined, strict=True) if not known]


def _verdict(adequacy: Adequacy) -> Message:
    decides = GROUP_NAMES[adequacy.decides]
    if adequacy.good_enough:
        return Message.of("requirement-good-enough", margin=_two_digits(min(adequacy.margin, LARGEST_MARGIN)), decides=decides)
    half_width = INTERVAL * adequacy.std
    if half_width <= adequacy.error:  # only together they are too much
        return Message.of("requirement-together-not-good-enough", used=adequacy.used, decides=decides)
    return Message.of(
        "requirement-not-good-enough",
        name=_parameter_name(adequacy.parameter),
        error=amount(adequacy.error, UNITS[adequacy.decides]),
        half_width=amount(half_width, UNITS[adequacy.decides]),
    )


def _details(requirement: Requirement, motion: JointMotion, adequacy: Adequacy | None) -> Iterable[Message]:
    if adequacy is not None:
        yield Message.of("requirement-used", used=adequacy.used, criterion=criterion_message(adequacy.criterion))
    for each in requirement.allowed:
        if each.criterion is None:
            yield Message.of("requirement-allowed-any", group=GROUP_NAMES[each.group])
        else:
            error = amount(each.error, UNITS[each.group])
            yield Message.of("requirement-allowed", group=GROUP_NAMES[each.group], error=error, criterion=criterion_message(each.criterion))
    yield Message.of("requirement-motion-program" if motion.stated else "requirement-motion-brisk", motion_s=motion.duration_s)
    if requirement.assumed:
        yield Message.of("requirement-assumed")
    elif requirement.source is not None:
        yield Message.of("requirement-source", source=requirement.source)


def amount(value: float, unit: str) -> Message:
    """An error with its unit as people read it: lengths in mm."""
    match unit:
        case "kg":
            return Message.of("requirement-kg", value_kg=_two_digits(value))
        case "m":
            return Message.of("requirement-mm", value_mm=_two_digits(1e3 * value))
    return Message.of("requirement-kg-m2", value_kg_m2=_two_digits(value))


def _two_digits(value: float) -> float:
    """Rounded, so that no more digits are printed than mean anything."""
    return round(value, 1 - math.floor(math.log10(value))) if value > 0.0 else 0.0


def _parameter_name(parameter: int) -> Message:
    name = TYPED_NAMES[parameter]
    if parameter == 0:
        return GROUP_NAMES[PayloadQuantity.MASS]
    if parameter < 4:
        return Message.of("requirement-parameter-com", axis=name[-1])
    axes = name[1:]
    if axes[0] == axes[1]:
        return Message.of("requirement-parameter-moment", axis=axes[0])
    return Message.of("requirement-parameter-product", axes=axes)


def criterion_message(criterion: Criterion) -> Message:
    """What is compared with what."""
    match criterion.kind:
        case CriterionKind.JOINT_TORQUE:
            return Message.of("requirement-criterion-joint-torque", joint=criterion.joint or 0, threshold_nm=criterion.threshold)
        case CriterionKind.TCP_FORCE:
            return Message.of("requirement-criterion-tcp-force", threshold_n=criterion.threshold)
        case CriterionKind.GUIDING_FORCE:
            return Message.of("requirement-criterion-guiding-force", threshold_n=criterion.threshold)
        case CriterionKind.MASS:
            return Message.of("requirement-criterion-mass", threshold_kg=criterion.threshold)
        case CriterionKind.COM:
            return Message.of("requirement-criterion-centre-of-mass", threshold_m=criterion.threshold)


def _criterion_part(criterion: Criterion) -> CriterionPart:
    return CriterionPart(
        kind=criterion.kind.value, joint=criterion.joint, threshold=criterion.threshold, message=criterion_message(criterion)
    )


def _make_allowed_part(allowed: Allowed) -> AllowedPart:
    return AllowedPart(
        group=allowed.group.value,
        error=allowed.error if np.isfinite(allowed.error) else None,
        unit=UNITS[allowed.group],
        criterion=None if allowed.criterion is None else _criterion_part(allowed.criterion),
        time_s=allowed.time_s,
    )


def _adequacy_part(adequacy: Adequacy) -> AdequacyPart:
    return AdequacyPart(
        good_enough=adequacy.good_enough,
        used=adequacy.used,
        margin=adequacy.margin if np.isfinite(adequacy.margin) else None,
        criterion=_criterion_part(adequacy.criterion),
        decides=adequacy.decides.value,
        parameter=DecidingPart(
            name=TYPED_NAMES[adequacy.parameter],  # type: ignore[arg-type]  # one of ten
            error=adequacy.error if np.isfinite(adequacy.error) else None,
            half_width=INTERVAL * adequacy.std,
            unit=UNITS[adequacy.decides],
            message=_parameter_name(adequacy.parameter),
        ),
        shares={group.value: share for group, share in adequacy.shares.items()},
    )
