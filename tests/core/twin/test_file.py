"""`twin.json` as it is written, and as somebody else may have written it."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from core.cell.cell import TWIN_FILE, Cell
from core.cell.folder import load_cell
from core.errors import BadTwin
from core.twin.file import read_twin, write_twin
from core.twin.twin import NOMINAL, Twin
from tests.twin_entries import entry

LWR4 = Path(__file__).parents[3] / "cells" / "lwr4_bench"


@pytest.fixture
def cell(tmp_path: Path) -> Cell:
    folder = tmp_path / "lwr4_bench"
    shutil.copytree(LWR4, folder, ignore=shutil.ignore_patterns(TWIN_FILE))
    return load_cell(folder)


@pytest.fixture
def twin(cell: Cell) -> Twin:
    return Twin(effects=(entry(cell, "time_delay", delay_s=0.012), entry(cell, "joint_offset", joint_3_rad=-0.01)))


def test_a_cell_without_the_file_is_nominal(cell: Cell) -> None:
    assert read_twin(cell) == NOMINAL


def test_a_twin_is_read_as_it_was_written_and_nothing_else_is_left(cell: Cell, twin: Twin) -> None:
    before = {file.name for file in cell.folder.iterdir()}
    write_twin(cell, twin)
    assert read_twin(cell) == twin
    assert {file.name for file in cell.folder.iterdir()} == before | {TWIN_FILE}


def test_a_twin_without_effects_takes_the_file_away(cell: Cell, twin: Twin) -> None:
    write_twin(cell, twin)
    write_twin(cell, twin.without("time_delay").without("joint_offset"))
    assert not (cell.folder / TWIN_FILE).exists()
    assert read_twin(cell) == NOMINAL


def test_a_twin_that_could_not_be_read_again_is_not_written(cell: Cell, twin: Twin) -> None:
    write_twin(cell, twin)
    text = (cell.folder / TWIN_FILE).read_text()
    with pytest.raises(BadTwin, match=r"delay_s\.value: found 0\.5 s, expected between 0 and 0\.2"):
        write_twin(cell, twin.with_entry(entry(cell, "time_delay", delay_s=0.5)))
    assert (cell.folder / TWIN_FILE).read_text() == text


def changed(change: Callable[[dict], None]) -> Callable[[dict], str]:
    def text(content: dict) -> str:
        change(content)
        return json.dumps(content)

    return text


def first(content: dict) -> dict:
    return content["effects"][0]


BAD = {
    "unknown effect": (
        changed(lambda c: first(c).update(effect="time_delays")),
        "found 'time_delays', expected 'time_delay'",
    ),
    "effect twice": (changed(lambda c: c["effects"].append(first(c))), "'time_delay' 2 times, expected each effect once"),
    "wrong name": (changed(lambda c: first(c)["parameters"].update(delay_ms=first(c)["parameters"]["delay_s"])), "'delay_s', if that is"),
    "missing name": (changed(lambda c: first(c)["parameters"].clear()), "delay_s: found no such key, expected it"),
    "out of bounds": (changed(lambda c: first(c)["parameters"]["delay_s"].update(value=-0.1)), "found -0.1 s, expected between 0 and 0.2"),
    "wrong unit": (changed(lambda c: first(c)["parameters"]["delay_s"].update(unit="ms")), "unit: found 'ms', expected 's'"),
    "text": (changed(lambda c: first(c)["parameters"]["delay_s"].update(value="0.01")), 'effects.0.parameters.delay_s.value: found "0.01"'),
    "not finite": (lambda c: json.dumps(c).replace("0.012", "NaN"), "delay_s.value"),
    "negative std": (changed(lambda c: first(c)["parameters"]["delay_s"].update(std=-1.0)), "delay_s.std: found -1.0"),
    "covariance of another size": (
        changed(lambda c: first(c).update(covariance=[[1e-8, 0.0]])),
        "found 1 rows, expected 1 by 1",
    ),
    "covariance below zero": (changed(lambda c: first(c).update(covariance=[[-1e-8]])), "covariance: found a matrix that is not"),
    "no hash": (changed(lambda c: first(c).update(sha256="1234")), 'sha256: found "1234"'),
    "no time zone": (changed(lambda c: first(c).update(added="2026-01-02T03:04:05")), 'added: found "2026-01-02T03:04:05"'),
    "unknown key": (changed(lambda c: c.update(effect=[])), "twin.json: effect"),
    "another format": (changed(lambda c: c.update(format="twin/2")), 'twin.json: format: found "twin/2"'),
    "no object": (lambda _: "[]", "twin.json: found"),
    "no json": (lambda _: "{", "twin.json: found JSON that does not parse"),
    "too large": (lambda c: json.dumps(c) + " " * 1_000_001, "at most 1000000"),
}


@pytest.mark.parametrize("case", BAD)
def test_a_bad_file_is_refused_in_one_sentence_that_says_where(cell: Cell, twin: Twin, case: str) -> None:
    text, expected = BAD[case]
    (cell.folder / TWIN_FILE).write_text(text(json.loads(twin.model_dump_json())))
    with pytest.raises(BadTwin) as caught:
        read_twin(cell)
    assert expected in str(caught.value)
    assert TWIN_FILE in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_link_out_of_the_folder_is_refused(cell: Cell, tmp_path: Path) -> None:
    (tmp_path / "elsewhere.json").write_text('{"format": "twin/1"}')
    (cell.folder / TWIN_FILE).symlink_to(tmp_path / "elsewhere.json")
    with pytest.raises(BadTwin, match="outside the folder"):
        read_twin(cell)
