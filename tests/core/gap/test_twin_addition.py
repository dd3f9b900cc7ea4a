"""The loop from a fault to a twin that shows it: planted, diagnosed, added, simulated again."""

from __future__ import annotations

import json
import shutil
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from core.cell.cell import TWIN_FILE, Cell
from core.cell.folder import find_cell, load_cell
from core.cli.main import app
from core.effects.library import library
from core.errors import BadTwin
from core.estimation.identification import identify_recording
from core.events import drive
from core.gap.addition import add_found
from core.gap.answer import Diagnosis
from core.gap.diagnosis import diagnose, examine
from core.gap.twin_addition import find_effects, with_effect
from core.plant.imperfections import Imperfections
from core.plant.mechanics import Drives
from core.procedure.record import record
from core.recording.folder import read_recording, recording_sha256, write_recording
from core.recording.recording import Recording
from core.sessions.simulated import SimulatedSession
from core.twin.file import read_twin
from core.twin.twin import NOMINAL
from tests.core.gap.recorded_run import plan_of

PAYLOAD = "gripper"
TILT_RAD, DELAY_S = np.radians(0.5), 0.015
NOW = datetime(2026, 3, 1, tzinfo=UTC)
SMOOTH = Drives(damping_s=0.0, friction=0.0)
"""Friction in the joints would be found, rightly."""
FEW = tuple(effect for effect in library() if effect.id in ("base_tilt", "time_delay", "sensor_gain", "sensor_lowpass"))
runner = CliRunner()


