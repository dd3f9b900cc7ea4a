"""Runs on a real service over real sockets: from the order to the payload, and every way in which it can end early."""

from __future__ import annotations

import io
import json
import re
import signal
import threading
import time
import zipfile
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import httpx2 as httpx
import numpy as np
import pytest

from core.cell.folder import load_cell
from core.estimation.identification import identify_recording
from core.recording.folder import read_recording, recording_sha256
from core.robot.model import RobotModel
from tests.server.real_service import ROOT, Console, RealService, wait_for


@pytest.fixture(scope="module")
def service(real: RealService) -> RealService:
    return real


@pytest.fixture(autouse=True)
def nothing_left(console: Console) -> Iterator[None]:
    """What a test leaves behind when it fails keeps its cell from no other test."""
    yield
    for order in console.http.get("/api/orders").json():
        run = order["run"]["run"]
        for command in ("stop", "clear"):
            if command in console.run(run)["commands"]:
                console.command(run, command)
    wait_for(lambda: console.http.get("/api/orders").json() == [], "every cell to be free")


def recorded(service: RealService, run: str) -> int:
    return len(read_recording(service.data / "recordings" / run / "recording"))


def events(console: Console, run: str) -> list[dict]:
    return [message["event"] for message in console.http.get(f"/api/runs/{run}/events?kind=event").json()]


def watch(console: Console, run: str, messages: list[dict]) -> None:
    with console.socket(f"/api/runs/{run}/live") as live:
        messages.extend(json.loads(text) for text in live)


def test_a_run_is_queued_shown_released_held_resumed_and_tells_what_the_robot_carries(service, console, tmp_path: Path):
    before = figures(console, *FIGURES)
    run = console.queue()
    assert console.run(run)["job_state"] == "NotAllowedToStart"
    console.wait(run, "Idle")
    messages: list[dict] = []
    watching = threading.Thread(target=watch, args=(console, run, messages))
    watching.start()
    assert console.release(run).status_code == 200
    console.wait_moving(run)
    held = console.command(run, "hold")
    assert held.status_code == 200, held.text
    assert console.wait(run, "Held")["job_state"] == "Interrupted"
    refused = console.command(run, "hold")
    assert refused.status_code == 409
    assert {"resume", "stop", "abort"} == set(refused.json()["allowed"])
    assert console.command(run, "resume").status_code == 200
    done = console.finish(run)
    assert done["state"] == "Complete", done

    answer = console.http.get(f"/api/runs/{run}/result").json()
    truth = load_cell(ROOT / "cells" / "lwr4_bench").payloads["steel_block"].parameters
    assert answer["safety_rated"] is False
    assert abs(answer["mass_kg"] - truth.mass) < 5 * answer["mass_std_kg"] + 1e-3
    np.testing.assert_allclose(answer["com_m"], truth.com, atol=1e-3)
    assert np.shape(answer["covariance"]) == (10, 10)
    assert {each["phase"] for each in answer["verification"]} <= {"rotate:x", "rotate:y", "rotate:z"}
    assert all(each["ratio"] < 2.0 for each in answer["verification"])
    assert answer["verification"]

    watching.join(30)
    assert not watching.is_alive(), "the service closes the socket at the end of the run"
    sequences = [message["sequence"] for message in messages if message["kind"] == "event"]
    assert sequences == list(range(1, len(sequences) + 1))
    assert any(message["kind"] == "samples" and message["reconstructed"] for message in messages)
    states = [event["state"] for event in events(console, run) if event["kind"] == "state_changed"]
    assert states[:4] == ["Resetting", "Idle", "Starting", "Execute"]
    late = [event for event in events(console, run) if event["kind"] == "robot_stopped" and event["lateness"]]
    assert states[4:-2] == ["Holding", "Held", "Unholding", "Execute"] * (1 + len(late)), "held as told, and where a busy machine was late"
    assert states[-2:] == ["Completing", "Complete"]
    assert recorded(service, run) > 20_000
    check_downloads(console, run, tmp_path)
    held_count, *others = before
    assert figures(console, *FIGURES) == [held_count + 1.0 + len(late), *(count + 1.0 for count in others)]


