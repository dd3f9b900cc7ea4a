"""The client in the documentation does what it says, against a service in a process of its own."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import urllib.request
from pathlib import Path

import pytest

from core.recording.manifest import read_manifest
from tests.server.real_service import QUICK, ROOT, Console, RealService, wait_for

CLIENT = ROOT / "docs" / "mes_client.py"
ORDER = {"cell": "lwr4_bench", "payload": "steel_block", "order_id": "JO-4711", "work_order": "WO-88120", "serial_number": "SN-482"}


@pytest.fixture(scope="module")
def service(real: RealService) -> RealService:
    return real


@pytest.fixture(scope="module")
def key(console: Console) -> str:
    made = console.http.post("/api/keys", json={"name": "line-3", "role": "mes"})
    assert made.status_code == 201, made.text
    return str(made.json()["key"])


def started(service: RealService, key: str, order: dict[str, object], folder: Path) -> subprocess.Popen[str]:
    client = subprocess.Popen(
        [sys.executable, str(CLIENT), f"http://{service.address}", key],
        cwd=folder, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )  # fmt: skip
    assert client.stdin is not None
    client.stdin.write(json.dumps(order))
    client.stdin.close()
    client.stdin = None
    return client


def run_of(console: Console, order_id: str) -> str:
    """The run that the client's order has made."""
    found: list[dict[str, str]] = []

    def look() -> bool:
        found[:] = console.http.get("/api/runs", params={"order_id": order_id}).json()
        return bool(found)

    wait_for(look, f"a run of order {order_id}", seconds=60)
    return found[0]["run"]


def test_it_queues_waits_and_saves_the_payload_and_the_order_is_named_in_all_that_is_left(
    service: RealService, console: Console, key: str, tmp_path: Path
) -> None:
    assert len(CLIENT.read_text().splitlines()) <= 30
    client = started(service, key, ORDER | QUICK, tmp_path)
    run = run_of(console, "JO-4711")
    console.wait(run, "Idle", "Stopped")
    assert console.release(run).status_code == 200
    said, complaints = client.communicate(timeout=200)
    assert client.returncode == 0, complaints
    assert re.search(r"^2\.7\d\d kg$", said, re.MULTILINE), said
    assert (tmp_path / "JO-4711.script").read_text().splitlines()[1].startswith("set_target_payload(2.7")
    assert console.http.get(f"/api/runs/{run}").json()["result"]["good_enough"] is True

    assert console.http.post(f"/api/runs/{run}/acceptance").status_code == 200
    told = console.run(run)
    assert (told["outcome"], told["requested_by"], told["work_order"]) == ("completed", "key:line-3", "WO-88120")
    named = {name: ORDER[name] for name in ("order_id", "work_order", "serial_number")}
    folder = service.data / "recordings" / run
    manifest = read_manifest(folder / "recording")
    assert manifest.order is not None
    assert manifest.order.model_dump() == named
    assert json.loads((folder / "result.json").read_text())["order"] == named
    result = console.http.get(f"/api/runs/{run}/result").json()
    assert result["order"] == named
    page = console.http.get(f"/api/runs/{run}/report").text
    for value in (run, *named.values(), "<dd>operator</dd>", "<dd>operator, 20", result["version"], told["plan_sha256"]):
        assert value in page


def test_the_guide_shows_it_as_it_is() -> None:
    assert f"```python\n{CLIENT.read_text()}```" in (ROOT / "docs" / "mes.md").read_text()


def test_it_ends_with_the_reason_when_the_run_does_not_come_through(
    service: RealService, console: Console, key: str, tmp_path: Path
) -> None:
    client = started(service, key, ORDER | QUICK | {"order_id": "JO-4712"}, tmp_path)
    run = run_of(console, "JO-4712")
    assert console.http.delete(f"/api/runs/{run}").status_code == 200
    _, complaints = client.communicate(timeout=60)
    assert (client.returncode, list(tmp_path.iterdir())) == (1, [])
    assert complaints.startswith("cancelled: cancelled by operator")


def test_it_says_why_an_order_is_refused(service: RealService, key: str, tmp_path: Path) -> None:
    client = started(service, key, {"cell": "lwr4_bench", "order_id": "JO-4713"}, tmp_path)
    _, complaints = client.communicate(timeout=60)
    assert client.returncode == 1
    assert "payload" in complaints


def test_nobody_who_is_not_signed_in_reads_the_descriptions(service: RealService) -> None:
    for path in ("/openapi.json", "/asyncapi.json", "/docs"):
        with pytest.raises(urllib.request.HTTPError, match="401"):
            urllib.request.urlopen(f"http://{service.address}{path}")
