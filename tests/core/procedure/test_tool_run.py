"""A whole run with a gripper that is a little off what is stated of it: the workpiece is right within its interval, tool included."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.estimation.result import result_of
from core.events import drive
from core.gap.diagnosis import examine
from core.planning.settings import Timing
from core.planning.stops import Stops
from core.procedure.identify import identify
from core.procedure.outcome import Outcome
from core.recording.folder import read_recording
from core.report.page import write_report
from core.sessions.simulated import SimulatedSession
from tests.core.handed import GRIPPER, cell_folder

ROOT = Path(__file__).parents[3]
PART = """
[payloads.part]
title = "Part held by the gripper"
mass_kg = 1.0
first_moment_kg_m = [0.01, -0.005, 0.12]
inertia_kg_m2 = [0.016425, 0.00005, -0.0012, 0.0165, 0.0006, 0.001125]
source = "made up"
box = { size_m = [0.08, 0.08, 0.08], pose.xyz_m = [0.01, -0.005, 0.12] }
"""
OFF = 1.0
"""How many standard deviations the true gripper is off."""


def as_it_is(cell: Cell) -> Cell:
    """The cell with the gripper as it really is: off by its standard deviations."""
    tool = cell.tools["gripper"]
    mass, moment, inertia = tool.mass_std_kg or 0.0, tool.first_moment_std_kg_m or (0.0,) * 3, tool.inertia_std_kg_m2 or (0.0,) * 6
    true = tool.model_copy(
        update={
            "mass_kg": (tool.mass_kg or 0.0) + OFF * mass,
            "first_moment_kg_m": tuple(np.add(tool.first_moment_kg_m or 0.0, np.multiply(OFF, moment)).tolist()),
            "inertia_kg_m2": tuple(np.add(tool.inertia_kg_m2 or 0.0, np.multiply(OFF, inertia)).tolist()),
        }
    )
    return cell.model_copy(update={"tools": {"gripper": true}})


@pytest.fixture(scope="module")
def ran(tmp_path_factory: pytest.TempPathFactory) -> tuple[Cell, Outcome, Path]:
    folder = tmp_path_factory.mktemp("tools")
    cell = load_cell(cell_folder(folder, toml=GRIPPER + PART))
    carried = cell.payloads["part"]
    session = SimulatedSession(as_it_is(cell), carried.parameters, seed=4)
    stops = Stops.of_procedure(timing=Timing(robot_s=1.0))
    steps = identify(cell, session, carried.box, stops=stops, payload="part", reference=carried, seed=4, out=folder / "recording")
    return cell, drive(steps), folder


def test_the_workpiece_is_right_within_its_interval_which_needs_the_tools_share(ran: tuple[Cell, Outcome, Path]) -> None:
    cell, outcome, folder = ran
    truth = cell.payloads["part"].parameters.phi
    result = outcome.result(folder / "recording")
    assert result.estimate is not None
    assert result.workpiece is not None
    found, std = np.array(result.workpiece.phi, dtype=float), np.array(result.workpiece.std, dtype=float)
    assert (np.abs(found - truth) < 2.5 * std).all()
    whole_std = np.array(result.estimate.std, dtype=float)
    assert result.estimate.budget is not None
    assert abs(found[0] - truth[0]) > 2.5 * float(result.estimate.budget.repeatability_std[0] or np.inf)
    stated = cell.tools["gripper"]
    np.testing.assert_allclose(std[0] ** 2, whole_std[0] ** 2 + (stated.mass_std_kg or 0.0) ** 2)
    np.testing.assert_allclose(result.workpiece.covariance[0][1], result.estimate.covariance[0][1])
    assert result.workpiece.remarks == []
    assert result.requirement is not None  # by the whole, which hangs on the flange
    assert result.requirement.adequacy is not None
    assert result.requirement.message.code == "requirement-good-enough"
    assert result.workpiece.consistent
    assert result.workpiece.reference is not None
    np.testing.assert_allclose(np.array(result.workpiece.reference.phi, dtype=float), truth)


def test_the_whole_is_tools_and_workpiece_and_so_is_its_reference(ran: tuple[Cell, Outcome, Path]) -> None:
    _, outcome, folder = ran
    result = outcome.result(folder / "recording")
    assert result.estimate is not None
    assert result.reference is not None
    assert result.estimate.phi[0] == pytest.approx(1.802, abs=0.001)
    assert result.reference.phi[0] == pytest.approx(1.8)
    assert result.reference.source == "made up; with gripper"


def test_a_recording_knows_its_tools_and_is_answered_alike(ran: tuple[Cell, Outcome, Path]) -> None:
    cell, outcome, folder = ran
    read = read_recording(folder / "recording")
    assert [tool.name for tool in read.tools] == ["gripper"]
    np.testing.assert_array_equal(read.tools[0].parameters.phi, outcome.recording.tools[0].parameters.phi)
    np.testing.assert_array_equal(read.tools[0].std, outcome.recording.tools[0].std)
    again = result_of(outcome.identification, read, seconds=outcome.result().seconds)
    assert again.workpiece == outcome.result().workpiece
    assert (read.sensor.name, again.plan_sha256) == (cell.sensor.name, None)


def test_the_answer_names_its_plan_as_the_report_does_and_when_the_robot_was_done(ran: tuple[Cell, Outcome, Path]) -> None:
    _, outcome, _ = ran
    at = datetime(2026, 3, 1, tzinfo=UTC)
    assert (outcome.result(at=at).plan_sha256, outcome.result(at=at).ended_at) == (outcome.summary.plan_digest, at)


@pytest.mark.thorough
def test_the_diagnosis_takes_the_tools_for_no_other_payload(ran: tuple[Cell, Outcome, Path]) -> None:
    _, outcome, _ = ran
    diagnosis, _ = examine(outcome.recording)
    assert [also.id for also in diagnosis.also if also.id == "payload_mismatch" and also.material] == []
    without, _ = examine(replace(outcome.recording, tools=()))
    assert [also.id for also in without.also if also.id == "payload_mismatch" and also.material] == ["payload_mismatch"]


@pytest.mark.thorough
def test_report_and_terminal_show_the_workpiece_alone(ran: tuple[Cell, Outcome, Path]) -> None:
    _, outcome, folder = ran
    page = folder / "report.html"
    write_report(page, recording=outcome.recording, identification=outcome.identification, run=outcome.summary)
    text = page.read_text()
    assert "<h2>Workpiece alone</h2>" in text
    assert "Without Two-finger gripper (0.8 kg)" in text
    command = [sys.executable, "-m", "core.cli", "identify", str(folder / "recording"), "--json", str(folder / "answer.json")]
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "COLUMNS": "200"}
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    assert "The whole in the sensor frame, tools and workpiece" in done.stdout
    assert "Workpiece alone, in the sensor frame" in done.stdout
    answer = json.loads((folder / "answer.json").read_text())
    assert answer["workpiece"]["phi"][0] == pytest.approx(1.002, abs=0.001)