@pytest.mark.thorough
def test_a_run_with_a_target_says_how_far_it_met_it_and_what_it_left_out(console):
    run = console.queue(target={"mass_share": 0.05}, pace="real_time")
    console.wait(run, "Idle")
    planned_s = console.http.get(f"/api/runs/{run}/plan").json()["plan"]["summary"]["robot_s"]
    assert console.release(run).status_code == 200
    done = console.finish(run)
    assert done["state"] == "Complete", done
    assert done["finished_steps"] == 6
    answer = console.http.get(f"/api/runs/{run}/result").json()
    assert answer["target"]["standing"] == "reached"
    assert answer["target"]["target"]["mass_share"] == 0.05
    reached = [event for event in events(console, run) if event["kind"] == "target_reached"]
    if reached:  # a computer that has other things to do answers when the robot is home
        assert answer["target"]["left_out"]["made"] == reached[0]["made"]
        assert answer["seconds"]["robot"] == pytest.approx(planned_s - answer["target"]["left_out"]["saved_s"], abs=0.5)


@pytest.mark.thorough
def test_a_run_without_the_payload_and_one_with_it_make_the_same_motions_and_the_joints_tell_the_payload(service, console):
    plans, runs = [], []
    for empty in (True, False):
        runs.append(console.queue(identify_from="joint_torques", axes="x", empty=empty, without=None if empty else runs[0]))
        console.wait(runs[-1], "Idle", seconds=180)
        plans.append(console.http.get(f"/api/runs/{runs[-1]}/plan").json()["plan"])
        assert console.release(runs[-1]).status_code == 200
        done = console.finish(runs[-1])
        assert done["state"] == "Complete", done
    assert [part["part"].split()[0] for part in plans[0]["paths"]] == ["transfer", "wave", "home"]
    assert plans[0]["plan_digest"] == plans[1]["plan_digest"]
    alone, loaded = (read_recording(service.data / "recordings" / run / "recording") for run in runs)
    assert (alone.payload, loaded.payload) == (console.run(runs[0])["payload"], "steel_block") == (None, "steel_block")
    answer = console.http.get(f"/api/runs/{runs[1]}/result").json()
    estimate = identify_recording(loaded, without=alone).estimate
    assert estimate is not None
    np.testing.assert_allclose(answer["parameters"][0], estimate.phi[0], rtol=1e-6)
    truth = load_cell(ROOT / "cells" / "lwr4_bench").payloads["steel_block"].parameters
    assert abs(answer["mass_kg"] - truth.mass) < 3.0 * answer["mass_std_kg"]
    loaded_run = {"cell": "lwr4_bench", "payload": "steel_block", "without": runs[1]}
    refused = console.http.post("/api/runs", json=loaded_run)
    assert (refused.status_code, refused.json()["type"]) == (409, "/problems/torques-run-not-empty")
    assert console.http.post("/api/runs", json=loaded_run | {"without": "0123"}).json()["type"] == "/problems/runs-unknown"


def check_downloads(console: Console, run: str, folder: Path) -> None:
    """The recording as a zip that the engine reads, the report as a page that may do nothing."""
    sent = console.http.get(f"/api/runs/{run}/recording")
    assert sent.headers["content-type"] == "application/zip"
    with zipfile.ZipFile(io.BytesIO(sent.content)) as archive:
        archive.extractall(folder)
    [unpacked] = folder.iterdir()
    kept = console.service.data / "recordings" / run / "recording"
    assert recording_sha256(unpacked) == recording_sha256(kept)
    page = console.http.get(f"/api/runs/{run}/report")
    assert page.headers["content-type"].startswith("text/html")
    assert "sandbox" in page.headers["content-security-policy"]
    assert "Steel block" in page.text or "steel block" in page.text
    assert '<html lang="de">' in console.http.get(f"/api/runs/{run}/report", params={"language": "de"}).text
    (console.service.data / "recordings" / run / "report.de.html").unlink()  # as of an earlier version
    assert console.http.get(f"/api/runs/{run}/report", params={"language": "de"}).text == page.text


FIGURES = (
    'heft_run_states_total{state="Held"}',
    'heft_runs_ended_total{job_state="Ended"}',
    'heft_run_motion_seconds_count{job_state="Ended"}',
    'heft_guard_stops_total{error="Held"}',
)
"""Of a run that was once on hold and came through."""
LATE = 'heft_late_total{cause="network"}'


