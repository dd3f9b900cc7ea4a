"""Another program's log where a recording is asked for: one command from the file to the answer, without a question."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import Result
from typer.testing import CliRunner

from core.cli.answer_file import read_diagnosis_file, read_result_file
from core.cli.main import app
from core.errors import BadInput
from core.recording.logs.question import OpenQuestion
from tests.core.recording.logs.foreign_logs import write_ati, write_csv, write_rtde, write_transforms, write_undecided
from tests.core.recording.logs.payload_log import LEVER_M, MASS_KG

REAL = Path(__file__).parents[3] / "docs" / "logs"

FORMATS: dict[str, Callable[[Path], Path | tuple[Path, ...]]] = {
    "csv": write_csv,
    "rtde": write_rtde,
    "ati with poses": write_ati,
    "ros 1": lambda folder: write_transforms(folder, "ros1"),
    "ros 2, mcap": lambda folder: write_transforms(folder, "mcap"),
}


def run(command: str, *arguments: object) -> Result:
    return CliRunner().invoke(app, [command, *map(str, arguments)])


def files_of(form: str, folder: Path) -> tuple[Path, ...]:
    made = FORMATS[form](folder)
    return made if isinstance(made, tuple) else (made,)


@pytest.mark.parametrize("form", FORMATS)
def test_a_log_is_identified_by_one_command(tmp_path: Path, form: str) -> None:
    said = run("identify", *files_of(form, tmp_path), "--json", tmp_path / "answer.json")
    assert said.exit_code == 0, said.output
    estimate = read_result_file(tmp_path / "answer.json").estimate
    assert estimate is not None
    assert abs(estimate.phi[0] - MASS_KG) < 1.96 * estimate.std[0]
    assert estimate.phi[3] / estimate.phi[0] == pytest.approx(LEVER_M[2], abs=2e-3)


@pytest.mark.parametrize("form", ["csv", *(pytest.param(form, marks=pytest.mark.thorough) for form in list(FORMATS)[1:])])
def test_a_log_is_diagnosed_by_one_command(tmp_path: Path, form: str) -> None:
    said = run("diagnose", *files_of(form, tmp_path), "--json", tmp_path / "answer.json", "--report", tmp_path / "report")
    assert said.exit_code == 0, said.output
    assert (tmp_path / "report" / "diagnosis.html").is_file()
    diagnosis = read_diagnosis_file(tmp_path / "answer.json")
    assert diagnosis.lacking is None
    assert diagnosis.gap is not None
    assert diagnosis.origin is None  # of a recording that is gone: nothing of it goes into a twin
    assert not list(tmp_path.glob("heft-*"))


def test_a_folder_of_logs_brings_its_mapping(tmp_path: Path) -> None:
    said = run("identify", REAL / "kuka-med14", "--json", tmp_path / "answer.json")
    assert said.exit_code == 0, said.output
    assert "What the log was taken for" in said.stderr


def test_what_cannot_be_told_is_a_question_that_the_same_command_takes(tmp_path: Path) -> None:
    log = write_undecided(tmp_path)
    asked = run("identify", log).exception
    assert isinstance(asked, OpenQuestion)
    assert "--set 'wrench.axes=sensor'" in str(asked)
    said = run("identify", log, "--set", "wrench.axes=sensor", "--set", "wrench.sign=-1")
    assert said.exit_code == 0, said.output


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["log.csv", "recording"], "cli-log-beside-recording"),
        (["recording", "recording"], "cli-one-recording"),
        (["recording", "--set", "wrench.sign=-1"], "cli-option-of-logs"),
    ],
)
def test_logs_and_recordings_are_not_mixed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: list[str], code: str) -> None:
    monkeypatch.chdir(tmp_path)
    write_csv(tmp_path)
    (tmp_path / "recording").mkdir()
    (tmp_path / "recording" / "recording.json").write_text("{}")
    refused = run("identify", *arguments).exception
    assert isinstance(refused, BadInput)
    assert refused.message.code == code


def test_no_experiment_continues_a_log(tmp_path: Path) -> None:
    said = run("diagnose", write_csv(tmp_path), "--cell", "lwr4_bench", "--experiment", tmp_path / "next.json")
    assert isinstance(said.exception, BadInput)
    assert said.exception.message.code == "cli-experiment-of-log"
