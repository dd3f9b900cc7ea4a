"""Every message that the source speaks of has words in every language, and is given all that they name."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import jinja2
import pytest
from fluent.syntax import FluentParser
from fluent.syntax import ast as ftl
from jinja2 import nodes

from core.cli.commands import COMMANDS
from core.errors import BadCell, NoPath
from core.words.catalogue import FOLDER, LANGUAGES, NUMBERS, PERSON
from core.words.message import Message

ROOT = Path(__file__).parents[3]
FILES = sorted(path.stem for path in (FOLDER / "en").glob("*.ftl"))
PREFIXES = tuple(f"{name}-" for name in FILES)
BUILT_IN = {"value", "limit", "where", "in_the_way", "samples", "allowed", "retry_after_s", "lateness"}
"""Given by errors themselves, or kept by them beside the message."""


@dataclass
class Entry:
    """A message as a catalogue has it: its parts, what they name, and what functions they use."""

    file: str
    parts: set[str] = field(default_factory=set)
    names: set[str] = field(default_factory=set)
    functions: set[str] = field(default_factory=set)
    terms: set[str] = field(default_factory=set)


@cache
def read(language: str) -> dict[str, Entry]:
    entries: dict[str, Entry] = {}
    for file in sorted((FOLDER / language).glob("*.ftl")):
        resource = FluentParser(with_spans=False).parse(file.read_text(encoding="utf-8"))
        for item in resource.body:
            assert not isinstance(item, ftl.Junk), f"{file}: {item.content}"
            if isinstance(item, ftl.Message):
                assert item.id.name not in entries, f"{item.id.name} stands twice in {language}"
                entries[item.id.name] = read_entry(file.stem, item)
    for entry in entries.values():
        for term in closure(entries, entry.terms):
            entry.names |= entries[term].names
    return entries


def closure(entries: dict[str, Entry], terms: set[str]) -> set[str]:
    """Messages that these are made of, and those that they are made of."""
    found, unseen = set(terms), set(terms)
    while unseen:
        unseen = {inner for term in unseen for inner in entries[term].terms} - found
        found |= unseen
    return found


def read_entry(file: str, message: ftl.Message) -> Entry:
    entry = Entry(file, {"" if message.value is not None else "flaw"} | {each.id.name for each in message.attributes})
    for node in walk(message):
        if isinstance(node, ftl.VariableReference):
            entry.names.add(node.id.name)
        elif isinstance(node, ftl.FunctionReference):
            entry.functions.add(node.id.name)
        elif isinstance(node, ftl.MessageReference):
            entry.terms.add(node.id.name)
    return entry


def walk(node: object) -> Iterator[object]:
    yield node
    if isinstance(node, ftl.BaseNode):
        for value in vars(node).values():
            for child in value if isinstance(value, list) else [value]:
                if isinstance(child, ftl.BaseNode):
                    yield from walk(child)


@dataclass
class Use:
    """A code where the source names it, with the keywords of the call that it is an argument of; None where there is no such call."""

    place: str
    code: str
    given: set[str] | None


@cache
def uses() -> list[Use]:
    found: list[Use] = []
    for file in sorted([*(ROOT / "core").rglob("*.py"), *(ROOT / "server").rglob("*.py")]):
        tree = ast.parse(file.read_text())
        calls = {id(arg): call for call in ast.walk(tree) if isinstance(call, ast.Call) for arg in call.args}
        for node in ast.walk(tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and is_code(node.value):
                call = calls.get(id(node))
                open_ended = call is None or any(keyword.arg is None for keyword in call.keywords)
                given = None if open_ended or call is None else {keyword.arg for keyword in call.keywords if keyword.arg}
                found.append(Use(f"{file.relative_to(ROOT)}:{node.lineno}", node.value, given))
    return [*found, *uses_of_templates()]


def uses_of_templates() -> Iterator[Use]:
    """The same of the pages' templates, where every message is the first argument of `say`."""
    for file in sorted((ROOT / "core").rglob("*.html")):
        for call in jinja2.Environment().parse(file.read_text(encoding="utf-8")).find_all(nodes.Call):
            if isinstance(call.node, nodes.Name) and call.node.name == "say":
                code = call.args[0].as_const()
                yield Use(f"{file.relative_to(ROOT)}:{call.lineno}", code, {keyword.key for keyword in call.kwargs})


def is_code(text: str) -> bool:
    return (
        text not in COMMANDS and text.startswith(PREFIXES) and text.replace("-", "").isalnum() and text.isascii() and text == text.lower()
    )


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_language_has_the_same_messages_with_the_same_parts_and_names(language: str) -> None:
    theirs, english = read(language), read("en")
    assert sorted(theirs) == sorted(english)
    different = [code for code, entry in english.items() if (entry.parts, entry.names) != (theirs[code].parts, theirs[code].names)]
    assert different == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_message_stands_in_the_file_that_its_code_begins_with(language: str) -> None:
    misplaced = [code for code, entry in read(language).items() if entry.file != "flaw" and not code.startswith(f"{entry.file}-")]
    assert misplaced == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_messages_use_only_functions_that_there_are(language: str) -> None:
    assert {name for entry in read(language).values() for name in entry.functions} <= {*NUMBERS, PERSON, "NUMBER"}


def test_every_code_of_the_source_has_words() -> None:
    assert [f"{use.place}: {use.code}" for use in uses() if use.code not in read("en")] == []


def test_every_message_is_given_all_that_its_words_name() -> None:
    lacking = [
        f"{use.place}: {use.code} lacks {sorted(missing)}"
        for use in uses()
        if use.given is not None and use.code in read("en") and (missing := read("en")[use.code].names - use.given - BUILT_IN)
    ]
    assert lacking == []


def test_every_message_is_used() -> None:
    used = {use.code for use in uses()} | {term for entry in read("en").values() for term in entry.terms}
    unused = [code for code, entry in read("en").items() if code not in used and entry.file not in {"flaw", "schema"}]
    assert unused == []


def test_a_flaw_says_where_what_was_found_and_what_was_expected() -> None:
    flaw = Message.of("flaw", where="cell.toml: x", found="-1", expected="more")
    assert str(flaw) == "cell.toml: x: found -1, expected more"
    assert flaw.say("de") == "cell.toml: x: gefunden: -1, erwartet: more"


def test_a_code_that_no_catalogue_has_is_said_as_it_is() -> None:
    assert str(Message.of("no-such-code", distance_m=0.1)) == "no-such-code {'distance_m': 0.1}"


def test_a_message_comes_back_from_json_as_it_was() -> None:
    inner = Message.of("text", text="inside")
    message = Message.of("planning-other-axes", refusal=inner, axes="x,y")
    assert Message.model_validate_json(message.model_dump_json()) == message
    assert message.parameters["refusal"] == inner


def test_errors_say_their_message_in_english() -> None:
    assert str(BadCell("cell.toml", "flaw", found="a", expected="b")) == "cell.toml: found a, expected b"
    assert NoPath("text", text="No path.").message.say("de") == "No path."


def test_a_name_in_a_foreign_file_commands_no_terminal() -> None:
    assert str(Message.of("text", text="a\x1b[31mb\nc ä 日")) == r"a\x1b[31mb\nc ä 日"
