"""What every body of the API has in common; each route keeps its own models beside it."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, SecretStr, StringConstraints

from core.payload.shapes import Shape

Name = Annotated[str, StringConstraints(pattern=r"^[A-Za-z0-9_-]{1,64}$")]
"""Of a cell, a zone, an account: safe in a path, a URL and a log line."""


Password = Annotated[SecretStr, Field(max_length=200)]
"""As it is typed in."""
NewPassword = Annotated[SecretStr, Field(min_length=12, max_length=200)]
"""One from now on: long enough not to be guessed."""


class RequestBody(BaseModel):
    """Frozen; unknown keys, NaN and infinity are refused."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


class Answer(BaseModel):
    """What goes out: no NaN, no infinity."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False, from_attributes=True)


def _check_aware(moment: datetime) -> datetime:
    if moment.tzinfo is None:
        raise ValueError("a time without its offset from UTC; write 2026-01-31T12:00:00Z")
    return moment


Moment = Annotated[datetime, AfterValidator(_check_aware)]
"""A time with its offset from UTC, ISO 8601."""


def _assume_box(shape: Any) -> Any:
    return {"kind": "box", **shape} if isinstance(shape, dict) and "kind" not in shape else shape


AnyShape = Annotated[Shape, BeforeValidator(_assume_box)]
"""Of a request; a shape that says not which it is is a box, as the schema has it."""
