"""What a page may want to see in a way of its own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from core.payload.shapes import Box, Shape

Look = Literal["front", "top", "operator", "fit", "reset"]
"""From where: `operator` from the first protected zone, where people are; `fit` from where the camera is; `reset` as at first."""


@dataclass(frozen=True)
class Wish:
    """What a page wants to see besides the cell as it is; what is None is not drawn.

    Args:
        payload_box: in the place of the run's, sensor frame.
        q_rad: where the planned robot is drawn.
        zone: a protected zone as it would be, world frame.
    """

    payload_box: Box | None = None
    q_rad: tuple[float, ...] | None = None
    zone: Shape | None = None
