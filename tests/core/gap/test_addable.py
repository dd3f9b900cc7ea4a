"""`core.gap.addable`: what a diagnosis offers for the twin is what the twin takes."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from core.cell.cell import TWIN_FILE, Cell
from core.cell.folder import find_cell, load_cell
from core.effects.library import library
from core.errors import BadTwin
from core.gap.diagnosis import diagnose, examine
from core.gap.twin_addition import addable_to, with_effect
from core.recording.folder import write_recording
from core.recording.recording import Recording
from core.twin.twin import NOMINAL
from tests.core.gap.recorded_run import recorded

FEW = tuple(effect for effect in library() if effect.id in ("base_tilt", "time_delay", "sensor_gain", "payload_shift"))


@pytest.fixture(scope="module")
def late() -> Recording:
    """A run in which the wrench was late."""
    return recorded(delay_s=0.02)


@pytest.fixture(scope="module")
def cell(tmp_path_factory: pytest.TempPathFactory) -> Cell:
    folder = tmp_path_factory.mktemp("cell") / "lwr4_bench"
    shutil.copytree(find_cell("lwr4_bench"), folder, ignore=shutil.ignore_patterns(TWIN_FILE))
    return load_cell(folder)


def test_what_is_offered_is_added_and_what_is_not_is_refused_for_the_reason_that_was_given(
    late: Recording, cell: Cell, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("core.gap.diagnosis.library", lambda: FEW)
    write_recording(late, tmp_path / "late")
    named = {effect.id: effect for effect in diagnose(late, FEW).effects}
    assert named["time_delay"].addable
    assert named["time_delay"].why_not is None
    assert with_effect(NOMINAL, cell, tmp_path / "late", "time_delay").ids == ("time_delay",)
    refused = [effect for effect in named.values() if not effect.addable]
    assert refused
    with pytest.raises(BadTwin) as error:
        with_effect(NOMINAL, cell, tmp_path / "late", refused[0].id)
    assert error.value.found == str(refused[0].why_not)


def test_a_cell_is_offered_nothing_that_was_recorded_in_another(late: Recording, cell: Cell, tmp_path: Path) -> None:
    write_recording(late, tmp_path / "late")
    own, _ = examine(late, FEW, folder=tmp_path / "late")
    elsewhere = addable_to(own, load_cell(find_cell("ur5e_line")))
    assert not any(each.addable for each in (*elsewhere.effects, *elsewhere.pairs))
    assert str(elsewhere.effects[0].why_not) == "a recording of the cell 'lwr4_bench'"
    assert addable_to(own, cell) == own
    assert own.origin is not None
    other_arm = own.model_copy(update={"origin": own.origin.model_copy(update={"cell": None, "joints": 6})})
    assert str(addable_to(other_arm, cell).effects[0].why_not) == "a recording of 6 joints"


def test_what_the_twins_file_could_not_hold_is_not_offered(late: Recording, cell: Cell, tmp_path: Path) -> None:
    write_recording(late, tmp_path / "late")
    found, _ = examine(late, FEW, folder=tmp_path / "late")
    delay = next(each for each in found.effects if each.id == "time_delay")
    longest = {"delay_s": delay.parameters["delay_s"].model_copy(update={"value": 0.3})}
    judged = addable_to(found.model_copy(update={"effects": [delay.model_copy(update={"parameters": longest})]}), cell).effects[0]
    assert not judged.addable
    assert "found 0.3 s, expected between 0 and 0.2" in str(judged.why_not)