def figures(console: Console, *names: str) -> list[float]:
    """What Prometheus reads, over all runs of the service; 0 of what it has not counted yet."""
    lines = console.http.get("/metrics").text.splitlines()
    known = dict(line.rsplit(" ", 1) for line in lines if not line.startswith("#"))
    return [float(known.get(name, 0.0)) for name in names]


def test_a_release_is_void_when_it_is_not_for_the_plan_that_waits_and_a_stop_ends_what_was_released(console):
    run = console.queue(seed=1)
    console.wait(run, "Idle")
    other = console.release(run, plan_sha256="0" * 64)
    assert other.status_code == 409
    assert "void" in other.json()["detail"]
    forged = console.release(run, offer="1.0.abc")
    assert forged.status_code == 409
    sent = console.sent
    assert console.release(run, sent={**sent, "stamp_s": sent["stamp_s"] + 60}).status_code == 409
    assert console.release(run, sent={**sent, "fence": sent["fence"] - 1}).status_code == 409
    assert console.run(run)["state"] == "Idle"
    check_a_stop_ends_the_motion(console, run)


def check_a_stop_ends_the_motion(console: Console, run: str) -> None:
    """Once it is released; its samples are kept."""
    assert console.release(run).status_code == 200
    console.wait_moving(run)
    assert console.http.post(f"/api/runs/{run}/commands", json={"command": "stop"}).status_code == 200
    stopped = console.wait(run, "Stopped")
    assert (stopped["job_state"], stopped["outcome"]) == ("Aborted", "stopped")
    assert "stopped by operator" in stopped["reason"]["text"]
    assert recorded(console.service, run) > 0


@pytest.mark.thorough
def test_a_robot_whose_console_falls_silent_keeps_its_place_and_goes_on_along_the_plan_when_it_is_told_to(service, console):
    [late] = figures(console, LATE)
    run = console.queue(seed=2)
    console.wait(run, "Idle")
    assert console.release(run).status_code == 200
    console.wait_moving(run)
    console.answering.clear()
    held = console.wait(run, "Held")
    assert held["reason_kind"] == "network-late", held
    assert "no answer from the console" in held["reason"]["text"]
    assert held["lateness"]["late_s"] >= held["lateness"]["limit_s"] == 1.0
    assert held["ends_at"] > held["held_since"]
    assert {"resume", "stop", "abort"} == set(held["commands"])
    console.answering.set()
    wait_for(lambda: console.http.get("/api/control/lwr4_bench").json()["holder"], "control to be back with the same fence")
    assert console.run(run)["state"] == "Held", "nothing moves by itself"
    assert console.command(run, "resume").status_code == 200
    done = console.finish(run)
    assert done["state"] == "Complete", done
    assert done["reason"] is None
    assert done["lateness"] is None
    assert done["result"]["determined"] == 10
    assert done["finished_steps"] == done["steps"] - 1 == 6
    planned = [event for event in events(console, run) if event["kind"] == "planned"]
    assert len(planned) == 1, "it goes on along the plan that was released"
    assert figures(console, LATE) == [late + 1.0]


@pytest.mark.thorough
def test_an_ended_run_is_gone_on_with_from_its_last_finished_pose(service, console):
    run = console.queue(seed=2)
    console.wait(run, "Idle")
    assert console.http.post(f"/api/runs/{run}/continuation").status_code == 409
    assert console.release(run).status_code == 200
    wait_for(lambda: console.run(run)["finished_steps"] >= 3, "three poses")
    assert console.command(run, "abort").status_code == 200
    ended = console.wait(run, "Aborted")
    assert ended["may_continue"]
    answers = [console.http.post(f"/api/runs/{run}/continuation", headers={"Idempotency-Key": "on"}) for _ in range(3)]
    assert {answer.status_code for answer in answers} == {202}
    [rest] = {answer.json()["run"] for answer in answers}
    wait_for(lambda: console.command(run, "clear").status_code == 200, "the control process to end")
    console.wait(rest, "Idle")
    shown = console.http.get(f"/api/runs/{rest}/plan").json()["plan"]
    assert [pose["axis"] for pose in shown["summary"]["poses"]] == ["x-", "x+", "y-", "y+", "z-", "z+"][ended["finished_steps"] :]
    where = read_recording(service.data / "recordings" / run / "recording").q_cmd[-1]
    np.testing.assert_allclose(shown["paths"][0]["q_rad"][0], where, atol=1e-5)
    assert console.release(rest).status_code == 200
    done = console.finish(rest)
    assert done["state"] == "Complete", done
    assert done["continues"] == run
    assert done["result"]["determined"] == 10
    truth = load_cell(ROOT / "cells" / "lwr4_bench").payloads["steel_block"].parameters
    assert abs(done["result"]["mass_kg"] / truth.mass - 1) < 1e-3
    assert recorded(service, rest) > recorded(service, run)


