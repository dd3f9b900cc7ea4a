"""The answer of a run or of an identification as it leaves the engine: JSON, SI units, sensor frame, the paper's order of Phi."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import numpy as np
from pydantic import Field

from core.estimation.budget_part import BudgetPart, budget_part
from core.estimation.joint_part import JointPart, joint_part
from core.estimation.result_part import Numbers, ResultPart, to_json_numbers
from core.recording.order_reference import OrderReference
from core.recording.recording import Recording
from core.recording.workpiece import workpiece_alone
from core.requirement.answer import RequirementPart
from core.requirement.target_answer import TargetPart
from core.version import code_version
from core.words.message import Message

if TYPE_CHECKING:  # who only reads answers waits for no estimator
    from core.estimation.estimate import Estimate, Identification, TwinShare, Verification


class ReferencePart(ResultPart):
    """The payload as somebody else knows it; beside the whole with the tools, beside the workpiece alone without them."""

    phi: Numbers = Field(
        description="Mass (kg), first moment (kg m), inertia about the sensor's origin (kg m2), in the paper's order.",
        examples=[[2.783, 0.0, -0.0468, 0.1015, 0.0069, 0.0, 0.0, 0.0066, 0.0017, 0.0033]],
    )
    source: str | None = Field(description="Where it is from.", examples=["CAD"])


class PaperPart(ResultPart):
    """Algorithms 1-5 with Eq. (8)-(10)."""

    phi: Numbers = Field(
        description="The paper's estimate: mass (kg), first moment (kg m), inertia (kg m2); null is what it leaves out.",
        examples=[[2.79, 0.001, -0.047, 0.102, 0.007, None, None, 0.0067, None, 0.0034]],
    )
    std: Numbers = Field(
        description="Its standard deviations by Eq. (8) to (10), in the same units.",
        examples=[[0.002, 0.0003, 0.0003, 0.0003, 0.0001, None, None, 0.0001, None, 0.0001]],
    )


class EstimatePart(ResultPart):
    """The estimate from all samples; `std` and `covariance` are the combined standard uncertainty, type A and type B."""

    phi: Numbers
    std: Numbers
    covariance: list[Numbers]
    determined: list[bool]
    reasons: dict[str, Message]
    offset: Numbers
    offset_std: Numbers
    com_m: Numbers
    com_std_m: Numbers
    inertia_com_kg_m2: Numbers
    inertia_com_std_kg_m2: Numbers
    consistent: bool
    base_tilt_rad: Numbers | None
    base_tilt_std_rad: Numbers | None
    delay_s: float | None
    delay_std_s: float | None
    budget: BudgetPart | None = None
    """None in results of earlier versions, whose `std` and `covariance` are the repeatability alone."""


class ResidualPart(ResultPart):
    """Measured minus reconstructed wrench, force then torque."""

    rms: Numbers = Field(
        description="Root mean square of measured minus reconstructed, force (N), then torque (N m).",
        examples=[[0.056, 0.049, 0.074, 0.0029, 0.0031, 0.003]],
    )
    noise_std: Numbers = Field(
        description="Standard deviation of the sensor's noise, force (N), then torque (N m).",
        examples=[[0.055, 0.048, 0.073, 0.0028, 0.003, 0.003]],
    )


class VerificationPart(ResultPart):
    """A motion that was left out, predicted by a fit to all the rest."""

    phase: str = Field(description="The motion that was left out.", examples=["rotate:x"])
    windows: int = Field(description="Short averages that were compared.", examples=[120])
    rms: list[float] = Field(
        description="Of measured minus predicted, force (N), then torque (N m).", examples=[[0.012, 0.011, 0.015, 0.0006, 0.0007, 0.0006]]
    )
    noise_std: list[float] = Field(
        description="What noise alone makes of it, force (N), then torque (N m).", examples=[[0.011, 0.01, 0.014, 0.0006, 0.0006, 0.0006]]
    )
    expected: list[float] = Field(
        description="The same with the uncertainty of the prediction, force (N), then torque (N m).",
        examples=[[0.012, 0.011, 0.015, 0.0006, 0.0006, 0.0006]],
    )
    ratio: float = Field(
        description="Seen against expected over all channels, without a unit: near 1 where the estimate holds on something new.",
        examples=[1.04],
    )


class SafetyPart(ResultPart):
    """What the guard saw. Not a safety function: `safety_rated` is always false."""

    min_distance_m: float | None = Field(
        description="Smallest distance of everything that moved to obstacles and zones, m; null where there is neither.", examples=[0.043]
    )
    nearest: str | None = Field(description="What was that near.", examples=["bench"])
    max_speed_m_s: float = Field(description="Largest speed of any point of robot or payload box, m/s.", examples=[0.231])
    restarts: int = Field(description="How often the guard stopped the robot.", examples=[0])
    safety_rated: Literal[False] = Field(default=False, description="Always false: the guard is not a safety function.")
    min_distance_beyond_first_joint_m: float | None = Field(
        default=None, description="The smallest distance without the links that only the first joint moves, m.", examples=[0.052]
    )


class SecondsPart(ResultPart):
    """Where the time went."""

    plan: float | None = Field(default=None, description="Time of planning, s.", examples=[4.2])
    robot: float | None = Field(default=None, description="Time of the motion, s.", examples=[58.4])
    estimate: float = Field(description="Time of the estimation, s.", examples=[1.1])


class ToolPart(ResultPart):
    """A tool that was taken off; `std` is null where nobody has stated it."""

    name: str = Field(description="Name of the tool.", examples=["gripper"])
    title: str = Field(description="What people call it.", examples=["Gripper"])
    phi: list[float] = Field(
        description="Its ten parameters: mass (kg), first moment (kg m), inertia about the sensor's origin (kg m2).",
        examples=[[0.92, 0.0, 0.0, 0.041, 0.0031, 0.0, 0.0, 0.0031, 0.0, 0.0011]],
    )
    std: Numbers = Field(
        description="Their standard deviations; null where nobody has stated them.",
        examples=[[0.005, None, None, None, None, None, None, None, None, None]],
    )


class WorkpiecePart(ResultPart):
    """The workpiece alone: the estimate without the tools, its covariance with theirs."""

    phi: Numbers = Field(
        description="Mass (kg), first moment (kg m), inertia about the sensor's origin (kg m2); null is what is not determined.",
        examples=[[1.86, 0.0, -0.0468, 0.0605, 0.0038, 0.0, 0.0, 0.0035, 0.0017, 0.0022]],
    )
    std: Numbers = Field(
        description="Standard uncertainties of `phi`, in the same units.",
        examples=[[0.006, 0.0005, 0.0005, 0.0005, 0.0002, 0.0001, 0.0001, 0.0002, 0.0001, 0.0001]],
    )
    covariance: list[Numbers] = Field(
        description="Covariance of `phi`, ten rows of ten, that of the tools included.", examples=[[[3.6e-05, 0.0], [0.0, 2.5e-07]]]
    )
    com_m: Numbers = Field(description="Centre of mass, m, sensor frame.", examples=[[0.0, -0.0252, 0.0325]])
    com_std_m: Numbers = Field(description="Its standard uncertainties, m.", examples=[[0.0003, 0.0003, 0.0003]])
    inertia_com_kg_m2: Numbers = Field(
        description="Ixx Ixy Ixz Iyy Iyz Izz about the centre of mass, kg m2.", examples=[[0.0007, 0.0, 0.0, 0.0015, 0.0002, 0.001]]
    )
    inertia_com_std_kg_m2: Numbers = Field(
        description="Their standard uncertainties, kg m2.", examples=[[0.0002, 0.0001, 0.0001, 0.0002, 0.0001, 0.0001]]
    )
    consistent: bool = Field(description="Whether a rigid body can have these parameters.")
    reference: ReferencePart | None = Field(description="The workpiece as somebody else knows it.")
    tools: list[ToolPart] = Field(description="What was taken off.")
    remarks: list[Message] = Field(description="What has to be known of the numbers.")


class TwinSharePart(ResultPart):
    """What one entry of the cell's twin does to the estimate."""

    effect: str = Field(description="Identifier of the effect.", examples=["time_delay"])
    title: Message = Field(description="What the effect is called.")
    recording: str = Field(description="Digest of the recording that the entry was fitted to.", examples=["sha256:5f1d"])
    change: Numbers = Field(
        description="Estimate with the entry less without it: mass (kg), first moment (kg m), inertia about the sensor's origin (kg m2); "
        "null where the estimate is not determined.",
        examples=[[0.002, 0.0001, 0.0, -0.0003, 0.0, 0.0, 0.0, 0.00001, 0.0, 0.00002]],
    )


