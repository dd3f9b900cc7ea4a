"""What every part of an answer in JSON is made of: frozen, without infinities; what is not known is null."""

from __future__ import annotations

import numpy as np
from pydantic import BaseModel, ConfigDict

from core.array import Array

Numbers = list[float | None]


class ResultPart(BaseModel):
    """Frozen; infinities and NaN never leave: what is not known is null."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False)


def to_json_numbers(values: Array | None) -> Numbers:
    """A list with null for NaN."""
    return [] if values is None else [float(v) if np.isfinite(v) else None for v in values]
