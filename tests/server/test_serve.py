"""`heft serve` starts on nothing, tells the first password once, holds its folder, and ends in order."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from core.errors import BadInput
from server.serve import FIRST_ROLES, first_account, only_one, write_openapi
from server.store.store import Store

ROOT = Path(__file__).parents[2]


@pytest.fixture
def store(tmp_path: Path) -> Iterator[Store]:
    store = Store(f"sqlite:///{tmp_path / 'heft.sqlite'}")
    store.migrate()
    yield store
    store.close()


def test_the_first_account_is_made_once(store: Store) -> None:
    password = first_account(store)
    assert password is not None
    assert len(password) >= 16
    assert first_account(store) is None


def test_a_folder_serves_one_service_at_a_time(tmp_path: Path) -> None:
    with only_one(tmp_path), pytest.raises(BadInput, match="runs on it already"), only_one(tmp_path):
        pass
    with only_one(tmp_path):
        pass


def test_the_description_of_the_api_is_written_without_a_service(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    write_openapi(tmp_path / "openapi.json")
    assert json.loads((tmp_path / "openapi.json").read_text())["openapi"].startswith("3.1")
    assert [file.name for file in tmp_path.iterdir()] == ["openapi.json"]


@contextmanager
def served(folder: Path, port: int) -> Iterator[subprocess.Popen[str]]:
    environment = {name: value for name, value in os.environ.items() if not name.startswith("HEFT_")}
    environment |= {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "HEFT_SHUTDOWN_SECONDS": "3"}
    command = [sys.executable, "-m", "server", "serve", "--port", str(port), "--data", str(folder)]
    with subprocess.Popen(command, cwd=ROOT, env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        try:
            yield process
        finally:
            process.kill()


def wait_for(address: str, process: subprocess.Popen[str]) -> None:
    for _ in range(600):
        assert process.poll() is None, process.communicate()
        try:
            urllib.request.urlopen(f"{address}/health", timeout=5).close()
        except urllib.error.URLError:
            time.sleep(0.1)
        else:
            return
    pytest.fail("the service did not answer")


def test_a_start_on_an_empty_folder_lets_the_first_operator_in_and_ends_in_order(tmp_path: Path, unused_port: int) -> None:
    address = f"http://127.0.0.1:{unused_port}"
    with served(tmp_path / "data", unused_port) as process:
        assert process.stdout is not None
        lines = [process.stdout.readline().rstrip() for _ in range(5)]
        assert str(tmp_path / "data") in lines[0]
        told = re.search(r"account: (\w+), password (\S+)", lines[1])
        assert told is not None
        assert lines[3:] == ["", f"  {address}/#/first/{told[1]}/{told[2]}"]
        wait_for(address, process)
        body = json.dumps({"name": told[1], "password": told[2]}).encode()
        request = urllib.request.Request(f"{address}/api/session", body, {"Content-Type": "application/json"})
        with urllib.request.urlopen(request, timeout=10) as answer:
            assert json.load(answer)["roles"] == sorted(FIRST_ROLES)
        process.send_signal(signal.SIGTERM)
        out, err = process.communicate(timeout=30)
        assert process.returncode in (0, -signal.SIGTERM)
    assert out == ""
    lines = [json.loads(line) for line in err.splitlines()]
    assert any(line["message"] == "stopped" for line in lines)
    assert told[2] not in err