class Result(ResultPart):
    """The whole answer. Where the cell has tools, `estimate`, `paper` and `reference` are of the whole that the sensor feels."""

    cell: str | None
    payload: str | None
    verdict: Message
    warnings: list[Message]
    reference: ReferencePart | None
    paper: PaperPart
    estimate: EstimatePart | None
    residual: ResidualPart | None
    safety: SafetyPart | None
    seconds: SecondsPart
    recording: str | None
    accounted: list[str] = Field(default_factory=list)
    """Effects of the cell's twin that were taken off the wrench."""
    twin: list[TwinSharePart] = Field(default_factory=list)
    """What each of these changed; nothing in results of earlier versions."""
    verification: list[VerificationPart] = Field(default_factory=list)
    requirement: RequirementPart | None = None
    """Whether it is good enough for the cell; None where no cell was named, and in results of earlier versions."""
    target: TargetPart | None = None
    """How far it meets the target that it was asked for with; None where there was none."""
    workpiece: WorkpiecePart | None = None
    """None where there are no tools: then the whole is the workpiece."""
    order: OrderReference | None = None
    """That it was found out for; None where nobody named one."""
    version: str | None = None
    """Of the code that made it, see `core.version`; None in results from before it was kept."""
    plan_sha256: str | None = None
    """Of the plan that was carried out, hexadecimal; None of a recording from elsewhere, and in results of earlier versions."""
    ended_at: datetime | None = None
    """When the robot had done its part; None likewise."""
    joints: list[JointPart] = Field(
        default_factory=list, description="What was found of each joint, where the payload was identified from their torques."
    )


