"""The console says every message in the words that Python has for it: both read the same catalogue, each with a library of its own."""

from __future__ import annotations

import json
import math
import re
import subprocess
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from fluent.syntax import FluentParser
from fluent.syntax import ast as ftl
from fluent.syntax.visitor import Visitor

from core.words.catalogue import FOLDER, LANGUAGES, NUMBERS, PERSON, Language
from core.words.message import Message
from tests.server.real_service import ROOT

SIZES = (
    0, 1, 2, 5, 21, 1234567, -3, 0.0, 0.5, 2.5, 0.125, 1.0625, -0.0004, 0.00012345, 0.00001, 9.9995, 99.95, 1e-9, 12345.678, 12500.0,
    6.02e23, math.pi, -math.pi / 7, 1.005, math.inf, -math.inf, math.nan,
)  # fmt: skip
"""Among them halves, which go to the even neighbour, and what is too small or too large to be written out."""
COUNTS = (0, 1, 2, 5, 100, 12345)
WORDS: tuple[Any, ...] = ("table", "", "cell.toml: limits.clearance_m", "Größe_µ {x}", True, False, [], ["a", "b"], [1, 2, "c"])
PEOPLE = ("account:anna", "key:line-3", "nobody@127.0.0.1", "account:", "")
PLURALS = {"zero", "one", "two", "few", "many", "other"}
"""What a selector tells apart that is given a count."""
NOT_HERE = {"bag", "certificate", "cli", "import", "record", "report", "result", "sheet"}
"""Files of messages that stand only in a terminal, a report, a certificate or a score sheet."""
NESTED = Message.of("flaw", where="robot.urdf", found="nothing", expected=Message.of("text", text="a link"))


class Names(Visitor):
    """What a message names, itself or in the messages that it refers to, in which function, and what it tells apart.

    Args:
        messages: of the language, by code.
    """

    def __init__(self, messages: dict[str, ftl.Message]) -> None:
        self.messages = messages
        self.printed: set[str] = set()
        self.plain: set[str] = set()
        self.people: set[str] = set()
        self.choices: dict[str, set[str]] = {}

    def visit_FunctionReference(self, node: ftl.FunctionReference) -> None:  # noqa: N802 - the library's name
        named = {each.id.name for each in node.arguments.positional if isinstance(each, ftl.VariableReference)}
        if node.id.name == PERSON:
            self.people |= named
        else:
            self.printed |= named

    def visit_SelectExpression(self, node: ftl.SelectExpression) -> None:  # noqa: N802 - the library's name
        if isinstance(node.selector, ftl.VariableReference):
            keys = {each.key.name if isinstance(each.key, ftl.Identifier) else each.key.value for each in node.variants}
            self.choices.setdefault(node.selector.id.name, set()).update(keys)
        self.generic_visit(node)

    def visit_MessageReference(self, node: ftl.MessageReference) -> None:  # noqa: N802 - the library's name
        self.visit(self.messages[node.id.name])

    def visit_VariableReference(self, node: ftl.VariableReference) -> None:  # noqa: N802 - the library's name
        self.plain.add(node.id.name)


def values_of(names: Names, name: str) -> tuple[Any, ...]:
    """What a message may be given for one name: of a count no fractions, for which there is a function."""
    keys = names.choices.get(name, set())
    if name in names.printed:
        return (*SIZES, "inf", "")
    if name in names.people:
        return PEOPLE
    numeric = {key for key in keys if re.fullmatch(r"-?\d+(\.\d+)?", key)}
    if keys and keys <= numeric | PLURALS:
        return (*(float(key) if "." in key else int(key) for key in sorted(numeric)), *COUNTS)
    return (*sorted(keys), *COUNTS, *WORDS, NESTED)


def made_up(names: Names) -> Iterator[dict[str, Any]]:
    """Parameters in every way that a message can be given them, each name's values in turn."""
    values = {name: values_of(names, name) for name in sorted(names.plain | names.printed | names.people | {"where"})}
    for turn in range(max(map(len, values.values()))):
        yield {name: each[(turn + k) % len(each)] for k, (name, each) in enumerate(values.items())}


def cases(language: Language) -> Iterator[tuple[Message, str | None]]:
    files = [file for file in (FOLDER / language).glob("*.ftl") if file.stem not in NOT_HERE]
    read = (FluentParser(with_spans=False).parse(file.read_text(encoding="utf-8")) for file in files)
    messages = {item.id.name: item for resource in read for item in resource.body if isinstance(item, ftl.Message)}
    for code, item in sorted(messages.items()):
        names = Names(messages)
        names.visit(item)
        for parameters in made_up(names):
            message = Message(code=code, parameters=parameters)
            yield message, None
            yield from ((message, attribute.id.name) for attribute in item.attributes)


def asked(message: Message, part: str | None, language: Language) -> dict[str, Any]:
    """As the console gets it, with no words of Python's; JSON of JavaScript's has no infinity, so that travels as a text."""
    spoken = json.loads(message.model_dump_json(include={"code"})) | {"parameters": plain(message.parameters)}
    return {"language": language, "message": spoken, "part": part}


def plain(value: Any) -> Any:
    match value:
        case Message():
            return {"code": value.code, "parameters": plain(value.parameters)}
        case dict():
            return {name: plain(each) for name, each in value.items()}
        case float() if not math.isfinite(value):
            return str(value)
    return value


def said_by_console(questions: list[dict[str, Any]], more: str = "") -> list[str]:
    """What the console says, where its catalogue has these messages beside its own."""
    given = json.dumps({"questions": questions, "more": more})
    told = subprocess.run(
        ["node", "words.mjs", "say"], cwd=ROOT / "web", input=given, capture_output=True, text=True, check=True, timeout=120
    )
    return [str(each) for each in json.loads(told.stdout)]


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_console_says_every_message_in_the_words_of_python(language: Language) -> None:
    given = list(cases(language))
    by_console = said_by_console([asked(message, part, language) for message, part in given])
    by_python = [message.say(language) if part is None else message.say_part(part, language) for message, part in given]
    different = [
        (message.code, part, there, here)
        for (message, part), here, there in zip(given, by_python, by_console, strict=True)
        if here != there
    ]
    assert different == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_numbers_look_as_python_prints_them(language: Language) -> None:
    """Every function on every number, whether or not a message has use for it yet."""
    drawn = np.random.default_rng(7).normal(size=200) * 10.0 ** np.random.default_rng(8).integers(-9, 9, 200)
    printed = [(name, digits, float(value)) for name in NUMBERS for digits in range(1, 6) for value in (*SIZES, *drawn)]
    more = "\n".join(
        f"print-{name.lower()}-{digits} = {{ {name}($x, digits: {digits}) }}" for name, digits, _ in printed[:: len(SIZES) + 200]
    )
    questions = [
        asked(Message(code=f"print-{name.lower()}-{digits}", parameters={"x": value}), None, language) for name, digits, value in printed
    ]
    by_python = [NUMBERS[name](language, value, digits=digits) for name, digits, value in printed]
    by_console = said_by_console(questions, more)
    assert [each for each in zip(printed, by_python, by_console, strict=True) if each[1] != each[2]] == []
