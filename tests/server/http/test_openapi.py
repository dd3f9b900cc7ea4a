"""The description of the API leaves nothing to be guessed: every field and parameter has its meaning, its unit and an example."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import jsonschema_rs
import pytest
from fastapi import FastAPI

from server.http.openapi import operations
from server.http.operation_problems import ENGINE_REFUSALS, REFUSALS
from server.http.problem_parameters import PARAMETERS
from server.http.problems import kinds_by_name
from server.http.situations import SITUATIONS
from server.people.authority import AUTHORITY

Json = dict[str, Any]

SAID = {
    "_s": "s", "_m": "m", "_kg": "kg", "_rad": "rad", "_hz": "Hz", "_m_s": "m/s", "_m_s2": "m/s2", "_rad_s": "rad/s",
    "_rad_s2": "rad/s2", "_n_m": "N m", "_kg_m": "kg m", "_kg_m2": "kg m2", "_n_m_s": "N m per rad/s", "_mb": "MB", "_bytes": "bytes",
    "_days": "Days",
}  # fmt: skip
"""The unit as descriptions write it, by the end of a name; the longest that fits counts."""
SELF_EXPLAINING = ("$ref", "enum", "const", "oneOf", "discriminator")
BY_NO_OPERATION = {
    "people-endpoint-closed", "people-origin-missing", "request-console-file-unknown",
    "request-method-not-allowed", "request-refused", "request-unforeseen",
}  # fmt: skip
"""What answers where there is no operation, a websocket, or what nobody foresaw."""


@pytest.fixture(scope="module")
def description(described_app: FastAPI) -> Json:
    found: Json = described_app.openapi()
    return found


def properties(schema: Json, where: str) -> Iterator[tuple[str, str, Json]]:
    """Each property of a schema and of the objects in it: where, its name, its schema."""
    for name, each in schema.get("properties", {}).items():
        yield where, name, each
        yield from properties(each, f"{where}.{name}")


def fields(description: Json) -> list[tuple[str, str, Json]]:
    return [each for name, schema in description["components"]["schemas"].items() for each in properties(schema, name)]


def parameters(description: Json) -> list[tuple[str, str, Json]]:
    return [(where, each["name"], each) for where, operation in operations(description) for each in operation.get("parameters", [])]


def explains_itself(schema: Json) -> bool:
    """It leads to another schema, or says what it may be."""
    if schema.get("type") in ("boolean", "null") or any(key in schema for key in SELF_EXPLAINING):
        return True
    if "anyOf" in schema:
        return all(explains_itself(each) for each in schema["anyOf"])
    inner = schema.get("items", schema.get("additionalProperties", next(iter(schema.get("patternProperties", {}).values()), None)))
    return "properties" in schema or (isinstance(inner, dict) and inner != {} and explains_itself(inner))


def test_every_field_and_every_parameter_is_described(description: Json) -> None:
    lacking = [f"{where}.{name}" for where, name, each in fields(description) + parameters(description) if not each.get("description")]
    assert lacking == []
    assert len(fields(description)) > 900
    assert len(parameters(description)) > 50


def test_every_field_and_every_parameter_has_an_example_unless_it_says_what_it_may_be(description: Json) -> None:
    told = [(f"{where}.{name}", each, each) for where, name, each in fields(description) if where.partition(".")[2] != "parameters"]
    told += [(f"{where} {name}", each, each["schema"]) for where, name, each in parameters(description)]
    assert [where for where, each, schema in told if not (each.get("examples") or schema.get("examples") or explains_itself(schema))] == []


def test_every_example_fits_its_schema(description: Json) -> None:
    examples = [(f"{where}.{name}", each, example) for where, name, each in fields(description) for example in each.get("examples", [])]
    examples += [
        (f"{where} {name}", each["schema"], example)
        for where, name, each in parameters(description)
        for example in each["schema"].get("examples", [])
    ]
    schemas = {str(k): schema for k, (_, schema, _) in enumerate(examples)}
    every = jsonschema_rs.Draft202012Validator({"properties": schemas, "components": description["components"]})
    told = {str(k): example for k, (*_, example) in enumerate(examples)}
    assert {examples[int(error.instance_path[0])][0]: error.message for error in every.iter_errors(told)} == {}
    assert len(examples) > 400


def test_descriptions_say_the_unit_that_the_name_has(description: Json) -> None:
    wrong = []
    for where, name, each in fields(description) + parameters(description):
        ends = [end for end in SAID if name.endswith(end)]
        numeric = re.search(r'"(number|integer)"', str(each).replace("'", '"'))
        if ends and numeric:
            unit = SAID[max(ends, key=len)]
            if not re.search(rf"(?<!\w){re.escape(unit)}(?!\w)", each["description"]):
                wrong.append(f"{where}.{name}: {unit}")
    assert wrong == []


def test_names_of_schemas_are_plain_words(description: Json) -> None:
    names = set(description["components"]["schemas"])
    assert [name for name in names if not re.fullmatch(r"([A-Z][a-z0-9]*)+", name)] == []
    assert [name for name in names if name.endswith(("Answer", "Body"))] == []
    assert {"RunCreate", "RunPublic", "ResultPublic", "WebhookCreate"} <= names


def test_every_operation_says_which_problems_it_may_answer_with(description: Json) -> None:
    schemas = description["components"]["schemas"]
    for endpoint, operation in operations(description):
        declared = {
            ref
            for status, answer in operation["responses"].items()
            if status[0] in "45"
            for ref in re.findall(r"schemas/(\w+)", str(answer))
        }
        assert declared <= set(schemas), endpoint
        if AUTHORITY[endpoint] is not None:
            assert {"PeopleNotSignedInProblem", "PeopleRoleLackingProblem", "StoreUnavailableProblem"} <= declared, endpoint
        assert ("RequestUnfitProblem" in declared) == bool(
            operation.get("parameters") or "application/json" in operation.get("requestBody", {}).get("content", {})
        ), endpoint
        assert "default" in operation["responses"], endpoint


def test_problems_stand_under_the_status_that_they_are_answered_with(description: Json) -> None:
    statuses = {
        "".join(word.title() for word in f"{code}-problem".split("-")): kinds_by_name()[kind].status
        for kind, codes in SITUATIONS.items()
        for code in codes
    }
    for endpoint, operation in operations(description):
        for status, answer in operation["responses"].items():
            for name in re.findall(r"schemas/(\w+Problem)", str(answer)) if status.isdigit() else []:
                assert name == "EngineProblem" or int(status) == statuses[name] or (status, name) == ("400", "RequestNoJsonProblem"), (
                    endpoint
                )


def test_every_situation_is_one_of_an_operation(description: Json) -> None:
    declared = set(re.findall(r"schemas/(\w+)Problem", str(description["paths"])))
    own = {code: "".join(word.title() for word in code.split("-")) for codes in SITUATIONS.values() for code in codes}
    assert {code for code, name in own.items() if name not in declared} == BY_NO_OPERATION


def test_the_tables_name_operations_that_there_are(description: Json) -> None:
    known = {endpoint for endpoint, _ in operations(description)}
    assert set(REFUSALS) | set(ENGINE_REFUSALS) <= known
    assert {kind for kinds in ENGINE_REFUSALS.values() for kind in kinds} <= set(kinds_by_name())


def test_every_name_in_the_table_of_parameters_is_one_that_words_name(description: Json) -> None:
    named = {
        name
        for schema in description["components"]["schemas"].values()
        for name in schema.get("properties", {}).get("parameters", {}).get("properties", {})
    }
    assert named == set(PARAMETERS)
