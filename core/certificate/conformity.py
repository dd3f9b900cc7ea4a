"""The statement of conformity: whether the values are good enough for the cell's controller, by which rule."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from core.estimation.result_part import ResultPart
from core.words.message import Message


class Conformity(ResultPart):
    """The statement, or why there is none."""

    conforms: bool | None = Field(
        description="Whether the error of the values stays below every threshold with a probability of at least 95 %; false where that "
        "cannot be said, null where it is not judged.",
        examples=[True],
    )
    statement: Message = Field(description="The same in words; where it is not judged, why.")
    rule: Message | None = Field(default=None, description="The decision rule; null where it is not judged.")
    used: float | None = Field(
        default=None, description="Share of the deciding threshold that the error stays below with 95 % probability.", examples=[0.12]
    )
    margin: float | None = Field(default=None, description="By how much every standard uncertainty might grow.", examples=[8.3])
    criterion: Message | None = Field(default=None, description="What decides, with its threshold.")
    decides: Literal["mass", "centre_of_mass", "inertia"] | None = Field(
        default=None, description="Whose uncertainty uses most of it.", examples=["inertia"]
    )
    assumed: bool = Field(default=False, description="Whether the cell states no threshold, and a usual one is taken.", examples=[False])
    motion_s: float | None = Field(default=None, description="How long the motion is that it holds for, s.", examples=[94.0])
