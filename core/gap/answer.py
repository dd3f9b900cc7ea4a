"""A diagnosis as it leaves the engine: JSON, SI units; what is not known is null."""

from __future__ import annotations

import math
from typing import Annotated, Literal, TypeAlias

from pydantic import AfterValidator, AliasChoices, BaseModel, BeforeValidator, ConfigDict, Field, computed_field

from core.cell.kinematics import Axes
from core.effects.parameter_title import find_title
from core.effects.sides import Side
from core.gap.instruction import Instruction, instruct
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

INTERVAL = 1.96
"""Half the width of a 95 % interval, in standard uncertainties."""

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
    """A fitted parameter."""

    title: Message | None = Field(default=None, description="What it is called.")
    value: float = Field(description="The fitted value, in `unit`.", examples=[0.0042])
    std: float | None = Field(description="Its standard uncertainty, in `unit`; null where it has none.", examples=[0.0002])
    unit: str = Field(description="Unit of `value` and `std`.", examples=["s"])
    at_bound: bool = Field(default=False, description="Whether the fit ended at a bound of what is plausible.")


def _give_titles(parameters: dict[str, Value]) -> dict[str, Value]:
    return {name: value.model_copy(update={"title": value.title or find_title(name)}) for name, value in parameters.items()}


Values: TypeAlias = Annotated[dict[str, Value], AfterValidator(_give_titles)]
"""Fitted parameters by name, each with its title, which answers of earlier versions do not have."""


class Explanation(DiagnosisPart):
    """One effect with what it would do to the gap."""

    id: str = Field(description="Name of the effect.", examples=["time_delay"])
    title: Message = Field(description="What it is called.")
    stage: str = Field(description="Where on the way from payload to reading it acts.", examples=["reading"])
    probability: float = Field(description="Probability of this explanation, 0 to 1.", examples=[0.93])
    parameters: Values = Field(description="Its fitted parameters by name.")
    gap_after: float = Field(description="What is left of the gap with it, in multiples of the noise (rms).", examples=[1.1])
    closure: float = Field(description="Share of the gap that goes away with it, 0 to 1.", examples=[0.97])
    closure_interval: tuple[float, float] = Field(description="95 % interval of `closure`.", examples=[[0.95, 0.98]])
    advice: Message = Field(description="What to do about it.")
    addable: bool = Field(default=False, description="Whether the cell's twin would take it, as this recording shows it.")
    why_not: MessageIfAny = Field(default=None, description="What stands against that; null where nothing does.")
    covariance: Triangle = Field(
        default_factory=list,
        description="Of the parameters, in their order, each row up to the diagonal; empty where no twin would take it.",
        examples=[[[4e-08]]],
    )


class Pair(DiagnosisPart):
    """Two effects at once, or three; `addable` and `why_not` as of one, `covariance` of the parameters of each."""

    ids: tuple[str, ...] = Field(description="Names of the effects.", min_length=2, max_length=3, examples=[["time_delay", "base_tilt"]])
    probability: float = Field(description="Probability of this explanation, 0 to 1.", examples=[0.71])
    gap_after: float = Field(description="What is left of the gap with all of them, in multiples of the noise (rms).", examples=[1.05])
    closure: float = Field(description="Share of the gap that goes away with all of them, 0 to 1.", examples=[0.98])
    parameters: dict[str, Values] = Field(default_factory=dict, description="Fitted parameters by effect and name.")
    advice: dict[str, Message] = Field(default_factory=dict, description="What to do about each effect, as it is beside the others.")
    addable: bool = Field(default=False, description="Whether the cell's twin would take all of them.")
    why_not: MessageIfAny = Field(default=None, description="What stands against that; null where nothing does.")
    covariance: dict[str, Triangle] = Field(
        default_factory=dict,
        description="Of the parameters of each effect, each row up to the diagonal.",
        examples=[{"time_delay": [[4e-08]]}],
    )


