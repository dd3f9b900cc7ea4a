"""What leaves the engine: messages with codes and parameters, also where an earlier version wrote sentences."""

from __future__ import annotations

import json
from typing import Any

from core.estimation.result import Result
from core.words.message import Message

SHORT = {"code": "estimation-too-short", "parameters": {"lasts_s": 0.5}, "text": "0.50 s are too short to say anything"}
NOTHING = {
    "code": "estimation-nothing-determined",
    "parameters": {"reason": {"code": SHORT["code"], "parameters": SHORT["parameters"]}},
    "text": "The payload is not determined: 0.50 s are too short to say anything.",
}


def result(**changed: Any) -> Result:
    keys = ("cell", "payload", "reference", "estimate", "residual", "safety", "recording")
    content = dict.fromkeys(keys) | {"verdict": NOTHING, "warnings": [SHORT], "paper": {"phi": [], "std": []}, "seconds": {"estimate": 1.0}}
    return Result.model_validate(content | changed)


def test_messages_leave_with_code_parameters_and_english_words_and_come_back_the_same() -> None:
    found = result()
    written = json.loads(found.model_dump_json())
    assert (written["verdict"], written["warnings"]) == (NOTHING, [SHORT])
    assert Result.model_validate(written) == found


def test_sentences_of_an_earlier_version_are_read_as_they_are() -> None:
    old = {"id": "drift", "sentence": "the sensor's offset drifted", "values": {}}
    found = result(verdict="The payload has 2 kg.", warnings=[old])
    assert found.verdict == Message.of("text", text="The payload has 2 kg.")
    assert [each.text for each in found.warnings] == ["the sensor's offset drifted"]


def test_a_result_of_an_earlier_version_knows_no_requirement() -> None:
    written = json.loads(result().model_dump_json())
    del written["requirement"]
    assert Result.model_validate(written).requirement is None
