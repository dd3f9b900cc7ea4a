"""What a schema finds wrong: pydantic's errors in the words that `BadInput` is made of."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

MOST_LETTERS = 80


class SchemaFlaw(NamedTuple):
    """One value that does not fit.

    Args:
        key: with those that lead to it, dots between them; empty where it is the whole.
    """

    key: str
    found: str
    expected: str

    def at(self, where: str) -> tuple[str, str, str]:
        """Where it is, what was found, what was expected: of a file or a part of one."""
        return f"{where}: {self.key}" if self.key else where, self.found, self.expected


def schema_flaw(error: Mapping[str, Any]) -> SchemaFlaw:
    """One of `ValidationError.errors()`."""
    key = ".".join(str(part) for part in error["loc"])
    if error["type"] == "json_invalid":
        return SchemaFlaw(key, f"JSON that does not parse ({error['ctx']['error']})", "JSON")
    if error["type"] == "missing":
        return SchemaFlaw(key, "no such key", "it")
    if error["type"] == "extra_forbidden":
        return SchemaFlaw(key, "an unknown key", "a key of the format")
    expected = error["msg"].removeprefix("Input should be ").removeprefix("Tuple should have ")
    return SchemaFlaw(key, repr(error.get("input"))[:MOST_LETTERS], expected)
