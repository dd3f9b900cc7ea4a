"""A cell that is uploaded is taken in whole or not at all, and no upload gets at anything outside its folder."""

from __future__ import annotations

from pathlib import Path

import pytest

from core.cell.folder import load_cell
from core.errors import BadCell, BadInput, BadRobot
from core.twin.file import read_twin
from core.twin.twin import Twin
from server.cells.archive import UPLOAD
from server.cells.folder import CellFolder
from server.cells.uploads import CellChecker, take_in, upload_folder
from server.http.errors import Conflict, Unprocessable
from server.http.problems import problem_of
from tests.core.robot.mesh_bytes import BAD
from tests.server.hostile_uploads import HOSTILE, sound, zipped
from tests.server.real_service import ROOT
from tests.twin_entries import entry


@pytest.fixture
def cells(tmp_path: Path) -> CellFolder:
    cells = CellFolder(tmp_path / "cells")
    (tmp_path / "cells").mkdir()
    return cells


def upload(checker: CellChecker, cells: CellFolder, content: bytes, name: str | None = None) -> str:
    with upload_folder(cells) as folder:
        (folder / UPLOAD).write_bytes(content)
        return take_in(checker, cells, folder, name=name)


def everything_in(folder: Path) -> dict[str, bytes]:
    return {str(file.relative_to(folder)): file.read_bytes() for file in folder.rglob("*") if file.is_file()}


@pytest.mark.parametrize("what", HOSTILE)
def test_a_hostile_upload_is_refused_and_leaves_nothing(what: str, checker: CellChecker, cells: CellFolder, tmp_path: Path) -> None:
    content = HOSTILE[what]()
    with pytest.raises(BadInput) as refusal:
        upload(checker, cells, content)
    assert everything_in(tmp_path) == {}
    assert "root:" not in str(refusal.value)
    assert str(tmp_path) not in str(refusal.value)


@pytest.mark.parametrize("what", [what for what, (_, _, scale, _) in BAD.items() if scale == "1 1 1" and what != "another kind"])
def test_a_bad_mesh_is_told_in_the_engines_words(what: str, checker: CellChecker, cells: CellFolder) -> None:
    file, _, _, words = BAD[what]
    with pytest.raises(BadRobot, match=rf"^robot\.urdf: link 'base': mesh '{file}': found .*{words}"):
        upload(checker, cells, HOSTILE[f"mesh that is {what}"]())


def test_there_are_enough_hostile_uploads() -> None:
    assert len(HOSTILE) >= 40


def test_all_that_is_wrong_with_an_upload_is_told_at_once(checker: CellChecker, cells: CellFolder) -> None:
    misspelt = sound() | {"cell.toml": sound()["cell.toml"].replace(b"noise_std", b"noise")}
    with pytest.raises(BadCell) as refusal:
        upload(checker, cells, zipped(misspelt))
    flaws = problem_of(refusal.value).flaws
    assert [flaw.where for flaw in flaws] == ["cell.toml: sensor.noise_std", "cell.toml: sensor.noise"]


@pytest.mark.parametrize("prefix", ["", "lwr4_bench/"])
def test_a_sound_cell_is_taken_in(prefix: str, checker: CellChecker, cells: CellFolder) -> None:
    assert upload(checker, cells, zipped({prefix + name: content for name, content in sound().items()})) == "lwr4_bench"
    assert everything_in(cells.folder) == {f"lwr4_bench/{name}": content for name, content in sound().items()}
    assert load_cell(cells.folder / "lwr4_bench").name == "lwr4_bench"


def test_a_cell_brings_its_twin_along(checker: CellChecker, cells: CellFolder) -> None:
    late = Twin(effects=(entry(load_cell(ROOT / "cells" / "lwr4_bench"), "time_delay", delay_s=0.012),))
    content = zipped(sound() | {"twin.json": late.model_dump_json().encode()})
    assert read_twin(load_cell(cells.folder / upload(checker, cells, content))) == late


def test_the_checker_goes_on_after_hostile_uploads(checker: CellChecker, cells: CellFolder) -> None:
    for what in ("a zip bomb", "mesh that is huge", "billion laughs"):
        with pytest.raises(BadInput):
            upload(checker, cells, HOSTILE[what]())
    assert upload(checker, cells, zipped(sound())) == "lwr4_bench"


def test_a_cell_is_replaced_only_on_request_and_as_a_whole(checker: CellChecker, cells: CellFolder) -> None:
    upload(checker, cells, zipped(sound() | {"notes.txt": b"old"}))
    digest = cells.digest("lwr4_bench")
    with pytest.raises(Conflict, match="exists already"):
        upload(checker, cells, zipped(sound()))
    with pytest.raises(Unprocessable, match="calls itself"):
        upload(checker, cells, zipped(sound()), "other")
    assert cells.digest("lwr4_bench") == digest
    upload(checker, cells, zipped(sound()), "lwr4_bench")
    assert everything_in(cells.folder) == {f"lwr4_bench/{name}": content for name, content in sound().items()}
    assert cells.digest("lwr4_bench") != digest


def test_a_replacement_that_a_crash_cut_off_is_undone(checker: CellChecker, cells: CellFolder) -> None:
    upload(checker, cells, zipped(sound()))
    (cells.folder / "lwr4_bench").rename(cells.folder / ".old-lwr4_bench")
    (cells.folder / ".new-abc").mkdir()
    cells.prepare()
    assert [each.name for each in cells.folder.iterdir()] == ["lwr4_bench"]
