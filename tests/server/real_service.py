"""A service in a process of its own, as `heft serve` starts it, and a person in front of its console."""

from __future__ import annotations

import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import httpx2 as httpx
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

ROOT = Path(__file__).parents[2]
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT), "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
QUICK = {"hold_s": 0.5, "settle_s": 0.4, "robot_s": 1.0, "pace": "as_fast_as_possible"}
"""A run of some 27 s of robot time, in some 5 s."""


def free_port() -> int:
    """One that nobody listens on now."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


class RealService:
    """`heft serve` on an empty folder; `start` again after `kill` goes on with the same data."""

    def __init__(self, data: Path, module: str = "server") -> None:
        self.data, self.module = data, module
        self.password = ""
        self.port = free_port()
        self.process: subprocess.Popen[str] | None = None

    @property
    def address(self) -> str:
        return f"127.0.0.1:{self.port}"

    @property
    def store_url(self) -> str:
        """Of its database."""
        return f"sqlite:///{self.data / 'heft.sqlite'}"

    def start(self) -> None:
        """Returns when it answers."""
        with (self.data.parent / "service.log").open("a") as log:
            self.process = self._started(log)
        assert self.process.stdout is not None
        threading.Thread(target=self._read, args=(self.process.stdout,), daemon=True).start()
        wait_for(self._answers, "the service to answer", seconds=60)

    def _started(self, log: Any) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [sys.executable, "-m", self.module, "serve", "--port", str(self.port), "--data", str(self.data)],
            cwd=ROOT, env=ENVIRONMENT, text=True, stdout=subprocess.PIPE, stderr=log,
        )  # fmt: skip

    def _read(self, stdout: Any) -> None:
        with stdout:
            for line in stdout:
                found = re.search(r"password (\S+)", line)
                self.password = found.group(1) if found else self.password

    def _answers(self) -> bool:
        assert self.process is not None
        assert self.process.poll() is None, (self.data.parent / "service.log").read_text()[-3000:]
        with suppress(httpx.HTTPError):
            return httpx.get(f"http://{self.address}/health").status_code == 200
        return False

    def send(self, number: signal.Signals) -> None:
        """A signal to the server process alone."""
        assert self.process is not None
        self.process.send_signal(number)

    def kill(self) -> None:
        """As a power cut does."""
        self.send(signal.SIGKILL)
        assert self.process is not None
        self.process.wait()

    def stop(self) -> None:
        """In order."""
        if self.process is not None and self.process.poll() is None:
            self.send(signal.SIGCONT)
            self.send(signal.SIGTERM)
            self.process.wait(30)


class Console:
    """A person at the cell: signed in, in control, answering stamps."""

    def __init__(self, service: RealService, cell: str = "lwr4_bench") -> None:
        self.service, self.cell = service, cell
        self.http = httpx.Client(base_url=f"http://{service.address}", timeout=30)
        wait_for(lambda: service.password, "the password")
        answer = self.http.post("/api/session", json={"name": "operator", "password": service.password})
        assert answer.status_code == 200, answer.text
        self.http.headers["X-CSRF-Token"] = answer.json()["csrf_token"]
        self.fence, self.number, self.stamp_s = -1, 0, 0.0
        self.answering = threading.Event()
        self.lease: ClientConnection | None = None

    def socket(self, path: str, **options: Any) -> ClientConnection:
        """A websocket with the browser's cookie and origin."""
        cookies = "; ".join(f"{name}={value}" for name, value in self.http.cookies.items())
        headers = {"Cookie": cookies, "Origin": f"http://{self.service.address}"}
        return connect(f"ws://{self.service.address}{path}", additional_headers=headers, compression=None, **options)

    def take_control(self) -> None:
        """And answers the stamps from now on."""
        answer = self.http.post("/api/control", json={"cell": self.cell})
        assert answer.status_code == 200, answer.text
        self.fence, self.number = answer.json()["fence"], 0
        self.answering.set()
        self.lease = self.socket(f"/api/control/{self.cell}/lease")
        threading.Thread(target=self._answer, args=(self.lease, self.fence), daemon=True).start()
        wait_for(lambda: self.stamp_s, "a stamp")

    def _answer(self, lease: ClientConnection, fence: int) -> None:
        number = 0
        with suppress(ConnectionClosed, OSError):
            while True:
                stamp = re.search(r"[\d.]+", str(lease.recv()))
                assert stamp is not None
                self.stamp_s = float(stamp.group())
                if self.answering.is_set():
                    lease.send(f'{{"fence":{fence},"number":{number},"stamp_s":{stamp.group()}}}')
                    number += 1

    @property
    def sent(self) -> dict[str, float]:
        """What a command carries."""
        self.number += 1
        return {"fence": self.fence, "number": self.number, "stamp_s": self.stamp_s}

    def queue(self, **order: Any) -> str:
        """A run."""
        answer = self.http.post("/api/runs", json={"cell": self.cell, "payload": "steel_block", **QUICK, **order})
        assert answer.status_code == 202, answer.text
        return str(answer.json()["run"])

    def run(self, run: str) -> dict[str, Any]:
        return dict(self.http.get(f"/api/runs/{run}").json())

    def wait(self, run: str, *states: str, seconds: float = 90) -> dict[str, Any]:
        """Until it is in one of these states."""
        wait_for(lambda: self.run(run)["state"] in states, f"{run} to be {' or '.join(states)}", lambda: self.run(run), seconds=seconds)
        return self.run(run)

    def release(self, run: str, **changed: Any) -> httpx.Response:
        shown = self.http.get(f"/api/runs/{run}/plan").json()
        body = {"plan_sha256": shown["plan"]["sha256"], "offer": shown["offer"], "sent": self.sent, **changed}
        return self.http.post(f"/api/runs/{run}/release", json=body)

    def command(self, run: str, command: str) -> httpx.Response:
        return self.http.post(f"/api/runs/{run}/commands", json={"command": command, "sent": self.sent})

    def leave(self) -> None:
        """Closes the console's window."""
        self.http.close()
        if self.lease is not None:
            self.lease.close()


def wait_for(condition: Callable[[], object], what: str, now: Callable[[], object] = lambda: "", seconds: float = 60) -> None:
    """Polls; fails with what it waited for."""
    until = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < until, f"waited {seconds:g} s for {what}: {now()}"
        time.sleep(0.05)


@contextmanager
def real_service(folder: Path, module: str = "server") -> Iterator[RealService]:
    """Started, and stopped in order."""
    service = RealService(folder / "data", module)
    service.data.parent.mkdir(parents=True, exist_ok=True)
    service.start()
    try:
        yield service
    finally:
        service.stop()
