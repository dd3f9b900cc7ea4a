"""The twin of a cell as it is answered: what has been added to its simulation."""

from __future__ import annotations

from datetime import datetime

from pydantic import ValidationError

from core.cell.cell import TWIN_FILE, Cell
from core.errors import BadTwin
from core.files.jail import read_inside
from core.files.schema_flaw import schema_flaw
from server.http.schemas import Answer

MAX_BYTES = 1_000_000


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


def twin_of(cell: Cell) -> TwinAnswer:
    """What stands in the cell's `twin.json`.

    Raises:
        BadTwin: it is not one that an addition has written.
    """
    if not (cell.folder / TWIN_FILE).exists():
        return TwinAnswer()
    try:
        return TwinAnswer.model_validate_json(read_inside(cell.folder, TWIN_FILE, BadTwin, max_bytes=MAX_BYTES))
    except ValidationError as error:
        raise schema_flaw(error.errors()[0]).refusal(BadTwin, f"{cell.name}/{TWIN_FILE}") from error
