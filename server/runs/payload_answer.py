"""What the robot carries, as the MES reads it: units in every name, uncertainty beside every number."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from core.estimation.budget_part import BudgetPart
from core.estimation.result import (
    PaperPart,
    ReferencePart,
    ResidualPart,
    Result,
    SafetyPart,
    SecondsPart,
    TwinSharePart,
    VerificationPart,
    WorkpiecePart,
)
from core.estimation.result_part import Numbers
from core.recording.order_reference import OrderReference
from core.requirement.answer import RequirementPart
from core.requirement.target_answer import TargetPart
from core.words.message import Message
from server.http.schemas import Answer


class IdentificationPublic(Answer):
    """The payload in the sensor frame; null is what is not determined, `reasons` says why."""

    cell: str | None = Field(description="Name of the cell.", examples=["lwr4_bench"])
    payload: str | None = Field(description="Name of the payload.", examples=["steel_block"])
    order: OrderReference | None = Field(
        description="The order that it was found out for, as the plant names it; null where nobody named one."
    )
    version: str | None = Field(
        description="Release and digest of the code that made it; null in results from before it was kept.", examples=["0.1.0+3f9c2ab17d"]
    )
    verdict: Message = Field(description="The result in a sentence.")
    requirement: RequirementPart | None = Field(
        default=None,
        description="Whether it is good enough for the cell's controller, with margin and what decides; null in older results.",
    )
    target: TargetPart | None = Field(
        default=None,
        description="How far it meets the target of its order, and what the run left out; null where there was none, and in older results.",
    )
    warnings: list[Message] = Field(description="What has to be known before the numbers are used.")
    mass_kg: float | None = Field(description="Mass, kg; null where it is not determined.", examples=[2.783])
    mass_std_kg: float | None = Field(description="Its combined standard uncertainty, kg.", examples=[0.002])
    com_m: Numbers = Field(description="Centre of mass, m, sensor frame.", examples=[[0.0, -0.0168, 0.0365]])
    com_std_m: Numbers = Field(description="Its combined standard uncertainties, m.", examples=[[0.0001, 0.0001, 0.0001]])
    inertia_com_kg_m2: Numbers = Field(
        description="Ixx Ixy Ixz Iyy Iyz Izz about the centre of mass, kg m2.", examples=[[0.0024, 0.0, 0.0, 0.0029, 0.0, 0.0025]]
    )
    inertia_com_std_kg_m2: Numbers = Field(
        description="Their combined standard uncertainties, kg m2.", examples=[[0.0001, 0.0001, 0.0001, 0.0001, 0.0001, 0.0001]]
    )
    inertia_sensor_kg_m2: Numbers = Field(
        description="Ixx Ixy Ixz Iyy Iyz Izz about the sensor's origin, kg m2.", examples=[[0.0069, 0.0, 0.0, 0.0066, 0.0017, 0.0033]]
    )
    inertia_sensor_std_kg_m2: Numbers = Field(
        description="Their combined standard uncertainties, kg m2.", examples=[[0.0001, 0.0001, 0.0001, 0.0001, 0.0001, 0.0001]]
    )
    parameters: Numbers = Field(
        description="Mass (kg), first moment (kg m), inertia about the sensor's origin (kg m2); null is what is not determined.",
        examples=[[2.783, 0.0, -0.0468, 0.1015, 0.0069, 0.0, 0.0, 0.0066, 0.0017, 0.0033]],
    )
    covariance: list[Numbers] = Field(
        description="Covariance of `parameters`, ten rows of ten, products of their units.", examples=[[[4e-06, 0.0], [0.0, 9e-08]]]
    )
    budget: BudgetPart | None = Field(
        default=None,
        description="Where the uncertainty comes from: the repeatability and what stays the same from run to run; null in results of "
        "earlier versions, whose uncertainties are the repeatability alone.",
    )
    reasons: dict[str, Message] = Field(description="By parameter, why it is not determined.")
    reference: ReferencePart | None = Field(description="The payload as somebody else knows it; null where nobody does.")
    paper: PaperPart = Field(description="The paper's own estimate, for comparison.")
    residual: ResidualPart | None = Field(description="How well the estimate reconstructs the wrench.")
    verification: list[VerificationPart] = Field(description="Each rotation left out once and predicted by a fit to all the rest.")
    safety: SafetyPart | None = Field(description="What the guard saw; null for a recording from elsewhere.")
    seconds: SecondsPart = Field(description="Times of planning, motion and estimation.")
    safety_rated: Literal[False] = Field(default=False, description="Always false: it is not a safety function.")
    workpiece: WorkpiecePart | None = Field(
        default=None, description="Without the tools that the cell knows, which everything else contains; null where it knows none."
    )
    twin: list[TwinSharePart] = Field(
        default_factory=list, description="Entries of the cell's twin that the estimate takes into account, and what each of them changes."
    )


class ResultPublic(IdentificationPublic):
    """What a run found: the payload in the sensor frame; null is what is not determined, `reasons` says why."""

    run: str = Field(description="Identifier of the run.", examples=["019ab1c2d3e44f1c2a9be7"])


def run_answer(run: str, result: Result) -> ResultPublic:
    """The engine's answer on a run."""
    return ResultPublic(run=run, **dict(payload_answer(result)))


def payload_answer(result: Result) -> IdentificationPublic:
    """The engine's answer with its units in the names."""
    found = result.estimate
    phi, std = ([None] * 10, [None] * 10) if found is None else (found.phi, found.std)
    return IdentificationPublic(
        cell=result.cell,
        payload=result.payload,
        order=result.order,
        version=result.version,
        verdict=result.verdict,
        requirement=result.requirement,
        target=result.target,
        warnings=result.warnings,
        mass_kg=phi[0],
        mass_std_kg=std[0],
        com_m=[None] * 3 if found is None else found.com_m,
        com_std_m=[None] * 3 if found is None else found.com_std_m,
        inertia_com_kg_m2=[None] * 6 if found is None else found.inertia_com_kg_m2,
        inertia_com_std_kg_m2=[None] * 6 if found is None else found.inertia_com_std_kg_m2,
        inertia_sensor_kg_m2=list(phi[4:]),
        inertia_sensor_std_kg_m2=list(std[4:]),
        parameters=list(phi),
        covariance=[[None] * 10] * 10 if found is None else found.covariance,
        budget=None if found is None else found.budget,
        reasons={} if found is None else found.reasons,
        reference=result.reference,
        paper=result.paper,
        residual=result.residual,
        verification=result.verification,
        safety=result.safety,
        seconds=result.seconds,
        workpiece=result.workpiece,
        twin=result.twin,
    )
