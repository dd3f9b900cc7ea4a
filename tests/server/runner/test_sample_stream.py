"""Samples on disk survive whatever ends the run, up to the last whole batch."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.recording.folder import read_recording
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from core.sessions.simulated import SimulatedSession
from server.runner.run_folder import SAMPLES
from server.runner.sample_stream import SampleStream, recover_recording

ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module")
def cell() -> Cell:
    return load_cell(ROOT / "cells" / "lwr4_bench")


@pytest.fixture(scope="module")
def states(cell):
    with SimulatedSession(cell, cell.payloads["steel_block"].parameters) as robot:
        return [robot.state() for _ in range(300)]


def log_of(cell: Cell) -> SampleLog:
    return SampleLog(cell, RobotModel.of_cell(cell), payload=None, reference=None)


def written(folder: Path, states: list) -> Path:
    with SampleStream(folder) as stream:
        for k in range(0, len(states), 50):
            stream.append(states[k : k + 50], ["hold:x+" if k < 100 else "transfer"] * 50)
    return folder / SAMPLES


def test_a_stream_without_an_end_becomes_the_same_samples_bit_for_bit(tmp_path, cell, states):
    written(tmp_path, states)
    assert recover_recording(tmp_path, log_of(cell), tmp_path / "recording") == 300
    recording = read_recording(tmp_path / "recording")
    np.testing.assert_array_equal(recording.wrench, [state.wrench for state in states])
    np.testing.assert_array_equal(recording.q_cmd, [state.q_cmd for state in states])
    assert list(recording.phase[:100]) == ["hold:x+"] * 100


def test_the_samples_of_a_run_that_continued_another_follow_those_of_the_other(tmp_path, cell, states):
    written(tmp_path, states)
    recover_recording(tmp_path, log_of(cell), tmp_path / "first")
    before = read_recording(tmp_path / "first")
    both_log = SampleLog(cell, RobotModel.of_cell(cell), payload=None, reference=None, before=before)
    assert recover_recording(tmp_path, both_log, tmp_path / "both") == 300
    both = read_recording(tmp_path / "both")
    np.testing.assert_array_equal(both.wrench, np.concatenate((before.wrench, before.wrench)))
    assert both.t[300] - both.t[299] > 10.0


@pytest.mark.parametrize("share", np.linspace(0.0, 0.999, 12))
def test_a_stream_that_is_cut_anywhere_keeps_its_whole_batches(tmp_path, cell, states, share):
    file = written(tmp_path, states)
    whole = file.read_bytes()
    file.write_bytes(whole[: int(share * len(whole))])
    count = recover_recording(tmp_path, log_of(cell), tmp_path / "recording")
    assert count % 50 == 0
    assert count >= 50 * int((share * len(whole) - 2000) / (len(whole) / 6 + 200))
    assert (tmp_path / "recording").exists() == (count > 0)
    if count:
        np.testing.assert_array_equal(read_recording(tmp_path / "recording").q, [state.q for state in states[:count]])


def test_where_nothing_was_written_there_is_nothing_to_recover(tmp_path, cell):
    assert recover_recording(tmp_path, log_of(cell), tmp_path / "recording") == 0
    assert not (tmp_path / "recording").exists()
