"""A diagnosis as it leaves the engine: JSON, SI units; what is not known is null."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict

Verdict = Literal["no_gap", "explained", "ambiguous", "unknown", "not_enough"]


class Part(BaseModel):
    """Frozen, without NaN."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False)


class Value(Part):
    """A fitted parameter."""

    value: float
    std: float | None
    unit: str
    at_bound: bool = False


class Explanation(Part):
    """One effect, or two at once, with what it would do to the gap."""

    id: str
    title: str
    stage: str
    probability: float
    parameters: dict[str, Value]
    gap_after: float
    closure: float
    closure_interval: tuple[float, float]
    advice: str


class Pair(Part):
    """Two effects at once."""

    ids: tuple[str, str]
    probability: float
    gap_after: float
    closure: float


class Minor(Part):
    """Detected, but not material."""

    id: str
    parameters: dict[str, Value]
    sentence: str


class Tied(Part):
    """What this recording cannot tell apart."""

    ids: tuple[str, ...]
    distance_sigma: float
    why: str
    splits: str


class Cell(Part):
    """Channel x motion x band."""

    channel: str
    phase: str
    band_hz: tuple[float, float]
    times_noise: float
    share: float


class Where(Part):
    """Where the gap lies."""

    cells: list[Cell]
    channel: str
    phase: str
    stage: str
    by_time: list[float]
    by_direction: dict[str, float]
    sentence: str


class Change(Part):
    """Before and after."""

    before: float
    after: float


class GapPart(Part):
    """Root mean square of (measured - simulated) over its noise, on motions that the fit did not see."""

    before: float
    after: float
    floor: float = 1.0
    unit: str = "noise sigma, rms"
    held_out: list[str]
    by_channel: dict[str, Change]


class Payload(Part):
    """Phi in the paper's order, with standard uncertainties."""

    phi: list[float]
    std: list[float]


class PayloadPart(Part):
    """The payload before and after the effect was added."""

    before: Payload
    after: Payload


class Experiment(Part):
    """What to measure next."""

    motion: str
    splits: list[tuple[str, str]]
    seconds: float


class Diagnosis(Part):
    """The whole answer."""

    verdict: Verdict
    summary: str
    effects: list[Explanation]
    none_probability: float
    unknown_probability: float
    pairs: list[Pair]
    minor: list[Minor]
    indistinguishable: list[Tied]
    where: Where | None
    gap: GapPart | None
    payload: PayloadPart | None
    consequence: str
    next_experiment: Experiment | None
    limits: list[str]
    seconds: float