def record_with(cell: Cell, **options: object) -> Recording:
    """A run in the simulation."""
    carried = cell.payloads[PAYLOAD]
    session = SimulatedSession(cell, carried.parameters, seed=4, drives=SMOOTH, **options)  # type: ignore[arg-type]  # any option
    return drive(record(cell, session, carried.box, plan_of("lwr4_bench", PAYLOAD)[1], payload=PAYLOAD))


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folders of a cell and of a run in which its base was tilted and its wrench late."""
    folder = tmp_path_factory.mktemp("loop")
    shutil.copytree(find_cell("lwr4_bench"), folder / "lwr4_bench", ignore=shutil.ignore_patterns(TWIN_FILE))
    faults = Imperfections(base_tilt_rad=(TILT_RAD, 0.0), wrench_delay_s=DELAY_S)
    write_recording(record_with(load_cell(folder / "lwr4_bench"), imperfections=faults), folder / "faulty")
    return folder


@pytest.fixture(scope="module")
def faulty(place: Path) -> Recording:
    return read_recording(place / "faulty")


@pytest.fixture(scope="module")
def diagnosed(faulty: Recording, place: Path) -> str:
    """The diagnosis of that run as `heft diagnose --json` writes it."""
    return examine(faulty, FEW, folder=place / "faulty")[0].model_dump_json(indent=2)


@pytest.fixture(scope="module")
def completed(place: Path) -> Cell:
    """The cell after `heft twin add`."""
    done = runner.invoke(app, ["twin", "add", str(place / "lwr4_bench"), str(place / "faulty"), "time_delay+base_tilt"])
    assert done.exception is None, done.exception
    assert "time_delay added to the twin of lwr4_bench" in done.output
    return load_cell(place / "lwr4_bench")


@pytest.fixture(scope="module")
def simulated(completed: Cell) -> Recording:
    """A run of the simulation without the faults, with the twin."""
    return record_with(completed, twin=read_twin(completed))


def test_the_entries_have_the_planted_sizes_and_say_where_they_come_from(completed: Cell, place: Path) -> None:
    delay, tilt = sorted(read_twin(completed).effects, key=lambda entry: entry.effect, reverse=True)
    assert abs(delay.parameters["delay_s"].value - DELAY_S) < 5 * delay.parameters["delay_s"].std + 3e-4
    assert tilt.parameters["about_x_rad"].value == pytest.approx(TILT_RAD, abs=1e-3)
    assert delay.recording == "faulty"
    assert delay.sha256 == recording_sha256(place / "faulty")
    assert delay.gap_after < 1.05 < delay.gap_before


@pytest.mark.thorough
def test_what_a_diagnosis_keeps_is_what_a_fit_of_its_own_finds(completed: Cell, diagnosed: str) -> None:
    kept = add_found(NOMINAL, completed, Diagnosis.model_validate_json(diagnosed), "base_tilt+time_delay", NOW)
    for found in kept.effects:
        [fitted] = [entry for entry in read_twin(completed).effects if entry.effect == found.effect]
        assert list(found.parameters) == list(fitted.parameters)
        for name, value in found.parameters.items():
            assert value.value == pytest.approx(fitted.parameters[name].value, abs=0.05 * value.std)
            assert value.std == pytest.approx(fitted.parameters[name].std, rel=0.01)
            assert value.unit == fitted.parameters[name].unit
        np.testing.assert_allclose(found.covariance, fitted.covariance, rtol=0.02, atol=0.02 * min(np.diag(fitted.covariance)))
        np.testing.assert_allclose(np.sqrt(np.diag(found.covariance)), [value.std for value in found.parameters.values()])
        assert (found.recording, found.sha256, found.added) == (fitted.recording, fitted.sha256, NOW)
        assert (found.gap_before, found.gap_after) == pytest.approx((fitted.gap_before, fitted.gap_after), rel=1e-3)


def test_a_written_diagnosis_is_added_without_fitting_and_only_to_the_twin_that_it_counted_with(
    completed: Cell, diagnosed: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fit_nothing(*_: object, **__: object) -> None:
        raise AssertionError

    monkeypatch.setattr("core.gap.twin_addition.examine", fit_nothing)
    shutil.copytree(completed.folder, tmp_path / "lwr4_bench", ignore=shutil.ignore_patterns(TWIN_FILE))
    (tmp_path / "found.json").write_text(diagnosed)
    add = ["twin", "add", str(tmp_path / "lwr4_bench"), str(tmp_path / "found.json")]
    assert runner.invoke(app, [*add, "time_delay+base_tilt"]).exit_code == 0
    assert sorted(read_twin(load_cell(tmp_path / "lwr4_bench")).ids) == ["base_tilt", "time_delay"]
    assert "replaced" in runner.invoke(app, [*add, "base_tilt+time_delay"]).output
    refused = runner.invoke(app, [*add, "time_delay"]).exception
    assert isinstance(refused, BadTwin)
    assert "a change of base_tilt since the diagnosis" in str(refused)
    (tmp_path / "found.json").write_text('{"verdict": "sunny"}')
    assert 'found.json: verdict: found "sunny"' in str(runner.invoke(app, [*add, "time_delay"]).exception)


def test_the_gap_between_the_recording_and_the_completed_twin_is_gone(faulty: Recording, completed: Cell) -> None:
    before, after = diagnose(faulty, FEW), diagnose(faulty, FEW, read_twin(completed))
    assert before.gap is not None and after.gap is not None
    assert before.verdict != "no_gap"
    assert after.verdict == "no_gap"
    assert after.gap.before == pytest.approx(1.0, abs=0.02)
    assert set(after.twin) == {"time_delay", "base_tilt"}


@pytest.mark.thorough
def test_the_twins_own_run_shows_what_was_planted(faulty: Recording, simulated: Recording) -> None:
    assert faulty.wrench is not None and simulated.wrench is not None
    smooth = np.ones(25) / 25  # the two differ in how noise is made; means of 25 ms are below it
    apart = np.column_stack([np.convolve(x, smooth, "valid") for x in (simulated.wrench - faulty.wrench).T])
    noise = load_cell(find_cell("lwr4_bench")).sensor.noise_std
    assert (apart.std(axis=0) < 0.5 * np.array(noise)).all()
    found = diagnose(simulated, FEW)
    assert {*found.pairs[0].ids} == {"time_delay", "base_tilt"}


@pytest.mark.thorough
def test_a_change_of_what_the_twin_has_is_found_as_that_effect(completed: Cell) -> None:
    repaired = record_with(completed, imperfections=Imperfections(base_tilt_rad=(TILT_RAD, 0.0)))
    found = diagnose(repaired, FEW, read_twin(completed))
    assert (found.verdict, found.effects[0].id) == ("explained", "time_delay")
    assert found.effects[0].parameters["delay_s"].value == pytest.approx(0.0, abs=5e-4)


def test_identification_with_the_twin_recovers_the_payload(simulated: Recording, completed: Cell) -> None:
    found = identify_recording(simulated, read_twin(completed))
    assert found.estimate is not None
    assert set(found.accounted) == {"time_delay", "base_tilt"}
    truth = completed.payloads[PAYLOAD].parameters.phi
    assert np.abs((found.estimate.phi - truth) / found.estimate.std).max() < 4.5
    assert found.estimate.delay_s == pytest.approx(0.0, abs=1e-3)


def test_the_twin_is_shown_as_a_table_and_as_json(completed: Cell, tmp_path: Path) -> None:
    file = tmp_path / "twin.json"
    done = runner.invoke(app, ["twin", "show", str(completed.folder), "--json", str(file)])
    assert done.exit_code == 0
    assert "time_delay" in done.output
    assert json.loads(file.read_text()) == json.loads((completed.folder / TWIN_FILE).read_text())
    assert list(tmp_path.iterdir()) == [file]


def test_an_effect_is_removed_by_its_name_only(completed: Cell, tmp_path: Path) -> None:
    shutil.copytree(completed.folder, tmp_path / "cell")
    where = str(tmp_path / "cell")
    wrong = runner.invoke(app, ["twin", "remove", where, "time_delays"])
    assert isinstance(wrong.exception, BadTwin)
    assert "'time_delay', if that is what was meant" in str(wrong.exception)
    assert runner.invoke(app, ["twin", "remove", where, "time_delay"]).exit_code == 0
    assert runner.invoke(app, ["twin", "remove", where, "base_tilt"]).exit_code == 0
    assert not (tmp_path / "cell" / TWIN_FILE).exists()
    assert "nominal" in runner.invoke(app, ["twin", "show", where]).output


def test_what_closes_nothing_is_refused_with_the_figures(completed: Cell, place: Path) -> None:
    with pytest.raises(BadTwin, match=r"closing -?\d+ % of the gap \(\d\.\d+ before, \d\.\d+ after, noise is 1\)"):
        with_effect(read_twin(completed), completed, place / "faulty", "sensor_gain+joint_offset")


@pytest.mark.parametrize(
    ("identifier", "words"),
    [
        ("time_delya", "'time_delay', if that is what was meant"),
        ("sensor_noise", "does not act on the wrench"),
        ("time_delay+base_tilt+sensor_gain+sensor_drift", "4 effects at once"),
        ("", "expected one of base_tilt"),
    ],
)
def test_what_is_no_effect_on_the_wrench_is_refused(identifier: str, words: str) -> None:
    with pytest.raises(BadTwin) as caught:
        find_effects(identifier)
    assert words in str(caught.value)


def test_a_recording_of_another_cell_is_refused(place: Path) -> None:
    other = load_cell(find_cell("ur5e_line"))
    with pytest.raises(BadTwin, match="'lwr4_bench', expected 'ur5e_line'"):
        with_effect(NOMINAL, other, place / "faulty", "time_delay")
