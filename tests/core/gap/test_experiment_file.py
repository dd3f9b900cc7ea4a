"""The file that carries a proposed experiment from the diagnosis to the next run."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import find_cell, load_cell
from core.cli.experiments import check_experiment_file, read_request
from core.errors import BadInput, BadRecording
from core.gap.experiment_file import ExperimentFile, read_continued_recording, read_experiment, write_experiment
from core.planning.stop import Stop, Swings
from core.recording.folder import read_recording, recording_sha256, write_recording
from core.recording.recording import Recording, append_recording
from core.robot.model import RobotModel

CELL = load_cell(find_cell("lwr4_bench"))


def recording(seconds: float = 1.0) -> Recording:
    """A robot at home."""
    t = 0.01 * np.arange(round(100 * seconds))
    q = np.tile(np.array(CELL.robot.home_rad), (len(t), 1))
    return Recording(t=t, gravity=CELL.gravity, wrench=np.ones((len(t), 6)), q=q, robot=RobotModel.of_cell(CELL).description)


@pytest.fixture
def asked(tmp_path: Path) -> ExperimentFile:
    """An experiment for a recording in `tmp_path`."""
    folder = tmp_path / "first"
    write_recording(recording(), folder)
    return ExperimentFile(
        id="swings_about_horizontal_z",
        motion="rotation about the sensor's z axis",
        stops=(Stop(down=(1.0, 0.0, 0.0), swings=Swings(about="z")),),
        splits=[("time_delay", "sensor_lowpass")],
        sigma_before=2.0,
        sigma_after=7.0,
        seconds=20.0,
        recording=str(folder),
        recording_sha256=recording_sha256(folder),
        cell="lwr4_bench",
        payload="cylinder",
        places=[],
    )


def test_what_is_written_is_read_back_and_finds_its_recording(asked, tmp_path):
    write_experiment(asked, tmp_path / "next.json")
    again, before = read_request(tmp_path / "next.json", None, CELL)
    assert again == asked
    assert len(before) == len(recording())
    assert not list(tmp_path.glob("*.part"))


def test_another_recording_under_the_same_name_is_refused(asked, tmp_path):
    write_recording(recording(2.0), tmp_path / "other")
    with pytest.raises(BadInput, match="SHA-256"):
        read_continued_recording(asked, tmp_path / "other")
    with pytest.raises(BadRecording):
        read_continued_recording(asked, tmp_path / "nowhere")


def test_the_hash_is_that_of_the_recording_not_of_what_lies_beside_it(asked):
    folder = Path(asked.recording)
    (folder / "report.html").write_text("<p>a report</p>", encoding="utf-8")
    assert recording_sha256(folder) == asked.recording_sha256


@pytest.mark.parametrize(
    ("change", "word"),
    [({"stops": [{"down": [3, 0, 0]}]}, "stops"), ({"format": "experiment/9"}, "format"), ({"recording_sha256": "0"}, "recording_sha256")],
)
def test_a_file_that_cannot_be_used_is_refused_with_its_key(asked, tmp_path, change, word):
    file = tmp_path / "next.json"
    file.write_text(json.dumps(asked.model_dump(mode="json") | change), encoding="utf-8")
    with pytest.raises(BadInput, match=word):
        read_experiment(file)


def test_an_experiment_of_another_cell_or_without_a_motion_is_refused(asked, tmp_path):
    write_experiment(asked, tmp_path / "next.json")
    with pytest.raises(BadInput, match="ur5e_line"):
        read_request(tmp_path / "next.json", None, load_cell(find_cell("ur5e_line")))
    write_experiment(asked.model_copy(update={"stops": ()}), tmp_path / "payload.json")
    with pytest.raises(BadInput, match="a motion"):
        read_request(tmp_path / "payload.json", None, CELL)


def test_an_experiment_needs_a_cell_and_a_folder_for_its_file(tmp_path):
    with pytest.raises(BadInput, match="--cell"):
        check_experiment_file(tmp_path / "next.json", None)
    with pytest.raises(BadInput, match="folder"):
        check_experiment_file(tmp_path / "no" / "next.json", "lwr4_bench")


def test_what_is_appended_goes_on_after_a_gap_and_keeps_the_columns_of_both(tmp_path):
    both = append_recording(recording(), recording(2.0))
    assert len(both) == 300
    assert both.t[100] - both.t[99] > 1.0
    assert both.phase is None
    write_recording(both, tmp_path / "both")
    np.testing.assert_array_equal(read_recording(tmp_path / "both").t, both.t)
    with pytest.raises(BadRecording, match="another robot"):
        append_recording(recording(), Recording(**{**vars(recording()), "robot": None}))
