"""The answer of a run or of an identification as it leaves the engine: JSON, SI units, sensor frame, the paper's order of Phi."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict

from core.array import Array
from core.recording.recording import Recording
from core.recording.workpiece import workpiece_alone
from core.version import code_version
from core.words.message import Message

if TYPE_CHECKING:  # who only reads answers waits for no estimator
    from core.estimation.estimate import Estimate, Identification, Verification

Numbers = list[float | None]


class ResultPart(BaseModel):
    """Frozen; infinities and NaN never leave: what is not known is null."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False)


class ReferencePart(ResultPart):
    """The payload as somebody else knows it; beside the whole with the tools, beside the workpiece alone without them."""

    phi: Numbers
    source: str | None


class PaperPart(ResultPart):
    """Algorithms 1-5 with Eq. (8)-(10)."""

    phi: Numbers
    std: Numbers


class EstimatePart(ResultPart):
    """The estimate from all samples."""

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


class ResidualPart(ResultPart):
    """Measured minus reconstructed wrench, force then torque."""

    rms: Numbers
    noise_std: Numbers


class VerificationPart(ResultPart):
    """A motion that was left out, predicted by a fit to all the rest.

    Args:
        windows: short averages that were compared; `rms` of measured minus predicted, force (N), then torque (N m).
        noise_std: what noise alone makes of it; `expected` with the uncertainty of the prediction.
        ratio: what is seen against what is expected, over all channels: near 1 where the estimate holds on something new.
    """

    phase: str
    windows: int
    rms: list[float]
    noise_std: list[float]
    expected: list[float]
    ratio: float


class SafetyPart(ResultPart):
    """What the guard saw. Not a safety function: `safety_rated` is always false.

    Args:
        min_distance_m: of everything that moves to obstacles and zones, `nearest` is what was that near.
        min_distance_beyond_first_joint_m: the same without the links that only the first joint moves, whose distance hardly changes.
    """

    min_distance_m: float | None
    nearest: str | None
    max_speed_m_s: float
    restarts: int
    safety_rated: Literal[False] = False
    min_distance_beyond_first_joint_m: float | None = None


class SecondsPart(ResultPart):
    """Where the time went."""

    plan: float | None = None
    robot: float | None = None
    estimate: float


class ToolPart(ResultPart):
    """A tool that was taken off; `std` is null where nobody has stated it."""

    name: str
    title: str
    phi: list[float]
    std: Numbers


class WorkpiecePart(ResultPart):
    """The workpiece alone: the estimate without the tools, its covariance with theirs.

    Args:
        remarks: what has to be known of the numbers.
    """

    phi: Numbers
    std: Numbers
    covariance: list[Numbers]
    com_m: Numbers
    com_std_m: Numbers
    inertia_com_kg_m2: Numbers
    inertia_com_std_kg_m2: Numbers
    consistent: bool
    reference: ReferencePart | None
    tools: list[ToolPart]
    remarks: list[Message]


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
    accounted: list[str] = []
    """Effects of the cell's twin that were taken off the wrench."""
    verification: list[VerificationPart] = []
    workpiece: WorkpiecePart | None = None
    """None where there are no tools: then the whole is the workpiece."""
    version: str | None = None
    """Of the code that made it, see `core.version`; None in results from before it was kept."""


def to_json_numbers(values: Array | None) -> Numbers:
    """A list with null for NaN."""
    return [] if values is None else [float(v) if np.isfinite(v) else None for v in values]


def result_of(
    identification: Identification,
    recording: Recording,
    *,
    seconds: SecondsPart,
    safety: SafetyPart | None = None,
    folder: Path | None = None,
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
        verification=[_verification_part(each) for each in identification.verification],
        workpiece=None if estimate is None or not recording.tools else _workpiece_part(estimate, recording),
        version=code_version(),
    )


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
    )