def result_of(
    identification: Identification,
    recording: Recording,
    *,
    seconds: SecondsPart,
    requirement: RequirementPart | None = None,
    target: TargetPart | None = None,
    safety: SafetyPart | None = None,
    folder: Path | None = None,
    plan_sha256: str | None = None,
    at: datetime | None = None,
) -> Result:
    """Everything that an identification says, ready for JSON."""
    estimate, reference = identification.estimate, recording.reference_of_whole
    return Result(
        cell=recording.cell,
        payload=recording.payload,
        verdict=identification.verdict,
        warnings=list(identification.warnings),
        reference=None if reference is None else ReferencePart(phi=to_json_numbers(reference.phi), source=recording.source_of_whole),
        paper=PaperPart(phi=to_json_numbers(identification.paper.phi), std=to_json_numbers(identification.paper.std)),
        estimate=None if estimate is None else _estimate_part(estimate),
        residual=None
        if estimate is None
        else ResidualPart(rms=to_json_numbers(estimate.residual_rms), noise_std=to_json_numbers(estimate.noise_std)),
        safety=safety,
        seconds=seconds,
        recording=None if folder is None else str(folder),
        accounted=list(identification.accounted),
        twin=[_twin_share_part(share, estimate) for share in identification.shares],
        verification=[_verification_part(each) for each in identification.verification],
        requirement=requirement,
        target=target,
        workpiece=None if estimate is None or not recording.tools else _workpiece_part(estimate, recording),
        order=recording.order or None,
        version=code_version(),
        plan_sha256=plan_sha256,
        ended_at=at,
        joints=[joint_part(each) for each in identification.joints if each.windows],
    )


def _twin_share_part(share: TwinShare, estimate: Estimate | None) -> TwinSharePart:
    known = np.zeros(10, dtype=bool) if estimate is None else estimate.determined
    change = to_json_numbers(np.where(known, share.change, np.nan))
    return TwinSharePart(effect=share.effect, title=share.title, recording=share.recording, change=change)


def _workpiece_part(estimate: Estimate, recording: Recording) -> WorkpiecePart:
    found, reference = workpiece_alone(estimate, recording.tools), recording.reference
    return WorkpiecePart(
        phi=to_json_numbers(found.phi),
        std=to_json_numbers(found.std),
        covariance=[to_json_numbers(row) for row in found.covariance],
        com_m=to_json_numbers(found.com_m),
        com_std_m=to_json_numbers(found.com_std),
        inertia_com_kg_m2=to_json_numbers(found.inertia_com),
        inertia_com_std_kg_m2=to_json_numbers(found.inertia_com_std),
        consistent=found.consistent,
        reference=None if reference is None else ReferencePart(phi=to_json_numbers(reference.phi), source=recording.reference_source),
        tools=[
            ToolPart(name=tool.name, title=tool.title, phi=tool.parameters.phi.tolist(), std=to_json_numbers(tool.std))
            for tool in found.tools
        ],
        remarks=list(found.remarks),
    )


def _verification_part(found: Verification) -> VerificationPart:
    return VerificationPart(
        phase=found.phase,
        windows=found.windows,
        rms=found.rms.tolist(),
        noise_std=found.noise.tolist(),
        expected=found.expected.tolist(),
        ratio=found.ratio,
    )


def _estimate_part(estimate: Estimate) -> EstimatePart:
    tilt, tilt_std = estimate.base_tilt_rad, estimate.base_tilt_std
    return EstimatePart(
        phi=to_json_numbers(estimate.phi),
        std=to_json_numbers(estimate.std),
        covariance=[to_json_numbers(row) for row in estimate.covariance],
        determined=[bool(flag) for flag in estimate.determined],
        reasons=estimate.reasons,
        offset=to_json_numbers(estimate.offset),
        offset_std=to_json_numbers(estimate.offset_std),
        com_m=to_json_numbers(estimate.com_m),
        com_std_m=to_json_numbers(estimate.com_std),
        inertia_com_kg_m2=to_json_numbers(estimate.inertia_com),
        inertia_com_std_kg_m2=to_json_numbers(estimate.inertia_com_std),
        consistent=estimate.consistent,
        base_tilt_rad=None if tilt is None else to_json_numbers(tilt),
        base_tilt_std_rad=None if tilt_std is None else to_json_numbers(tilt_std),
        delay_s=estimate.delay_s,
        delay_std_s=estimate.delay_std,
        budget=budget_part(estimate),
    )
