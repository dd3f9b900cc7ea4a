"""What a schema finds wrong: pydantic's errors as codes with parameters. Their words stand in `schema.ftl`."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any, NamedTuple, TypeVar, get_args

from pydantic_core import core_schema

from core.errors import BadInput
from core.words.message import Message, Parameter

MOST_LETTERS = 80
"""Of a value, and of a parser's own words."""

OF_CALLS = frozenset(
    {
        "arguments_type",
        "callable_type",
        "complex_str_parsing",
        "complex_type",
        "counter_type",
        "dataclass_exact_type",
        "default_factory_not_called",
        "ellipsis_error",
        "fraction_parsing",
        "fraction_type",
        "frozen_dict_type",
        "frozen_field",
        "frozen_instance",
        "get_attribute_error",
        "is_instance_of",
        "is_subclass_of",
        "missing_argument",
        "missing_keyword_only_argument",
        "missing_positional_only_argument",
        "missing_sentinel_error",
        "multiple_argument_values",
        "needs_python_object",
        "no_such_attribute",
        "ordered_dict_type",
        "unexpected_keyword_argument",
        "unexpected_positional_argument",
    }
)
"""Of Python's own objects and calls: no file and no request meets them."""
WORDED = frozenset(get_args(core_schema.ErrorType)) - OF_CALLS
OTHER = "schema-other"
WITHOUT_VALUE = frozenset({"missing", "extra_forbidden", "json_invalid", "recursion_loop", "recursion_depth_exceeded"})
"""What was found there is the whole around it, or nothing that the schema knows: it may be secret."""
CHOICES = frozenset({"expected", "expected_tags", "expected_schemes"})

Refusal = TypeVar("Refusal", bound=BadInput)


class SchemaFlaw(NamedTuple):
    """One value that does not fit.

    Args:
        key: with those that lead to it, dots between them; empty where it is the whole.
        code: the message of the catalogue whose `found` and `expected` it says.
        parameters: what they name.
    """

    key: str
    code: str
    parameters: dict[str, Parameter]

    def at(self, where: str) -> str:
        """Where it is, of a file or a part of one."""
        return f"{where}: {self.key}" if self.key else where

    def refusal(self, kind: type[Refusal], where: str) -> Refusal:
        """The error of a file or a part of one that has it."""
        return kind(self.at(where), self.code, **self.parameters)

    def hide(self) -> SchemaFlaw:
        """The same without the value that was found."""
        return self._replace(parameters=self.parameters | {"input": Message.of("schema-hidden")})


def schema_flaw(error: Mapping[str, Any]) -> SchemaFlaw:
    """One of `ValidationError.errors()`."""
    key, kind = ".".join(str(part) for part in error["loc"]), str(error["type"])
    parameters = {name: _parameter(name, value) for name, value in error.get("ctx", {}).items() if value is not None}
    if kind not in WITHOUT_VALUE:
        parameters["input"] = _show(error.get("input"))
    if kind in WORDED:
        return SchemaFlaw(key, "-".join(("schema", *kind.split("_"))), parameters)
    return SchemaFlaw(key, OTHER, parameters | {"type": kind})


def _parameter(name: str, value: object) -> Parameter:
    """What a message can name: numbers and texts as they are, choices as a list."""
    if isinstance(value, bool | int | float):
        return value
    if name in CHOICES:
        return [each.strip("'") for each in re.findall(r"'[^']*'|[^\s,]+", str(value)) if each != "or"]
    return str(value)[:MOST_LETTERS]


def _show(value: object) -> str:
    """A value as JSON has it, shortened; a number that is none as TOML has it."""
    if isinstance(value, float):
        return str(value)
    try:
        return json.dumps(value, ensure_ascii=False, default=str)[:MOST_LETTERS]
    except (TypeError, ValueError, RecursionError):
        return str(type(value).__name__)
