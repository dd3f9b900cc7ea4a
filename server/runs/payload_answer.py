"""What the robot carries, as the MES reads it: units in every name, uncertainty beside every number."""

from __future__ import annotations

from typing import Literal

from core.estimation.result import (
    Numbers,
    PaperPart,
    ReferencePart,
    ResidualPart,
    Result,
    SafetyPart,
    SecondsPart,
    VerificationPart,
    WorkpiecePart,
)
from core.words.message import Message
from server.http.schemas import Answer


class PayloadAnswer(Answer):
    """The payload in the sensor frame; null is what is not determined, `reasons` says why.

    Args:
        com_m: centre of mass.
        inertia_com_kg_m2: Ixx Ixy Ixz Iyy Iyz Izz about the centre of mass; `inertia_sensor_kg_m2` about the sensor's origin.
        parameters: mass (kg), first moment (kg m), inertia about the sensor's origin (kg m2), in this order; `covariance` is theirs.
        workpiece: without the tools that the cell knows, which everything else contains; null where it knows none.
    """

    run: str
    cell: str | None
    payload: str | None
    verdict: Message
    warnings: list[Message]
    mass_kg: float | None
    mass_std_kg: float | None
    com_m: Numbers
    com_std_m: Numbers
    inertia_com_kg_m2: Numbers
    inertia_com_std_kg_m2: Numbers
    inertia_sensor_kg_m2: Numbers
    inertia_sensor_std_kg_m2: Numbers
    parameters: Numbers
    covariance: list[Numbers]
    reasons: dict[str, Message]
    reference: ReferencePart | None
    paper: PaperPart
    residual: ResidualPart | None
    verification: list[VerificationPart]
    safety: SafetyPart | None
    seconds: SecondsPart
    safety_rated: Literal[False] = False
    workpiece: WorkpiecePart | None = None


def payload_answer(run: str, result: Result) -> PayloadAnswer:
    """The engine's answer with its units in the names."""
    found = result.estimate
    phi, std = ([None] * 10, [None] * 10) if found is None else (found.phi, found.std)
    return PayloadAnswer(
        run=run,
        cell=result.cell,
        payload=result.payload,
        verdict=result.verdict,
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
        reasons={} if found is None else found.reasons,
        reference=result.reference,
        paper=result.paper,
        residual=result.residual,
        verification=result.verification,
        safety=result.safety,
        seconds=result.seconds,
        workpiece=result.workpiece,
    )
