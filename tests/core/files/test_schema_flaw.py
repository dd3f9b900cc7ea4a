"""Pydantic's errors as codes with parameters, and their words."""

from __future__ import annotations

import re
from typing import Literal, get_args

import pytest
from pydantic import BaseModel, ConfigDict, Field, ValidationError
from pydantic_core import _pydantic_core, core_schema

from core.errors import BadInput
from core.files.schema_flaw import OF_CALLS, SchemaFlaw, schema_flaw
from core.words.catalogue import FOLDER, LANGUAGES, Language

ERRORS = {error["type"]: error for error in _pydantic_core.list_all_errors()}


class Inner(BaseModel):
    size_m: float = Field(gt=0)


class Outer(BaseModel):
    model_config = ConfigDict(extra="forbid")

    inner: Inner
    pair: tuple[int, int]
    side: Literal["left", "right"] = "left"


def flaw_of(content: object) -> SchemaFlaw:
    with pytest.raises(ValidationError) as caught:
        Outer.model_validate(content)
    (error,) = caught.value.errors()
    return schema_flaw(error)


GOOD = {"inner": {"size_m": 1.0}, "pair": [1, 2]}


@pytest.mark.parametrize(
    ("content", "code", "english", "german"),
    [
        (GOOD | {"inner": {"size_m": -1}}, "schema-greater-than",
         "f: inner.size_m: found -1, expected greater than 0", "f: inner.size_m: gefunden: -1, erwartet: größer als 0"),
        (GOOD | {"inner": {}}, "schema-missing",
         "f: inner.size_m: found no such key, expected it",
         "f: inner.size_m: gefunden: kein solcher Schlüssel, erwartet: dass es ihn gibt"),
        (GOOD | {"inner": {"size_m": "x" * 500}}, "schema-float-parsing",
         'f: inner.size_m: found "' + "x" * 79 + ", expected a valid number",
         'f: inner.size_m: gefunden: "' + "x" * 79 + ", erwartet: eine Zahl"),
        (GOOD | {"side": None}, "schema-literal-error",
         "f: side: found null, expected one of left, right", "f: side: gefunden: null, erwartet: eines von left, right"),
        (GOOD | {"pair": [1, 2, 3]}, "schema-too-long",
         "f: pair: found [1, 2, 3], expected at most 2 items", "f: pair: gefunden: [1, 2, 3], erwartet: höchstens 2 Einträge"),
        (GOOD | {"secret": "abc"}, "schema-extra-forbidden",
         "f: secret: found an unknown key, expected a key of the format",
         "f: secret: gefunden: ein unbekannter Schlüssel, erwartet: ein Schlüssel des Formats"),
        ([], "schema-model-type", "f: found [], expected a table of keys and values",
         "f: gefunden: [], erwartet: eine Tabelle aus Schlüsseln und Werten"),
    ],
    ids=["wrong", "missing", "long", "choice", "too many", "unknown", "as a whole"],
)  # fmt: skip
def test_where_what_was_found_and_what_was_expected(content: object, code: str, english: str, german: str) -> None:
    flaw = flaw_of(content)
    error = flaw.refusal(BadInput, "f")
    assert (flaw.code, str(error), error.message.say("de")) == (code, english, german)


def test_the_error_has_the_kind_that_is_asked_for_and_its_parts() -> None:
    class Bad(BadInput):
        """Of a kind of its own."""

    error = flaw_of(GOOD | {"inner": {"size_m": -1}}).refusal(Bad, "f")
    assert isinstance(error, Bad)
    assert (error.where, error.found, error.expected) == ("f: inner.size_m", "-1", "greater than 0")
    assert error.message.parameters == {"where": "f: inner.size_m", "input": "-1", "gt": 0.0}


def test_a_value_that_is_hidden_stands_nowhere() -> None:
    flaw = flaw_of(GOOD | {"side": "abc"}).hide()
    error = flaw.refusal(BadInput, "f")
    assert "abc" not in error.message.model_dump_json()
    assert error.found == "a value that is not shown"


def test_what_is_missing_or_unknown_does_not_show_what_is_around_it() -> None:
    for content in ({"pair": (1, 2)}, GOOD | {"more": "hidden word"}):
        assert "input" not in flaw_of(content).parameters


@pytest.mark.parametrize("value", [float("nan"), {(1, 2): 3}, b"\xff", object()])
def test_what_json_does_not_have_is_shown_all_the_same(value: object) -> None:
    shown = schema_flaw({"loc": ("x",), "type": "float_type", "input": value}).parameters["input"]
    assert isinstance(shown, str)
    assert 0 < len(shown) <= 80


def test_every_type_that_pydantic_knows_is_of_calls_or_worded() -> None:
    assert set(get_args(core_schema.ErrorType)) == set(ERRORS)
    assert set(ERRORS) >= OF_CALLS


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("kind", sorted({*ERRORS, "made_by_a_validator"}))
def test_every_error_that_pydantic_can_make_is_worded(kind: str, language: Language) -> None:
    context = {name: value if value is not None else "5" for name, value in (ERRORS.get(kind, {}).get("example_context") or {}).items()}
    flaw = schema_flaw({"loc": ("here",), "type": kind, "input": 7, "ctx": context})
    error = flaw.refusal(BadInput, "file")
    found, expected = (error.message.say_part(part, language) for part in ("found", "expected"))
    said = error.message.say(language)
    assert said.startswith("file: here: ")
    assert flaw.code not in said
    assert "$" not in found + expected
    assert "{" not in found + expected


@pytest.mark.parametrize("kind", sorted(ERRORS))
def test_every_message_is_given_what_it_names(kind: str) -> None:
    context = ERRORS[kind]["example_context"] or {}
    flaw = schema_flaw({"loc": (), "type": kind, "input": 7, "ctx": context})
    words = re.search(rf"^{flaw.code} =\n((?: .*\n)+)", (FOLDER / "en" / "schema.ftl").read_text(encoding="utf-8"), re.MULTILINE)
    assert words is not None
    assert set(re.findall(r"\$(\w+)", words[1])) <= {*flaw.parameters, *context}
