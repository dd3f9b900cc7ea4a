"""What a certificate says, as JSON: the page is made of this and of nothing else."""

from __future__ import annotations

from datetime import datetime
from hashlib import sha256
from typing import Literal

from pydantic import Field

from core.certificate.conformity import Conformity
from core.certificate.values import COVERAGE_FACTOR, CertifiedValue
from core.estimation.result import TwinSharePart, WorkpiecePart
from core.estimation.result_part import Numbers, ResultPart
from core.payload.calibration import NOT_STATED, SensorCalibration
from core.recording.order_reference import OrderReference
from core.words.message import Message

FORMAT: Literal["certificate/1"] = "certificate/1"


class CertifiedSensor(ResultPart):
    """The sensor as the recording states it."""

    name: str | None = Field(default=None, description="Make and model; null where nobody has said.", examples=["ATI Mini45"])
    frame: str | None = Field(default=None, description="Name of its frame, in which the values are.", examples=["ft_sensor"])
    range: list[float] | None = Field(
        default=None, description="Measuring range, force (N), then torque (N m).", examples=[[145.0, 145.0, 290.0, 5.0, 5.0, 5.0]]
    )
    calibration: SensorCalibration = Field(default=NOT_STATED, description="What its certificate states; null is what nobody has said.")


class RecordingFacts(ResultPart):
    """What a certificate takes from the recording itself; null where there is none any more."""

    sha256: str | None = Field(default=None, description="Of manifest, samples and URDF, hexadecimal.", examples=["5f1d" * 16])
    sensor: CertifiedSensor = Field(default=CertifiedSensor(), description="The sensor, as the recording states it.")


class Certificate(ResultPart):
    """Null is what nobody has stated; times are UTC."""

    format: Literal["certificate/1"] = Field(default=FORMAT, description="Version of this format.", examples=[FORMAT])
    run: str | None = Field(description="Identifier of the run; null of what no service has carried.", examples=["019ab1c2d3e44f1c2a9be7"])
    cell: str | None = Field(description="Name of the cell.", examples=["lwr4_bench"])
    payload: str | None = Field(description="Name of the payload.", examples=["steel_block"])
    order: OrderReference = Field(description="The order that it was found out for, as the plant names it.")
    ended_at: datetime | None = Field(description="When the robot had done its part.", examples=["2026-03-01T08:00:24Z"])
    released_by: str | None = Field(description="Who let the robot move.", examples=["account:anna"])
    accepted_by: str | None = Field(description="Who took the result for good; null before that.", examples=["account:berta"])
    accepted_at: datetime | None = Field(description="When; null before that.", examples=["2026-03-01T08:03:00Z"])
    software: str = Field(description="Release and digest of the code that made the result.", examples=["0.1.0+3f9c2ab17d"])
    plan_sha256: str | None = Field(description="Of the plan that was carried out, hexadecimal.", examples=["9f86" * 16])
    recording: RecordingFacts = Field(description="The recording that the values are from.")
    verdict: Message = Field(description="The result in a sentence.")
    coverage_factor: float = Field(
        default=COVERAGE_FACTOR, description="Standard uncertainties in an expanded one: an interval of 95 %.", examples=[1.96]
    )
    values: list[CertifiedValue] = Field(description="Mass, centre of mass, inertia about it: ten values, of all that the sensor carries.")
    phi: Numbers = Field(
        description="Mass (kg), first moment (kg m), inertia about the sensor's origin (kg m2); null is what is not determined.",
        examples=[[2.783, 0.0, -0.0468, 0.1015, 0.0069, 0.0, 0.0, 0.0066, 0.0017, 0.0033]],
    )
    covariance: list[Numbers] = Field(
        description="Covariance of `phi`, ten rows of ten, products of their units.", examples=[[[4e-06, 0.0], [0.0, 9e-08]]]
    )
    workpiece: WorkpiecePart | None = Field(description="Without the tools that are known; null where there are none.")
    twin: list[TwinSharePart] = Field(description="Effects of the cell's twin that were taken into account.")
    assumptions: list[Message] = Field(description="What nobody has stated, was assumed and matters.")
    warnings: list[Message] = Field(description="What has to be known before the numbers are used.")
    conformity: Conformity = Field(description="Whether the values are good enough for the cell's controller.")
    safety_rated: Literal[False] = Field(default=False, description="Always false: it is not a safety function.")


def dump_certificate(certificate: Certificate) -> bytes:
    """As it is kept: the same certificate gives the same bytes."""
    return (certificate.model_dump_json(indent=2) + "\n").encode()


def certificate_sha256(certificate: Certificate) -> str:
    """Of these bytes, hexadecimal: what the page names."""
    return sha256(dump_certificate(certificate)).hexdigest()
