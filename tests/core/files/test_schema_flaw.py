"""Pydantic's errors in our words."""

from __future__ import annotations

import pytest
from pydantic import BaseModel, Field, ValidationError

from core.files.schema_flaw import schema_flaw


class Inner(BaseModel):
    size_m: float = Field(gt=0)


class Outer(BaseModel):
    inner: Inner
    pair: tuple[int, int]


@pytest.mark.parametrize(
    ("content", "told"),
    [
        ({"inner": {"size_m": -1}, "pair": [1, 2]}, ("f: inner.size_m", "-1", "greater than 0")),
        ({"inner": {}, "pair": [1, 2]}, ("f: inner.size_m", "no such key", "it")),
        ({"inner": {"size_m": "x" * 500}, "pair": [1, 2]},
         ("f: inner.size_m", "'" + "x" * 79, "a valid number, unable to parse string as a number")),
        ([], ("f", "[]", "a valid dictionary or instance of Outer")),
    ],
    ids=["wrong", "missing", "long", "as a whole"],
)  # fmt: skip
def test_where_what_was_found_and_what_was_expected(content: object, told: tuple[str, str, str]) -> None:
    with pytest.raises(ValidationError) as caught:
        Outer.model_validate(content)
    (error,) = caught.value.errors()
    assert schema_flaw(error).at("f") == told
