"""The twin of a cell as it is answered: what has been added to its simulation."""

from __future__ import annotations

from datetime import datetime

from core.twin.twin import Twin
from server.http.schemas import Answer


class TwinParameter(Answer):
    """A parameter of an effect with its standard uncertainty, in `unit`."""

    value: float
    std: float
    unit: str


class TwinEffect(Answer):
    """An effect of a twin and where it comes from.

    Args:
        recording: name of the recording that it was fitted to; `sha256` of that recording's files.
        gap_before, gap_after: root mean square of measured minus simulated, in multiples of the noise, on motions that the fit did not see.
    """

    effect: str
    parameters: dict[str, TwinParameter]
    recording: str
    sha256: str
    added: datetime
    gap_before: float
    gap_after: float


class TwinAnswer(Answer):
    """What a cell's simulation has beyond the nominal one; nothing where `effects` is empty."""

    effects: tuple[TwinEffect, ...] = ()


def answer_twin(twin: Twin) -> TwinAnswer:
    """A twin as it is answered."""
    return TwinAnswer.model_validate(twin, from_attributes=True)
