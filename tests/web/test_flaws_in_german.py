"""Whatever can be wrong with a file has German words: the engine's phrases are read off its source, those of pydantic provoked."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterator
from contextlib import closing
from copy import deepcopy
from math import inf, nan
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, FilePayload, expect
from pydantic import BaseModel, ValidationError

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.errors import BadInput
from core.files.schema_flaw import schema_flaw
from core.recording.manifest import Manifest, manifest_of
from core.twin.twin import Twin
from server.cells.archive import UPLOAD
from server.cells.uploads import CellChecker
from server.http.problems import problem_of
from tests.core.recording.small_recording import recording
from tests.server.hostile_uploads import CELL, HOSTILE, sound, zipped
from tests.server.real_service import RealService
from tests.twin_entries import entry
from tests.web.engine_phrases import HOLE, of_flaws
from tests.web.german_words import german
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import show, signed_in
from tests.web.tablet import Tablet

OF_UPLOADS = {"upload", "upload: {}", "a cell of ordinary size"}
"""Where a flaw of the zip itself is, and what is said of one on which the check ended."""
WRONG = ("text", "", "2026-01-02T03:04:05", "x" * 300, 3, 2.5, True, None, -1e9, 1e9, nan, inf, [], [1], list(range(9)), {}, {"odd": 1})
SHOWN = (
    "no zip", "a link to a file", "a zip bomb", "no cell.toml", "robot.urdf absolute", "mesh by http://", "mesh that says it is huge",
    "XInclude", "a negative mass", "a name twice", "a loop of links", "a clearance that is NaN", "a key that nobody knows",
    "a twin with an effect that there is not", "thousands of names twice", "a hundred thousand links",
)  # fmt: skip
PLACE = re.compile(r"(cell\.toml|robot\.urdf|twin\.json)\b")


def is_value(text: str) -> bool:
    """A value of the file, its beginning, or a number with its unit."""
    return bool(re.match(r"""['"\[({]|-?\d|-?inf|nan|None|True|False""", text))


def has_words(text: str, known: set[str]) -> bool:
    patterns = (re.escape(phrase).replace(re.escape(HOLE), ".*") for phrase in known)
    return any(re.fullmatch(pattern, text, re.DOTALL) for pattern in patterns)


def provoked(model: type[BaseModel], content: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """What is said where one value is of another kind or another size, or absent."""
    for place in places(content):
        for wrong in (..., *WRONG):
            try:
                read(model, changed(content, place, wrong))
            except ValidationError as error:
                for each in error.errors():
                    if not each["type"].startswith("union_tag"):  # for which a cell has words of its own
                        flaw = schema_flaw(each)
                        yield flaw.found, flaw.expected
            except BadInput:
                continue  # a contradiction, whose words are read off the source


def read(model: type[BaseModel], content: dict[str, Any]) -> BaseModel:
    """As the engine reads it: a twin by pydantic itself, the others from what they were parsed to."""
    return model.model_validate_json(json.dumps(content)) if model is Twin else model.model_validate(content)


def places(content: Any, place: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    below = content.items() if isinstance(content, dict) else enumerate(content) if isinstance(content, list) else ()
    for key, value in below:
        yield (*place, key)
        yield from places(value, (*place, key))


def changed(content: dict[str, Any], place: tuple[Any, ...], value: object) -> dict[str, Any]:
    whole = deepcopy(content)
    at: Any = whole
    for key in place[:-1]:
        at = at[key]
    if value is ...:
        del at[place[-1]]
    else:
        at[place[-1]] = value
    return whole


FILES: dict[str, tuple[type[BaseModel], dict[str, Any]]] = {
    "cell.toml": (Cell, tomllib.loads((CELL / "cell.toml").read_text())),
    "recording.json": (Manifest, json.loads(manifest_of(recording()).model_dump_json())),
    "twin.json": (Twin, json.loads(Twin(effects=(entry(load_cell(CELL), "time_delay", delay_s=0.01),)).model_dump_json())),
}


@pytest.mark.parametrize("file", list(FILES))
def test_whatever_pydantic_says_of_a_file_has_german_words(file: str) -> None:
    known = set(german("flaws"))
    said = set(provoked(*FILES[file]))
    assert len(said) > 20
    assert {phrase for pair in said for phrase in pair if not is_value(phrase) and not has_words(phrase, known)} == set()


def test_the_german_phrases_are_those_that_can_be_said() -> None:
    of_pydantic = {phrase for pair in {each for file in FILES.values() for each in provoked(*file)} for phrase in pair}
    beyond = set(german("flaws")) - of_flaws() - OF_UPLOADS
    assert of_flaws() | OF_UPLOADS <= set(german("flaws"))
    assert {phrase for phrase in beyond if not any(has_words(text, {phrase}) for text in of_pydantic)} == set()


def test_what_is_wrong_with_a_hostile_upload_has_german_words(tmp_path: Path) -> None:
    known = set(german("flaws"))
    with closing(CellChecker()) as checker:
        for k, (what, content) in enumerate(HOSTILE.items()):
            folder = tmp_path / str(k)
            folder.mkdir()
            (folder / UPLOAD).write_bytes(content())
            with pytest.raises(BadInput) as refusal:
                checker.check(folder)
            for flaw in problem_of(refusal.value).flaws:
                assert PLACE.match(flaw.where) or has_words(flaw.where, OF_UPLOADS), (what, flaw)
                assert all(is_value(text) or has_words(text, known) for text in (flaw.found, flaw.expected)), (what, flaw)


@pytest.fixture
def cells_in_german(service: RealService, browser: Browser) -> Iterator[Tablet]:
    with signed_in(service, browser) as at:
        at.without_viewer()
        at.page.evaluate("localStorage.setItem('heft.language', 'de')")
        at.page.reload()
        show(at, "cells")
        at.wait(".cell-upload")
        yield at


CHECK_MS = 60_000
"""Meshes are read within limits of time; on a busy machine those take long."""


def test_the_flaws_of_an_uploaded_cell_are_told_in_german(cells_in_german: Tablet) -> None:
    page = cells_in_german.page
    told = page.locator(".cell-upload .warnings")
    for k, what in enumerate(SHOWN):
        choose(cells_in_german, f"{k}.zip", HOSTILE[what]())
        expect(told).to_contain_text(f"{k}.zip ist nicht verwendbar", timeout=CHECK_MS)
        expect(told).to_contain_text("erwartet: ")
        left = told.locator("[lang=en]").all_inner_texts()
        assert [text for text in left if not is_value(text) and not PLACE.match(text)] == [], what
    check_looks(look(page, "flaws in German"))
    choose(
        cells_in_german, "named.zip", zipped(sound() | {"cell.toml": sound()["cell.toml"].replace(b'"lwr4_bench"', b'"one for two"', 1)})
    )
    expect(told).to_contain_text("gefunden: 'one for two', erwartet: ein Text nach dem Muster")


def choose(at: Tablet, name: str, content: bytes) -> None:
    with at.page.expect_file_chooser() as chooser:
        at.press("ZIP-Datei wählen…")
    chooser.value.set_files(FilePayload(name=name, mimeType="application/zip", buffer=content))
