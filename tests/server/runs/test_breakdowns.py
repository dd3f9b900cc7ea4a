"""Whatever breaks while the robot moves, it stops, the run says why, and nothing moves again without a new release."""

from __future__ import annotations

import resource
import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import httpx2 as httpx
import pytest

from core.recording.folder import read_recording
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
    assert said in lost["reason"]["text"], lost
    cleared(console, run)
    assert stop_s(service, run) < 0.3 + BRAKING_S


def test_a_disk_without_room_for_the_samples_stops_the_robot(service, console):
    run = released(console, seed_of(DISK_FULL, BREAKS_AT_S))
    lost = console.wait(run, "Aborted")
    assert "could not be written" in lost["reason"]["text"]
    assert "Make room" in lost["reason"]["text"]
    assert stop_s(service, run) < 0.3 + BRAKING_S
    cleared(console, run)


@pytest.mark.thorough
def test_a_database_that_is_locked_while_the_robot_moves_stops_nothing_and_loses_nothing(service, console):
    run = released(console, 1)
    console.wait(run, "Execute")
    with locked(service):
        wait_for(lambda: console.run(run)["state"] == "Complete", "the run to come through", lambda: console.run(run), seconds=60)
        told_meanwhile = console.http.get(f"/api/runs/{run}/events?kind=event").json()
        with sqlite3.connect(service.data / "heft.sqlite") as other:
            assert other.execute("SELECT state FROM runs WHERE id = ?", (run,)).fetchone()[0] != "Complete"
    wait_for(lambda: not console.http.get("/api/now").json(), "the database to follow")
    kept = console.http.get(f"/api/runs/{run}/events?kind=event").json()
    assert kept[: len(told_meanwhile)] == told_meanwhile
    assert [message["sequence"] for message in kept] == list(range(1, len(kept) + 1))
    assert "Held" not in [message["event"].get("state") for message in kept]
    assert not (service.data / "recordings" / run / "journal.jsonl").exists()


def test_motion_does_not_begin_while_the_database_is_locked(service, console):
    run = console.queue(seed=1)
    console.wait(run, "Idle")
    with locked(service):
        refused = console.release(run)
    assert refused.status_code == 503, refused.text
    assert refused.json()["kind"] == "store-unavailable"
    assert console.run(run)["state"] == "Idle"
    assert console.http.delete(f"/api/runs/{run}").status_code == 200
    console.wait(run, "Stopped")


def test_where_nothing_can_be_written_any_more_the_robot_stops_and_stop_answers_and_all_is_there_after_a_restart(service, console):
    run = released(console, 1, pace="real_time")
    console.wait(run, "Execute")
    wait_for(lambda: console.run(run)["progress"] > 0.1, "some motion")
    with no_room(service):
        wait_for(lambda: console.run(run)["state"] == "Aborted", "the robot to stop", lambda: console.run(run))
        assert console.run(run)["reason_kind"] == "no-room", console.run(run)
        stopped = httpx.post(f"http://{service.address}/api/now/lwr4_bench/stop")
        assert stopped.status_code in (200, 409), stopped.text  # by then it may be over
        service.kill()
    assert not (service.data / "recordings" / run / "recording").exists()
    service.start()
    recording = service.data / "recordings" / run / "recording"
    wait_for(recording.is_dir, "the samples to become a recording")
    still = read_recording(recording)
    assert len(still) > 500
    console.take_control()
    found = console.run(run)
    assert found["state"] == "Aborted", found
    cleared(console, run)


def test_stop_answers_while_nothing_can_be_written(service, console):
    run = released(console, 1, pace="real_time")
    console.wait(run, "Execute")
    with locked(service), no_room(service, children=False):
        stopped = httpx.post(f"http://{service.address}/api/now/lwr4_bench/stop")
        assert stopped.status_code == 200, stopped.text
        wait_for(lambda: console.run(run)["state"] in ("Stopped", "Aborted"), "the robot to stop", lambda: console.run(run))
    wait_for(lambda: not [each for each in console.http.get("/api/now").json() if each["run"] == run], "the database to follow")
    assert console.run(run)["state"] in ("Stopped", "Aborted")
    if console.run(run)["state"] == "Aborted":
        cleared(console, run)


@contextmanager
def locked(service: RealService) -> Iterator[None]:
    """Somebody else has the database and does not let go of it."""
    other = sqlite3.connect(service.data / "heft.sqlite", isolation_level=None)
    other.execute("BEGIN EXCLUSIVE")
    try:
        yield
    finally:
        other.execute("ROLLBACK")
        other.close()


@contextmanager
def no_room(service: RealService, *, children: bool = True) -> Iterator[None]:
    """No file of the service, and of its control processes, grows any more: what a full disk looks like to them."""
    assert service.process is not None
    pids = [service.process.pid, *(descendants(service.process.pid) if children else [])]
    before = {pid: resource.prlimit(pid, resource.RLIMIT_FSIZE) for pid in pids}
    for pid, (_, hard) in before.items():
        resource.prlimit(pid, resource.RLIMIT_FSIZE, (1, hard))
    try:
        yield
    finally:
        for pid, limits in before.items():
            with suppress(ProcessLookupError):
                resource.prlimit(pid, resource.RLIMIT_FSIZE, limits)


def descendants(pid: int) -> list[int]:
    """Processes that it has begun, and that those have."""
    found = []
    for task in Path(f"/proc/{pid}/task").iterdir():
        for child in (task / "children").read_text().split():
            found += [int(child), *descendants(int(child))]
    return found
