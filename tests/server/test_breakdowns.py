"""Whatever breaks while the robot moves, it stops, the run says why, and nothing moves again without a new release."""

from __future__ import annotations

import sqlite3
import time
from collections.abc import Iterator

import numpy as np
import pytest

from core.recording_folder import read_recording
from tests.server.breaking_robot import DISK_FULL, FROZEN, NAN, STALE, seed_of, told
from tests.server.real_service import Console, RealService, real_service, wait_for

BREAKS_AT_S = 1.0
"""In the middle of the first transfer."""
BRAKING_S = 0.25
"""From 0.25 m/s as hard as the cell's slowest joint brakes, with room for what a motion does at most."""


@pytest.fixture(scope="module")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RealService]:
    with real_service(tmp_path_factory.mktemp("breaking"), "tests.server.breaking_service") as running:
        yield running


def released(console: Console, seed: int, **order: object) -> str:
    run = console.queue(seed=seed, **order)
    console.wait(run, "Idle")
    assert console.release(run).status_code == 200
    return run


def cleared(console: Console, run: str) -> None:
    """An aborted run is left only by a clear, and is not released again."""
    assert console.release(run).status_code == 409
    assert console.run(run)["commands"] == ["clear"]
    wait_for(lambda: console.command(run, "clear").status_code == 200, "the control process to end")
    assert console.release(run).status_code == 409
    assert console.run(run)["job_state"] == "Aborted"


def stop_s(service: RealService, run: str) -> float:
    """How long after the breakdown the moving arm was told to stand still for good."""
    found = told(service.data / "recordings" / run)
    assert found is not None
    assert found.dq.any()
    return found.stop_s


@pytest.mark.parametrize(("kind", "said"), [(FROZEN, "the wrench has not changed"), (NAN, "is not finite"), (STALE, "its state is stale")])
def test_a_robot_without_a_live_sensor_or_state_stops(service, console, kind: int, said: str):
    run = released(console, seed_of(kind, BREAKS_AT_S))
    lost = console.wait(run, "Aborted")
    assert said in lost["reason"], lost
    cleared(console, run)
    assert stop_s(service, run) < 0.3 + BRAKING_S


def test_a_disk_without_room_for_the_samples_stops_the_robot(service, console):
    run = released(console, seed_of(DISK_FULL, BREAKS_AT_S))
    lost = console.wait(run, "Aborted")
    assert "could not be written" in lost["reason"]
    assert "Make room" in lost["reason"]
    assert stop_s(service, run) < 0.3 + BRAKING_S
    cleared(console, run)


def test_a_database_that_is_locked_stops_the_robot_before_anybody_wants_to_write(service, console):
    run = released(console, 1, pace="real_time")
    console.wait(run, "Execute")
    recording = service.data / "recordings" / run / "recording"
    time.sleep(0.5)
    other = sqlite3.connect(service.data / "heft.sqlite", isolation_level=None)
    other.execute("BEGIN EXCLUSIVE")
    try:
        wait_for(recording.is_dir, "the recording of the stopped run", seconds=8)
    finally:
        other.execute("ROLLBACK")
        other.close()
    lost = console.wait(run, "Aborted")
    assert "could not be written within 150 ms" in lost["reason"], lost
    still = read_recording(recording).q_cmd[-2:]
    np.testing.assert_array_equal(still[0], still[1])
    console.take_control()
    cleared(console, run)
