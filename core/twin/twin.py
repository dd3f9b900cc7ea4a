"""A cell's twin: what has been added to its nominal simulation, each effect as it was fitted to a recording.

It is data alone, and quick to import: `core.twin.model` makes it act, `core.twin.file` keeps it beside the cell. The nominal twin has no
entries.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from hashlib import sha256
from typing import Annotated, Literal

import numpy as np
from pydantic import AwareDatetime, BaseModel, ConfigDict, Field

from core.cell.cell import TWIN_FILE
from core.errors import BadTwin

Number = Annotated[float, Field(strict=True)]
NotNegative = Annotated[float, Field(strict=True, ge=0)]


class TwinPart(BaseModel):
    """Frozen; unknown keys, NaN and infinity are refused."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


class Fitted(TwinPart):
    """A parameter's value with its standard uncertainty."""

    value: Number
    std: NotNegative
    unit: str


class Entry(TwinPart):
    """One effect and where it comes from.

    Args:
        effect: its identifier.
        parameters: by name, in the effect's order.
        covariance: of the parameters, in that order.
        recording: name of the recording that it was fitted to; `sha256`: of that recording's files.
        added: when.
        gap_before, gap_after: root mean square of (measured - simulated) over noise, on motions that the fit did not see.
    """

    effect: str
    parameters: dict[str, Fitted]
    covariance: tuple[tuple[Number, ...], ...]
    recording: str
    sha256: Annotated[str, Field(pattern="^[0-9a-f]{64}$")]
    added: AwareDatetime
    gap_before: NotNegative
    gap_after: NotNegative

    @property
    def hash(self) -> str:
        """SHA-256, hexadecimal, of what it is, wherever and whenever it was found."""
        return sha256(self.model_dump_json(include={"effect", "parameters"}).encode()).hexdigest()

    @property
    def directions(self) -> list[dict[str, float]]:
        """Independent departures of the parameters, one standard deviation each; `covariance` is the sum of their outer products."""
        size, axes = np.linalg.eigh(np.array(self.covariance))
        known = size > 1e-6 * max(float(size.max(initial=0.0)), math.ulp(0.0))
        return [dict(zip(self.parameters, np.sqrt(s) * axis, strict=True)) for s, axis in zip(size[known], axes.T[known], strict=True)]

    def move_parameters(self, by: dict[str, float]) -> Entry:
        """The same effect with other values."""
        values = {name: p.model_copy(update={"value": p.value + by.get(name, 0.0)}) for name, p in self.parameters.items()}
        return self.model_copy(update={"parameters": values})


class Twin(TwinPart):
    """What the cell's simulation has beyond the nominal one."""

    format: Literal["twin/1"] = "twin/1"
    effects: tuple[Entry, ...] = ()

    @property
    def ids(self) -> tuple[str, ...]:
        """Identifiers of the effects."""
        return tuple(entry.effect for entry in self.effects)

    @property
    def hashes(self) -> dict[str, str]:
        """What each effect is, by its identifier."""
        return {entry.effect: entry.hash for entry in self.effects}

    def without(self, *identifiers: str) -> Twin:
        """The twin without some effects."""
        return Twin(effects=tuple(entry for entry in self.effects if entry.effect not in identifiers))

    def with_entry(self, entry: Entry) -> Twin:
        """The twin with an effect, in the place of an older entry of the same identifier."""
        return Twin(effects=(*self.without(entry.effect).effects, entry))

    def with_found(self, entries: Sequence[Entry], made_with: Mapping[str, str]) -> Twin:
        """The twin with what one diagnosis found; it counted with the other effects as they were then.

        Args:
            entries: each in the place of an older entry of the same identifier.
            made_with: `hashes` of the twin that the diagnosis began with.

        Raises:
            BadTwin: the twin has changed since, beyond what is replaced.
        """
        ids = [entry.effect for entry in entries]
        left = self.without(*ids)
        if changed := {name for name, _ in left.hashes.items() ^ made_with.items()} - set(ids):
            raise BadTwin(TWIN_FILE, "twin-changed", effects=sorted(changed))
        return Twin(effects=(*left.effects, *entries))


NOMINAL = Twin()