class Also(DiagnosisPart):
    """What is seen elsewhere than in the wrench that the twin predicts: it explains no gap there, and is judged by a measure of its own."""

    id: str = Field(description="Name of the effect or symptom.", examples=["joint_backlash"])
    title: Message = Field(description="What it is called.")
    side: Side = Field(description="Where it is seen.")
    parameters: Values = Field(description="Its fitted parameters by name.")
    times_expected: float | None = Field(description="How many times what is stated or tolerated; null where nothing is.", examples=[2.4])
    material: bool = Field(description="Whether somebody should do something about it.")
    message: Seen = Field(description="What was seen.")
    advice: Message = Field(description="What to do where it is material.")


class Minor(DiagnosisPart):
    """An effect on the wrench that was detected, but is not material."""

    id: str = Field(description="Name of the effect.", examples=["sensor_drift"])
    parameters: Values = Field(description="Its fitted parameters by name.")
    message: Seen = Field(description="What was seen.")


class Tied(DiagnosisPart):
    """What this recording cannot tell apart."""

    ids: tuple[str, ...] = Field(
        description="Effects that this recording cannot tell apart.", examples=[["payload_mismatch", "sensor_gain"]]
    )
    distance_sigma: float = Field(description="How far apart their predictions are, in multiples of the noise.", examples=[1.3])
    why: Message = Field(description="Why they look alike.")
    splits: Message = Field(description="What would tell them apart.")


class PatchPart(DiagnosisPart):
    """Channel x motion x band."""

    channel: str = Field(description="Channel of the wrench.", examples=["ty"])
    phase: str = Field(description="The motion.", examples=["rotate:x"])
    band_hz: tuple[float, float] = Field(description="Band of frequencies, Hz.", examples=[[0.5, 2.0]])
    times_noise: float = Field(description="Gap there, in multiples of the noise (rms).", examples=[4.2])
    share: float = Field(description="Share of the whole gap that lies there, 0 to 1.", examples=[0.31])


class JointGap(DiagnosisPart):
    """The joints' side: error of tracking while the joint moves, noise of one sample of it, and torque that arm and payload do not
    account for. None where it was not recorded, or the arm's masses are not known."""

    joint: str = Field(description="Name of the joint.", examples=["joint_4"])
    tracking_rms_rad: float | None = Field(
        description="Error of tracking while it moves, rms, rad; null where it was not recorded.", examples=[0.0006]
    )
    tracking_noise_rad: float | None = Field(description="Noise of one sample of it, rad.", examples=[0.0001])
    torque_rms_n_m: float | None = Field(
        description="Torque that arm and payload do not account for, rms, N m; null where it was not recorded or the masses are not known.",
        examples=[1.9],
    )


class ContactPart(DiagnosisPart):
    """A stretch in which something touched the payload."""

    begin_s: float = Field(description="When it began, s.", examples=[4.1])
    end_s: float = Field(description="When it ended, s.", examples=[5.4])
    most_n: float = Field(description="The largest force, N.", examples=[35.2])
    force_n: tuple[float, float, float] = Field(description="The mean force on the payload, N, base axes.", examples=[[0.0, 20.1, -3.0]])
    point_m: tuple[float, float, float] = Field(
        description="Where it acts, m, sensor axes, as well as its torque tells.", examples=[[0.0, 0.01, 0.09]]
    )


class Where(DiagnosisPart):
    """Where the gap lies; mean squares by direction and by pose (the sensor axis that points up or down) are against noise 1."""

    cells: list[PatchPart] = Field(description="The gap by channel, motion and band of frequencies.")
    channel: str = Field(description="The channel with most of it.", examples=["ty"])
    phase: str = Field(description="The motion with most of it.", examples=["rotate:x"])
    stage: str | None = Field(
        description="Where on the way from payload to reading it seems to arise; null where nothing explains it, or there is none.",
        examples=["sensor"],
    )
    by_time: list[float] = Field(description="Share of the excess in each tenth of the recording.", examples=[[0.1, 0.1, 0.8]])
    worst_s: tuple[float, float] | None = Field(
        default=None, description="Begin and end of the worst stretch, s; null in answers of earlier versions.", examples=[[31.0, 33.5]]
    )
    by_direction: dict[str, float] = Field(
        description="Mean squares by direction of motion, against noise 1.", examples=[{"forward": 3.9, "back": 4.1}]
    )
    by_pose: dict[str, float] = Field(
        default_factory=dict,
        description="Mean squares by the sensor axis that points up or down, against noise 1.",
        examples=[{"x+": 1.2, "x-": 1.1}],
    )
    joints: list[JointGap] = Field(default_factory=list, description="The same seen at the joints.")
    contacts: list[ContactPart] = Field(
        default_factory=list, description="When something touched the payload, where contacts in several stretches explain the gap."
    )
    message: Seen = Field(description="The same as a message.")


