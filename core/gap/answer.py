"""A diagnosis as it leaves the engine: JSON, SI units; what is not known is null."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AliasChoices, BaseModel, BeforeValidator, ConfigDict, Field

from core.effects.sides import Side
from core.planning.stop import Stop
from core.words.message import Message

Verdict = Literal["no_gap", "explained", "ambiguous", "unknown", "not_enough"]


def _read_earlier(value: object) -> object:
    """Nothing was an empty sentence in earlier versions."""
    return value if value != "" else None


MessageIfAny = Annotated[Message | None, BeforeValidator(_read_earlier)]
Seen = Annotated[Message, Field(validation_alias=AliasChoices("message", "sentence"))]

Triangle = list[list[float]]
"""A symmetric matrix up to its diagonal, row by row."""

SIDES: dict[Side, Message] = {
    "joints": Message.of("gap-at-joints"),
    "reading": Message.of("gap-in-readings"),
    "reference": Message.of("gap-against-reference"),
}
"""Where something is seen, in words."""


class DiagnosisPart(BaseModel):
    """Frozen, without NaN."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False)


class Value(DiagnosisPart):
    """A fitted parameter.

    Args:
        title: what it is called.
    """

    title: Message | None = None
    value: float
    std: float | None
    unit: str
    at_bound: bool = False


class Explanation(DiagnosisPart):
    """One effect with what it would do to the gap.

    Args:
        addable: whether the cell's twin would take it, as this recording shows it; `why_not` says what stands against it.
        covariance: of the parameters, in their order, each row up to the diagonal; nothing where no twin would take it.
    """

    id: str
    title: Message
    stage: str
    probability: float
    parameters: dict[str, Value]
    gap_after: float
    closure: float
    closure_interval: tuple[float, float]
    advice: Message
    addable: bool = False
    why_not: MessageIfAny = None
    covariance: Triangle = []


class Pair(DiagnosisPart):
    """Two effects at once; `addable` and `why_not` as of one, `covariance` of the parameters of each."""

    ids: tuple[str, str]
    probability: float
    gap_after: float
    closure: float
    parameters: dict[str, dict[str, Value]] = {}
    addable: bool = False
    why_not: MessageIfAny = None
    covariance: dict[str, Triangle] = {}


class Also(DiagnosisPart):
    """What is seen elsewhere than in the wrench that the twin predicts: it explains no gap there, and is judged by a measure of its own.

    Args:
        side: where it is seen: at the joints, in the sensor's readings, against the reference payload.
        times_expected: how many times what is stated or tolerated; null where nothing is.
        message: what was seen.
        advice: what a person should do where it is material.
    """

    id: str
    title: Message
    side: Side
    parameters: dict[str, Value]
    times_expected: float | None
    material: bool
    message: Seen
    advice: Message


class Minor(DiagnosisPart):
    """An effect on the wrench that was detected, but is not material."""

    id: str
    parameters: dict[str, Value]
    message: Seen


class Tied(DiagnosisPart):
    """What this recording cannot tell apart."""

    ids: tuple[str, ...]
    distance_sigma: float
    why: Message
    splits: Message


class PatchPart(DiagnosisPart):
    """Channel x motion x band."""

    channel: str
    phase: str
    band_hz: tuple[float, float]
    times_noise: float
    share: float


class JointGap(DiagnosisPart):
    """The joints' side: error of tracking while the joint moves, noise of one sample of it, and torque that arm and payload do not
    account for. None where it was not recorded, or the arm's masses are not known."""

    joint: str
    tracking_rms_rad: float | None
    tracking_noise_rad: float | None
    torque_rms_n_m: float | None


class Where(DiagnosisPart):
    """Where the gap lies; mean squares by direction and by pose (the sensor axis that points up or down) are against noise 1."""

    cells: list[PatchPart]
    channel: str
    phase: str
    stage: str
    by_time: list[float]
    by_direction: dict[str, float]
    by_pose: dict[str, float] = {}
    joints: list[JointGap] = []
    message: Seen


class Change(DiagnosisPart):
    """Before and after."""

    before: float
    after: float


class GapPart(DiagnosisPart):
    """Root mean square of (measured - simulated) over its noise, on motions that the fit did not see."""

    before: float
    after: float
    floor: float = 1.0
    unit: str = "noise sigma, rms"
    held_out: list[str]
    by_channel: dict[str, Change]


class PhiPart(DiagnosisPart):
    """Phi in the paper's order, with standard uncertainties."""

    phi: list[float]
    std: list[float]


class PayloadPart(DiagnosisPart):
    """The payload before and after the effect was added."""

    before: PhiPart
    after: PhiPart


class Experiment(DiagnosisPart):
    """What to measure next, and what it is going to tell.

    Args:
        id, motion: what to do, in one word and as a message.
        stops: the same for planning; empty where it is no motion.
        splits: what it tells apart, the worst tie first.
        sigma_before, sigma_after: distance of that tie now, and as predicted for both recordings together.
        seconds: of the robot, by kinematics alone, or as planned.
        planned: whether a cell was at hand and the motion is planned in it; `refused` says why not.
    """

    id: str
    motion: Message
    stops: list[Stop]
    splits: list[tuple[str, str]]
    sigma_before: float
    sigma_after: float
    seconds: float
    planned: bool = False
    refused: MessageIfAny = Message.of("gap-no-cell")
    refused_kind: str | None = None
    """The error's, see `core.errors`; null where it was not planned for want of a cell, or is no motion."""


class Origin(DiagnosisPart):
    """What was diagnosed, as far as the twin is concerned that takes something from it.

    Args:
        recording: name of its folder; `sha256`: of its files.
        cell: that it names.
        joints: how many it has; 0 where it has poses only.
        twin: what the diagnosis began with, see `core.twin.twin.Twin.hashes`; also what could not be evaluated in this recording.
    """

    recording: str
    sha256: str
    cell: str | None
    joints: int
    twin: dict[str, str]


class Diagnosis(DiagnosisPart):
    """The whole answer; all of it but `also` is about the wrench that the twin predicts."""

    verdict: Verdict
    summary: Message
    effects: list[Explanation]
    none_probability: float
    unknown_probability: float
    pairs: list[Pair]
    minor: list[Minor]
    also: list[Also] = []
    indistinguishable: list[Tied]
    where: Where | None
    gap: GapPart | None
    payload: PayloadPart | None
    consequence: MessageIfAny
    next_experiment: Experiment | None
    limits: list[Message]
    lacking: MessageIfAny = None
    """Why nothing can be said, where the recording is not enough."""
    seconds: float
    twin: list[str] = []
    """Effects of the cell's twin, which were on from the beginning."""
    origin: Origin | None = None
    """Null in the answers of earlier versions, and where the recording is in no folder."""