def test_an_aborted_run_keeps_its_cell_until_it_is_cleared(service, console):
    run = console.queue(seed=2)
    console.wait(run, "Idle")
    assert console.release(run).status_code == 200
    console.wait_moving(run)
    assert console.command(run, "abort").status_code == 200
    lost = console.wait(run, "Aborted")
    assert lost["job_state"] == "Aborted"
    assert lost["commands"] == ["clear"]
    following = console.queue(seed=2)
    begun = service.data / "recordings" / following
    assert console.run(following)["state"] == "Resetting"
    assert not begun.exists()
    wait_for(lambda: console.command(run, "clear").status_code == 200, "the control process to end")
    assert console.run(run)["job_state"] == "Aborted"
    wait_for(begun.exists, "the following run to begin")
    assert console.command(following, "stop").status_code == 200
    console.wait(following, "Stopped")


def test_whoever_is_not_signed_in_sees_what_moves_and_can_stop_it(service, console):
    with httpx.Client(base_url=f"http://{service.address}") as nobody:
        check_the_public_stop(nobody, console)


def check_the_public_stop(nobody: httpx.Client, console: Console) -> None:
    """Seen and stopped by somebody whom nobody knows."""
    wait_for(lambda: nobody.get("/api/now").json() == [], "the cell to be free")
    assert nobody.post("/api/now/lwr4_bench/stop").status_code == 409
    run = console.queue(seed=3, pace="real_time")
    console.wait(run, "Idle")
    assert console.release(run).status_code == 200
    console.wait_moving(run)
    [now] = nobody.get("/api/now").json()
    assert (now["cell"], now["run"], now["state"], now["moving"], now["safety_rated"]) == ("lwr4_bench", run, "Execute", True, False)
    assert nobody.post("/api/now/lwr4_bench/stop").status_code == 200
    stopped = console.wait(run, "Stopped")
    assert stopped["reason"]["text"] == "stopped by somebody who was not signed in, at 127.0.0.1."
    wait_for(lambda: nobody.get("/api/now").json() == [], "the cell to be free")


@pytest.mark.parametrize("how", ["moved", pytest.param("drawn", marks=pytest.mark.thorough)])
def test_a_zone_that_comes_into_the_way_stops_the_robot_and_the_rest_is_planned_anew_around_it(how, service, console):
    run = console.queue(seed=5, pace="real_time")
    console.wait(run, "Idle")
    shown = console.http.get(f"/api/runs/{run}/plan").json()["plan"]
    ahead = next(path for path in shown["paths"] if path["toward"] == "x-")["q_rad"][-1]
    cell = load_cell(ROOT / "cells" / "lwr4_bench")
    sensor = RobotModel.of_cell(cell).sensor_pose(np.array(ahead)).position
    name = cell.zones[0].name if how == "moved" else "trolley"
    assert console.release(run).status_code == 200
    console.wait_moving(run)
    bring = move_zones if how == "moved" else draw_and_delete
    for answer in bring(console, cell.zones[0], sensor.tolist()):
        assert answer.is_success, answer.text
        wait_for(lambda: any(event["kind"] == "robot_stopped" for event in events(console, run)), "the guard to stop the robot")
    stop = next(event for event in events(console, run) if event["kind"] == "robot_stopped")
    assert stop["error"] == "TooClose"
    assert stop["message"]["parameters"]["second"] == {"code": "body-zone", "parameters": {"name": name}}
    states = [event["state"] for event in events(console, run) if event["kind"] == "state_changed"]
    assert states[4:6] == ["Suspending", "Suspended"]
    wait_for(lambda: console.run(run)["state"] != "Suspended", "the new plan")
    found = console.run(run)
    assert found["state"] in ("Unsuspending", "Execute"), found
    assert console.command(run, "abort").status_code == 200
    console.wait(run, "Aborted")
    wait_for(lambda: console.command(run, "clear").status_code == 200, "the control process to end")
    figures = console.http.get("/metrics").text
    assert re.search(r'heft_guard_stops_total\{error="TooClose"\} [1-9]', figures)
    assert re.search(r"heft_control_ticks_total [1-9]", figures)


