"""Blind trials as they leave the service: the seals at once, the answers when all are there."""

from __future__ import annotations

from pydantic import Field, TypeAdapter

from core.words.catalogue import Language
from core.words.message import Message
from server.http.schemas import Answer


class Seal(Answer):
    """What was planted in a trial, as a hash that was published before the trial began."""

    seed: int
    sha256: str


class NamedEffect(Answer):
    """An effect that the diagnosis named; `closure` is the share of the gap that goes away with it."""

    id: str
    probability: float
    closure: float


class OpenedTrial(Answer):
    """A finished trial.

    Args:
        sealed: the text whose SHA-256 is the seal: cell, payload, faults and their parameters.
        planted: the faults in words, `size` in plausible sizes of them.
        verdict, named: what the diagnosis said; `named` is its first effect, `effects` are all of them, the most probable first.
        also: what it saw beside the verdict, elsewhere than in the wrench, and called material.
        gap_before, gap_after: root mean square of measured minus simulated, in multiples of the noise, on motions that no fit saw.
        mark: whether that was right, in words.
    """

    seed: int
    sealed: str
    planted: Message
    size: float
    verdict: str
    named: str | None
    effects: list[NamedEffect]
    also: tuple[str, ...] = ()
    none_probability: float
    unknown_probability: float
    gap_before: float | None
    gap_after: float | None
    mark: Message


class TrialsResult(Answer):
    """All trials of a job with their score sheet (Markdown), in English and in each language.

    Trials of an earlier version have no `sheets`.
    """

    opened: list[OpenedTrial]
    sheet: str
    sheets: dict[Language, str] = Field(default_factory=dict)


SEALS = TypeAdapter(list[Seal])
