"""A run of the service with a robot that is reached over its maker's protocol: here a stand-in that the virtual robot moves."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from core.cell.folder import load_cell
from core.fakes.ur_arm import EMERGENCY, UrArm
from core.fakes.ur_server import UrServer
from tests.loopback import HOST
from tests.server.real_service import Console, real_service, wait_for

FOLDER = Path(__file__).parents[3] / "cells" / "ur5e_line"
CELL = load_cell(FOLDER)
RUN_S = 900.0
PATIENCE_S = 5.0
"""How long each period of the stand-in waits for its command: a computer that is busy makes the run longer and nothing else."""


def archive() -> bytes:
    """The cell, its robot reached at the stand-in's address, as it is uploaded."""
    text = (FOLDER / "cell.toml").read_text().replace('name = "ur5e_line"', 'name = "ur_real"')
    session = f'[session]\ndriver = "ur_rtde"\nhost = "{HOST}"\nmodel = "UR5e"\n\n[sensor]\n'
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as files:
        files.writestr("ur_real/cell.toml", text.replace("[sensor]\n", session, 1))
        files.write(FOLDER / "robot.urdf", "ur_real/robot.urdf")
    return packed.getvalue()


@pytest.fixture
def stand_in() -> Iterator[UrServer]:
    with UrServer(UrArm(CELL, CELL.payloads["steel_block"].parameters, seed=3), HOST, patience_s=PATIENCE_S) as server:
        yield server


@pytest.fixture
def person(tmp_path: Path, stand_in: UrServer) -> Iterator[Console]:
    with real_service(tmp_path) as service:
        at = Console(service, cell="ur_real")
        answer = at.http.post("/api/cells", content=archive(), headers={"content-type": "application/zip"})
        assert answer.status_code == 201, answer.text
        at.take_control()
        yield at
        at.leave()


def begin(person: Console) -> str:
    """A run that moves."""
    run = person.order(hold_s=0.5, settle_s=0.3)
    assert person.wait(run, "Idle", "Aborted", seconds=RUN_S)["state"] == "Idle", person.run(run)
    assert person.release(run).status_code == 200
    return run


@pytest.mark.thorough
def test_the_payload_of_a_robot_on_the_line_is_found_through_the_service(person: Console, stand_in: UrServer) -> None:
    run = begin(person)
    assert person.wait(run, "Complete", "Held", "Stopped", "Aborted", seconds=RUN_S)["state"] == "Complete", person.run(run)
    found = person.http.get(f"/api/runs/{run}/result").json()
    assert found["verdict"]["parameters"]["mass_kg"] == pytest.approx(CELL.payloads["steel_block"].mass_kg, rel=1e-3)
    assert stand_in.arm.periods_followed > 5000


def test_an_emergency_stop_on_the_robot_ends_the_run_and_is_told(person: Console, stand_in: UrServer) -> None:
    run = begin(person)
    wait_for(lambda: stand_in.arm.periods_followed > 200, "the robot to move", seconds=RUN_S)
    stand_in.arm.stop_safely(EMERGENCY)
    ended = person.wait(run, "Stopped", "Aborted", "Held", "Complete", seconds=RUN_S)
    assert ended["state"] == "Aborted"
    assert ended["reason"]["code"] == "session-ur-emergency"