def move_zones(console, zone, there):
    """A zone of the file into the way, and back."""
    for place in (there, list(zone.shape.pose.xyz_m)):
        body = {"pose": {"xyz_m": place, "rpy_rad": zone.shape.pose.rpy_rad}, "measured_at": datetime.now(UTC).isoformat()}
        yield console.http.put(f"/api/cells/lwr4_bench/zones/{zone.name}", json=body)


def draw_and_delete(console, _, there):
    """A new zone in the way, and away with it."""
    shape = {"kind": "sphere", "radius_m": 0.1, "pose": {"xyz_m": there}}
    yield console.http.post("/api/cells/lwr4_bench/zones", json={"name": "trolley", "shape": shape})
    yield console.http.delete("/api/cells/lwr4_bench/zones/trolley")


def test_signing_out_ends_the_control_that_was_taken_before(service):
    other = Console(service, cell="ur5e_line")
    other.take_control()
    wait_for(lambda: other.http.get("/api/control/ur5e_line").json()["holder"], "control")
    watching = Console(service)
    assert other.http.delete("/api/session").status_code in (200, 204)
    wait_for(lambda: watching.http.get("/api/control/ur5e_line").json()["holder"] is None, "the end of control", seconds=5)
    other.leave()
    watching.leave()


def test_one_key_makes_one_run_however_often_it_is_sent(console):
    order = {"cell": "lwr4_bench", "payload": "steel_block", "seed": 9}
    answers = [console.http.post("/api/runs", json=order, headers={"Idempotency-Key": "order-9"}) for _ in range(20)]
    assert {answer.status_code for answer in answers} == {202}
    runs = {answer.json()["run"] for answer in answers}
    assert len(runs) == 1
    other = console.http.post("/api/runs", json={**order, "seed": 10}, headers={"Idempotency-Key": "order-9"})
    assert other.status_code == 422
    assert console.http.delete(f"/api/runs/{runs.pop()}").status_code == 200


@pytest.mark.thorough
def test_a_server_that_freezes_finds_a_robot_that_stands_when_it_goes_on(service, console):
    run = console.queue(seed=4)
    console.wait(run, "Idle")
    assert console.release(run).status_code == 200
    console.wait_moving(run)
    service.send(signal.SIGSTOP)
    time.sleep(1.5)
    service.send(signal.SIGCONT)
    held = console.wait(run, "Held")
    assert held["reason_kind"] == "service-late", held
    assert held["lateness"]["limit_s"] == 0.22
    wait_for(lambda: console.http.get("/api/control/lwr4_bench").json()["holder"], "control to be back")
    assert console.command(run, "resume").status_code == 200
    assert console.finish(run)["state"] == "Complete"


def test_a_server_that_dies_leaves_a_robot_that_stands_and_a_run_that_is_aborted(service, console):
    console.take_control()
    run = console.queue(seed=4)
    console.wait(run, "Idle")
    assert console.release(run).status_code == 200
    console.wait_moving(run)
    service.kill()
    wait_for((service.data / "recordings" / run / "recording").is_dir, "the recording of the stopped run")
    service.start()
    found = console.run(run)
    assert found["state"] == "Aborted"
    assert "the service ended" in found["reason"]["text"]
    check_standing(service, run)
    console.take_control()
    wait_for(lambda: console.command(run, "clear").status_code == 200, "the control process to end")


def check_standing(service: RealService, run: str) -> None:
    """The robot was told the same place in the end."""
    still = read_recording(service.data / "recordings" / run / "recording").q_cmd[-20:]
    assert np.abs(np.diff(still[-2:], axis=0)).max() == 0.0