class Change(DiagnosisPart):
    """Before and after."""

    before: float = Field(description="Before, in multiples of the noise (rms).", examples=[4.2])
    after: float = Field(description="After, in multiples of the noise (rms).", examples=[1.1])


class GapPart(DiagnosisPart):
    """Root mean square of (measured - simulated) over its noise, on motions that the fit did not see."""

    before: float = Field(
        description="Measured minus simulated with the twin as it was, rms over its noise, on motions that the fit did not see.",
        examples=[4.2],
    )
    after: float = Field(description="The same with the explanation.", examples=[1.1])
    floor: float = Field(default=1.0, description="What noise alone makes of it.", examples=[1.0])
    unit: str = Field(default="noise sigma, rms", description="Unit of these numbers.", examples=["noise sigma, rms"])
    held_out: list[str] = Field(description="Motions that the fit did not see.", examples=[["rotate:z"]])
    by_channel: dict[str, Change] = Field(description="The same by channel of the wrench.")


class PhiPart(DiagnosisPart):
    """Phi in the paper's order, with standard uncertainties."""

    phi: list[float] = Field(
        description="Mass (kg), first moment (kg m), inertia about the sensor's origin (kg m2), in the paper's order.",
        examples=[[2.783, 0.0, -0.0468, 0.1015, 0.0069, 0.0, 0.0, 0.0066, 0.0017, 0.0033]],
    )
    std: list[float] = Field(
        description="Standard uncertainties of `phi`, in the same units.",
        examples=[[0.002, 0.0003, 0.0003, 0.0003, 0.0001, 0.0001, 0.0001, 0.0001, 0.0001, 0.0001]],
    )
    determined: list[bool] = Field(
        default_factory=lambda: [True] * 10,
        description="Which of them the recording determines; the others are assumed. All true in answers of earlier versions.",
        examples=[[True] * 10],
    )


class PayloadPart(DiagnosisPart):
    """The payload before and after the effect was added."""

    before: PhiPart = Field(description="The payload as it is identified without any effect.")
    after: PhiPart = Field(
        description="The payload as it is identified with it; where others may be the cause, averaged over all by their probability."
    )

    @computed_field(examples=[[0.4, -1.2, 0.1, 3.6, 0.0, 0.2, -0.1, 0.5, 0.0, 0.3]])  # type: ignore[prop-decorator]  # mypy knows no decorator above a property
    @property
    def change_over_interval(self) -> list[float | None]:
        """After less before, of each parameter, in half widths of the 95 % interval that both uncertainties together give: a difference
        inside either of the two intervals stays below 1. Null where no uncertainty is stated."""
        rows = zip(self.before.phi, self.after.phi, self.before.std, self.after.std, strict=True)
        halves = [(after - before, INTERVAL * math.hypot(one, other)) for before, after, one, other in rows]
        return [difference / half if half > 0 else None for difference, half in halves]


class Experiment(DiagnosisPart):
    """What to measure next, and what it is going to tell."""

    id: str = Field(description="What to do, in one word.", examples=["swings_about_horizontal_x"])
    motion: Message = Field(description="What to do.")
    stops: list[Stop] = Field(description="The same for planning; empty where it is no motion.")
    splits: list[tuple[str, str]] = Field(
        description="Pairs of explanations that it tells apart, the worst tie first.", examples=[[["payload_mismatch", "sensor_gain"]]]
    )
    sigma_before: float = Field(description="Distance of that tie now, in multiples of the noise.", examples=[1.3])
    sigma_after: float = Field(description="The same as predicted for both recordings together.", examples=[8.1])
    seconds: float = Field(description="Time of the robot, s: by kinematics alone, or as planned.", examples=[42.0])
    planned: bool = Field(default=False, description="Whether a cell was at hand and the motion is planned in it.")
    refused: MessageIfAny = Field(default=Message.of("gap-no-cell"), description="Why it is not planned; null where it is.")
    refused_kind: str | None = Field(
        default=None,
        description="Kind of the error that refused it, see `core.errors`; null where there was no cell, or where it is no motion.",
        examples=["no-path"],
    )


