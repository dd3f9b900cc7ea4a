"""A requirement and a verdict as they leave the engine: JSON, SI units, and sentences."""

from __future__ import annotations

from typing import Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from core.estimation.result import EstimatePart
from core.payload.inertia import PHI_NAMES
from core.requirement.motions import JointMotion
from core.requirement.requirement import Adequacy, Allowed, Criterion, CriterionKind, Group, Requirement, judge
from core.words.message import Message

GROUP_NAMES = {
    Group.MASS: Message.of("requirement-mass"),
    Group.COM: Message.of("requirement-centre-of-mass"),
    Group.INERTIA: Message.of("requirement-inertia"),
}
UNITS = {"mass": "kg", "centre_of_mass": "m", "inertia": "kg m2"}
GroupName = Literal["mass", "centre_of_mass", "inertia"]


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


class AdequacyPart(RequirementModel):
    """Whether an answer is good enough."""

    good_enough: bool = Field(description="Whether its error stays below every threshold with 95 % probability.", examples=[True])
    used: float = Field(description="Share of the deciding threshold that its error stays below with 95 % probability.", examples=[0.12])
    margin: float | None = Field(description="By how much the uncertainty might grow; null where it has none.", examples=[8.3])
    criterion: CriterionPart = Field(description="Of which most is used.")
    decides: GroupName = Field(description="Whose uncertainty uses most of it.", examples=["inertia"])
    shares: dict[GroupName, float] = Field(description="Of the variance there, by group.", examples=[{"mass": 0.1, "inertia": 0.9}])


class RequirementPart(RequirementModel):
    """What a controller needs to know of a payload, and whether an answer says it well enough."""

    assumed: bool = Field(description="Whether the cell states no threshold, and a usual one is taken.", examples=[False])
    motion_s: float = Field(description="How long the motion is that it holds for, s.", examples=[94.0])
    allowed: list[AllowedPart] = Field(description="One for each group.")
    adequacy: AdequacyPart | None = Field(description="Of the answer; null where there is none, or it cannot be judged.")
    message: Message = Field(description="The verdict in words.")


def requirement_part(requirement: Requirement, motion: JointMotion, estimate: EstimatePart | None = None) -> RequirementPart:
    """All of it; with an estimate also whether that is good enough."""
    lacking = [] if estimate is None else [name for name, known in zip(PHI_NAMES, estimate.determined, strict=True) if not known]
    adequacy = None if estimate is None or lacking else judge(requirement, np.array(estimate.covariance, dtype=float))
    if adequacy is not None:
        verdict = _verdict(adequacy)
    else:
        verdict = Message.of("requirement-not-determined", names=lacking) if lacking else Message.of("requirement-no-answer")
    return RequirementPart(
        assumed=requirement.assumed,
        motion_s=motion.duration_s,
        allowed=[_allowed_part(each) for each in requirement.allowed],
        adequacy=None if adequacy is None else _adequacy_part(adequacy),
        message=verdict,
    )


def _verdict(adequacy: Adequacy) -> Message:
    parameters = {"criterion": criterion_message(adequacy.criterion), "decides": GROUP_NAMES[adequacy.decides]}
    code = "requirement-good-enough" if adequacy.good_enough else "requirement-not-good-enough"
    return Message.of(code, used=adequacy.used, **parameters)


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


def _allowed_part(allowed: Allowed) -> AllowedPart:
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
        shares={group.value: share for group, share in adequacy.shares.items()},
    )
