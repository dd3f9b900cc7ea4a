"""Blind trials as they leave the service: the seals at once, the answers when all are there."""

from __future__ import annotations

from pydantic import Field, TypeAdapter

from core.words.message import Message
from server.http.schemas import Answer


class Seal(Answer):
    """What was planted in a trial, as a hash that was published before the trial began."""

    seed: int = Field(description="Seed of the trial.", examples=[0])
    sha256: str = Field(
        description="SHA-256 of what was planted, hexadecimal, published before the trial began.",
        examples=["9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"],
    )


class NamedEffect(Answer):
    """An effect that the diagnosis named; `closure` is the share of the gap that goes away with it."""

    id: str = Field(description="Name of the effect.", examples=["time_delay"])
    probability: float = Field(description="Its probability, 0 to 1.", examples=[0.93])
    closure: float = Field(description="Share of the gap that goes away with it, 0 to 1.", examples=[0.97])


class OpenedTrial(Answer):
    """A finished trial."""

    seed: int = Field(description="Seed of the trial.", examples=[0])
    sealed: str = Field(
        description="The text whose SHA-256 is the seal: cell, payload, faults and their parameters.", examples=['{"cell": "lwr4_bench"}']
    )
    planted: Message = Field(description="The faults in words.")
    size: float = Field(description="Their size, in plausible sizes of them.", examples=[1.4])
    verdict: str = Field(description="What the diagnosis said, in one word.", examples=["explained"])
    named: str | None = Field(description="The first effect that it named; null where it named none.", examples=["time_delay"])
    effects: list[NamedEffect] = Field(description="All that it named, the most probable first.")
    also: tuple[str, ...] = Field(
        default=(),
        description="What it saw beside the verdict, elsewhere than in the wrench, and called material.",
        examples=[["joint_backlash"]],
    )
    none_probability: float = Field(description="Probability that there is no gap worth a name, 0 to 1.", examples=[0.01])
    unknown_probability: float = Field(description="Probability that it is something the library does not have, 0 to 1.", examples=[0.04])
    gap_before: float | None = Field(
        description="Measured minus simulated, rms in multiples of the noise, on motions that no fit saw; null where there was too little.",
        examples=[4.2],
    )
    gap_after: float | None = Field(description="The same with what it named.", examples=[1.1])
    mark: Message = Field(description="Whether that was right, in words.")


class TrialsResult(Answer):
    """All trials of a job with their score sheet (Markdown), in English and in each language.

    Trials of an earlier version have no `sheets`.
    """

    opened: list[OpenedTrial]
    sheet: str
    sheets: dict[str, str] = Field(default_factory=dict)


SEALS = TypeAdapter(list[Seal])