class Origin(DiagnosisPart):
    """What was diagnosed, as far as the twin is concerned that takes something from it."""

    recording: str = Field(description="Name of the recording's folder.", examples=["recording"])
    sha256: str = Field(
        description="SHA-256 of the recording's files, hexadecimal.",
        examples=["9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"],
    )
    cell: str | None = Field(description="Cell that the recording names.", examples=["lwr4_bench"])
    joints: int = Field(description="How many joints it has; 0 where it has poses only.", examples=[7])
    robot: Axes | None = Field(
        default=None,
        description="Direction and moment (m) of each joint's axis, base frame, joints at zero; null where the recording does not say, "
        "and in answers of earlier versions.",
        examples=[[[0.0, 0.0, 1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, -0.31, 0.0, 0.0]]],
    )
    begins_s: float = Field(default=0.0, description="Time of its first sample, s.", examples=[0.0])
    twin: dict[str, str] = Field(
        description="Effects that the diagnosis began with and their digests; also what could not be evaluated in this recording.",
        examples=[{"time_delay": "3f9c2ab17d"}],
    )


class Diagnosis(DiagnosisPart):
    """The whole answer; all of it but `also` is about the wrench that the twin predicts."""

    verdict: Verdict = Field(description="The answer in one word.")
    summary: Message = Field(description="The answer in a sentence.")
    effects: list[Explanation] = Field(description="Single effects that explain the gap, the most probable first.")
    none_probability: float = Field(description="Probability that there is no gap worth a name, 0 to 1.", examples=[0.01])
    unknown_probability: float = Field(description="Probability that it is something the library does not have, 0 to 1.", examples=[0.04])
    likely: list[str] = Field(
        default_factory=list,
        description="The smallest set of answers that holds the truth in nine of ten cases (split conformal), the most probable first: "
        "identifiers, several at once joined by plus signs, `none`, `unknown`. Empty in answers of earlier versions, and where nothing can "
        "be said.",
        examples=[["sensor_gain", "sensor_crosstalk"]],
    )
    pairs: list[Pair] = Field(description="Two effects at once, or three, the most probable first.")
    minor: list[Minor] = Field(description="Effects on the wrench that were detected, but are not material.")
    also: list[Also] = Field(default_factory=list, description="What is seen elsewhere than in the wrench.")
    indistinguishable: list[Tied] = Field(description="What this recording cannot tell apart.")
    where: Where | None = Field(description="Where the gap lies; null where there is too little to compare.")
    gap: GapPart | None = Field(description="How large it is; null where there is too little to compare.")
    payload: PayloadPart | None = Field(description="The payload before and after; null where it was not identified.")
    consequence: MessageIfAny = Field(description="What the gap means for the payload; null where it means nothing.")
    next_experiment: Experiment | None = Field(description="What to measure next; null where nothing would help.")
    limits: list[Message] = Field(description="What has to be known of the answer.")
    lacking: MessageIfAny = Field(default=None, description="Why nothing can be said, where the recording is not enough.")
    seconds: float = Field(description="Time of the diagnosis, s.", examples=[21.5])
    twin: list[str] = Field(
        default_factory=list, description="Effects of the cell's twin, which were on from the beginning.", examples=[["time_delay"]]
    )
    origin: Origin | None = Field(
        default=None, description="What was diagnosed; null in answers of earlier versions, and where the recording is in no folder."
    )

    @computed_field  # type: ignore[prop-decorator]  # mypy knows no decorator above a property
    @property
    def instruction(self) -> Instruction:
        """What the person at the robot has to do, in a sentence and a next step."""
        return instruct(self)
