"""The twin of a cell as it is answered: what has been added to its simulation."""

from __future__ import annotations

from datetime import datetime

from pydantic import Field

from core.twin.twin import Twin
from server.http.schemas import Answer


class TwinParameter(Answer):
    """A parameter of an effect with its standard uncertainty, in `unit`."""

    value: float = Field(description="The value, in `unit`.", examples=[0.0042])
    std: float = Field(description="Its standard uncertainty, in `unit`.", examples=[0.0002])
    unit: str = Field(description="Unit of both.", examples=["s"])


class TwinEffect(Answer):
    """An effect of a twin and where it comes from."""

    effect: str = Field(description="Name of the effect.", examples=["time_delay"])
    parameters: dict[str, TwinParameter] = Field(description="Its parameters by name.")
    recording: str = Field(description="Name of the recording that it was fitted to.", examples=["recording"])
    sha256: str = Field(
        description="SHA-256 of that recording's files, hexadecimal.",
        examples=["9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"],
    )
    added: datetime = Field(description="When it was added.", examples=["2026-03-01T09:30:00Z"])
    gap_before: float = Field(
        description="Measured minus simulated without it, rms in multiples of the noise, on motions that the fit did not see.",
        examples=[4.2],
    )
    gap_after: float = Field(description="The same with it.", examples=[1.1])


class TwinPublic(Answer):
    """What a cell's simulation has beyond the nominal one; nothing where `effects` is empty."""

    effects: tuple[TwinEffect, ...] = Field(default=(), description="What the cell's simulation has beyond the nominal one.")


def answer_twin(twin: Twin) -> TwinPublic:
    """A twin as it is answered."""
    return TwinPublic.model_validate(twin, from_attributes=True)
