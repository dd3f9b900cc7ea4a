"""`heft certificate` from end to end."""

from __future__ import annotations

import hashlib
import io
import json
from pathlib import Path

import pypdf
import pytest
from typer.testing import CliRunner, Result

from core.cli.main import app
from core.errors import BadInput
from core.recording.folder import recording_sha256, write_recording
from tests.core.export.cloud import cloud
from tests.core.export.known_result import answer
from tests.core.recording.small_recording import recording


def certify(*arguments: str, language: str = "en") -> Result:
    return CliRunner().invoke(app, ["certificate", *arguments], env={"HEFT_LANGUAGE": language})


@pytest.fixture
def run(tmp_path: Path) -> Path:
    """A folder as `heft run` leaves it; of a cell that nobody has, so that no robot has to be modelled."""
    write_recording(recording(), tmp_path / "run")
    (tmp_path / "run" / "result.json").write_text(answer(cloud(0), "elsewhere").model_dump_json())
    return tmp_path / "run"


def test_a_runs_folder_gives_page_and_data_that_name_each_other(run: Path, tmp_path: Path) -> None:
    said = certify(str(run), "--json", str(tmp_path / "c.json"), "--pdf", str(tmp_path / "c.pdf"), language="de")
    assert said.exit_code == 0, said.output
    data = (tmp_path / "c.json").read_bytes()
    pages = pypdf.PdfReader(io.BytesIO((tmp_path / "c.pdf").read_bytes())).pages
    assert len(pages) == 1
    text = pages[0].extract_text()
    assert hashlib.sha256(data).hexdigest() in text
    assert "Zertifikat der Nutzlastbestimmung" in text and "nicht angenommen" in text
    found = json.loads(data)
    assert found["recording"]["sha256"] == recording_sha256(run)
    assert found["conformity"]["statement"]["code"] == "certificate-no-cell"


def test_a_minus_writes_the_data_to_standard_output_of_an_answer_too(run: Path) -> None:
    said = certify(str(run / "result.json"), "--json", "-")
    assert said.exit_code == 0, said.output
    assert json.loads(said.stdout)["values"][0]["value"] == pytest.approx(cloud(0).masses.sum())


def test_a_recording_that_nobody_has_identified_is_identified_first(run: Path) -> None:
    (run / "result.json").unlink()
    said = certify(str(run), "--json", "-")
    assert said.exit_code == 0, said.output
    found = json.loads(said.stdout)
    assert found["values"][0]["value"] is None and found["values"][0]["reason"]["code"].startswith("estimation-")
    assert found["conformity"]["conforms"] is None


def test_it_is_refused_without_anything_to_write_over_a_page_without_a_run_or_for_an_unknown_cell(run: Path, tmp_path: Path) -> None:
    (tmp_path / "there.pdf").write_text("kept")
    for arguments in (
        [str(run)],
        [str(run), "--pdf", str(tmp_path / "there.pdf")],
        [str(run), "--pdf", str(tmp_path / "none" / "c.pdf")],
        [str(tmp_path), "--json", "-"],
        [str(run), "--json", "-", "--cell", "elsewhere"],
    ):
        assert isinstance(certify(*arguments).exception, BadInput), arguments
    assert (tmp_path / "there.pdf").read_text() == "kept"
