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
from itertools import count
from pathlib import Path
from typing import Any

import httpx2 as httpx
from websockets.exceptions import ConnectionClosed, WebSocketException
from websockets.sync.client import ClientConnection, connect

ROOT = Path(__file__).parents[2]
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT), "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
QUICK = {"hold_s": 0.5, "settle_s": 0.4, "robot_s": 1.0, "pace": "as_fast_as_possible"}
"""A run of some 27 s of robot time, in some 5 s."""

LINKED_S = 0.3
"""A console whose newest stamp is older has no line."""
AGAIN_S = 0.5
"""Between two attempts to open a lease again."""
FIRST_PAUSE_S, LONGER, LONGEST_PAUSE_S = 0.02, 1.3, 0.3
"""Between two looks at what is waited for."""


def free_port() -> int:
    """One that nobody listens on now."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


class RealService:
    """`heft serve` on an empty folder; `start` again after `kill` goes on with the same data.

    Args:
        database_url: of its database; SQLite in the folder where absent.
    """

    def __init__(self, data: Path, module: str = "server", database_url: str | None = None) -> None:
        self.data, self.module, self.database_url = data, module, database_url
        self.password = ""
        self.port = free_port()
        self.process: subprocess.Popen[str] | None = None

    @property
    def address(self) -> str:
        return f"127.0.0.1:{self.port}"

    @property
    def store_url(self) -> str:
        """Of its database."""
        return self.database_url or f"sqlite:///{self.data / 'heft.sqlite'}"

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
            cwd=ROOT, env=ENVIRONMENT | self._database, text=True, stdout=subprocess.PIPE, stderr=log,
        )  # fmt: skip

    @property
    def _database(self) -> dict[str, str]:
        return {} if self.database_url is None else {"HEFT_DATABASE_URL": self.database_url}

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
    """A person at the cell: signed in, in control, answering stamps.

    Args:
        address: where the service is reached; its own where absent.
    """

    def __init__(self, service: RealService, cell: str = "lwr4_bench", address: str | None = None) -> None:
        self.service, self.cell, self.address = service, cell, address or service.address
        self.http = httpx.Client(base_url=f"http://{self.address}", timeout=30)
        wait_for(lambda: service.password, "the password")
        answer = self.http.post("/api/session", json={"name": "operator", "password": service.password})
        assert answer.status_code == 200, answer.text
        self.http.headers["X-CSRF-Token"] = answer.json()["csrf_token"]
        self.fence, self.number, self.stamp_s, self.heard_s = -1, 0, 0.0, 0.0
        self.answering = threading.Event()
        self.returning = threading.Event()
        """Whether a lease that broke is opened again with its fence."""
        self.page_age_s: float | None = None
        """Said with every answer, where it is known."""
        self.lease: ClientConnection | None = None

    def socket(self, path: str, **options: Any) -> ClientConnection:
        """A websocket with the browser's cookie and origin."""
        cookies = "; ".join(f"{name}={value}" for name, value in self.http.cookies.items())
        headers = {"Cookie": cookies, "Origin": f"http://{self.address}"}
        return connect(f"ws://{self.address}{path}", additional_headers=headers, compression=None, **options)

    def take_control(self) -> None:
        """And answers the stamps from now on; a lease that was open before is closed."""
        answer = self.http.post("/api/control", json={"cell": self.cell})
        assert answer.status_code == 200, answer.text
        self.keep(answer.json()["fence"])

    def keep(self, fence: int) -> None:
        """Answers the stamps with a fence from now on; a lease that was open before is closed."""
        self.fence, self.number = fence, 0
        self.answering.set()
        before, self.lease = self.lease, self._opened()
        self.stamp_s = 0.0
        threading.Thread(target=self._keep, args=(self.lease, self.fence), daemon=True).start()
        wait_for(lambda: self.stamp_s, "a stamp")
        if before is not None:
            before.close()

    @property
    def linked(self) -> bool:
        """Whether stamps come."""
        return time.monotonic() - self.heard_s < LINKED_S

    def _opened(self) -> ClientConnection:
        return self.socket(f"/api/control/{self.cell}/lease")

    def _keep(self, lease: ClientConnection, fence: int) -> None:
        """Answers, also after the lease broke, until another one is taken."""
        numbers = count()
        self._answer(lease, fence, numbers)
        while self.returning.is_set() and self.fence == fence:
            with suppress(OSError, WebSocketException):
                self.lease = self._opened()
                self._answer(self.lease, fence, numbers)
            time.sleep(AGAIN_S)

    def _answer(self, lease: ClientConnection, fence: int, numbers: Iterator[int]) -> None:
        with suppress(ConnectionClosed, OSError):
            while True:
                stamp = re.search(r"[\d.]+", str(lease.recv()))
                assert stamp is not None
                self.stamp_s, self.heard_s = float(stamp.group()), time.monotonic()
                if self.answering.is_set():
                    page = "" if self.page_age_s is None else f',"page_age_s":{self.page_age_s}'
                    lease.send(f'{{"fence":{fence},"number":{next(numbers)},"stamp_s":{stamp.group()}{page}}}')

    @property
    def sent(self) -> dict[str, float]:
        """What a command carries."""
        self.number += 1
        return {"fence": self.fence, "number": self.number, "stamp_s": self.stamp_s}

    def queue(self, **order: Any) -> str:
        """A quick run, or as it is ordered."""
        return self.order(**QUICK | order)

    def order(self, **order: Any) -> str:
        """A run; what is not said, is as the service has it."""
        answer = self.http.post("/api/runs", json={"cell": self.cell, "payload": "steel_block", **order})
        assert answer.status_code == 202, answer.text
        return str(answer.json()["run"])

    def run(self, run: str) -> dict[str, Any]:
        return dict(self.http.get(f"/api/runs/{run}").json())

    def wait(self, run: str, *states: str, seconds: float = 90) -> dict[str, Any]:
        """Until it is in one of these states."""
        wait_for(lambda: self.run(run)["state"] in states, f"{run} to be {' or '.join(states)}", lambda: self.run(run), seconds=seconds)
        return self.run(run)

    def finish(self, run: str, seconds: float = 90) -> dict[str, Any]:
        """To its end; where a machine with other work was late with an answer, it is resumed as a person would."""
        until = time.monotonic() + seconds
        while True:
            now = self.wait(run, "Complete", "Aborted", "Stopped", "Held", seconds=until - time.monotonic())
            if not is_late(now):
                return now
            self.command(run, "resume")

    def wait_moving(self, run: str) -> None:
        """Until its robot moves, resumed where a machine with other work was late."""
        while is_late(self.wait(run, "Execute", "Held")):
            self.command(run, "resume")

    @contextmanager
    def keep_moving(self, run: str) -> Iterator[None]:
        """Whenever a machine with other work is late while somebody looks, the run is resumed as a person would."""
        done = threading.Event()

        def resume() -> None:
            while not done.wait(0.1):
                if is_late(self.run(run)):
                    self.command(run, "resume")

        resuming = threading.Thread(target=resume)
        resuming.start()
        try:
            yield
        finally:
            done.set()
            resuming.join()

    def release(self, run: str, **changed: Any) -> httpx.Response:
        shown = self.http.get(f"/api/runs/{run}/plan").json()
        body = {"plan_sha256": shown["plan"]["sha256"], "offer": shown["offer"], "sent": self.sent, **changed}
        return self.http.post(f"/api/runs/{run}/release", json=body)

    def command(self, run: str, command: str) -> httpx.Response:
        return self.http.post(f"/api/runs/{run}/commands", json={"command": command, "sent": self.sent})

    def leave(self) -> None:
        """Closes the console's window."""
        self.returning.clear()
        self.http.close()
        if self.lease is not None:
            self.lease.close()


def is_late(run: dict[str, Any]) -> bool:
    """Whether a run is on hold because something was late, not because somebody asked for it."""
    return run["state"] == "Held" and bool(run["lateness"])


def wait_for(condition: Callable[[], object], what: str, now: Callable[[], object] = lambda: "", seconds: float = 60) -> None:
    """Polls, less often as it takes longer, so that asking does not slow what is waited for; fails with what it waited for."""
    until, pause_s = time.monotonic() + seconds, FIRST_PAUSE_S
    while not condition():
        assert time.monotonic() < until, f"waited {seconds:g} s for {what}: {now()}"
        time.sleep(pause_s)
        pause_s = min(LONGER * pause_s, LONGEST_PAUSE_S)


@contextmanager
def real_service(folder: Path, module: str = "server", database_url: str | None = None) -> Iterator[RealService]:
    """Started, and stopped in order."""
    service = RealService(folder / "data", module, database_url)
    service.data.parent.mkdir(parents=True, exist_ok=True)
    service.start()
    try:
        yield service
    finally:
        service.stop()
