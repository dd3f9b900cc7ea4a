"""Ten clients watch a run, one of which does not read and one comes and goes: what the others get, and how late.

`python -m bench.watchers --seconds 30`.
"""

from __future__ import annotations

import argparse
import json
import socket
import tempfile
import threading
import time
from contextlib import suppress
from pathlib import Path

import numpy as np
from websockets.exceptions import ConnectionClosed

from tests.server.real_service import Console, real_service

READING = 8


class Reader:
    """Reads as fast as it can."""

    def __init__(self, console: Console, run: str) -> None:
        self.seen: list[tuple[float, float]] = []
        """Our clock and the robot's at each batch, s."""
        self._live = console.socket(f"/api/runs/{run}/live")
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        with suppress(ConnectionClosed, OSError):
            for text in self._live:
                now = time.monotonic()
                message = json.loads(text)
                if message["kind"] == "samples":
                    self.seen.append((now, message["t_s"][-1]))


def stalled(console: Console, run: str) -> socket.socket:
    """A client that has opened its websocket and never reads."""
    client = socket.socket()
    client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    client.connect(("127.0.0.1", console.service.port))
    cookies = "; ".join(f"{name}={value}" for name, value in console.http.cookies.items())
    host = console.service.address
    lines = [
        f"GET /api/runs/{run}/live HTTP/1.1", f"Host: {host}", f"Origin: http://{host}", f"Cookie: {cookies}", "Upgrade: websocket",
        "Connection: Upgrade", "Sec-WebSocket-Version: 13", "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==", "", "",
    ]  # fmt: skip
    client.sendall("\r\n".join(lines).encode())
    return client


def is_closed(client: socket.socket) -> bool:
    """Whether the service has given it up; reads what was on the way."""
    client.settimeout(1.0)
    with client, suppress(TimeoutError):
        while client.recv(1 << 16):
            pass
        return True
    return False


def resident_mb(pid: int) -> float:
    """Memory of a process, MB."""
    pages = int(Path(f"/proc/{pid}/statm").read_text().split()[1])
    return pages * 4096 / 1e6


def main() -> None:
    """Prints shares, latencies and memory."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=30.0)
    seconds = parser.parse_args().seconds
    with tempfile.TemporaryDirectory() as folder, real_service(Path(folder)) as service:
        assert service.process is not None
        console = Console(service)
        console.take_control()
        run = console.queue(pace="real_time", hold_s=5.0)
        console.wait(run, "Idle")
        readers = [Reader(console, run) for _ in range(READING)]
        assert console.release(run).status_code == 200
        console.wait(run, "Execute")
        before, began = resident_mb(service.process.pid), time.monotonic()
        still = stalled(console, run)
        while time.monotonic() - began < seconds:
            with console.socket(f"/api/runs/{run}/live") as coming_and_going:
                coming_and_going.recv()
        after = resident_mb(service.process.pid)
        state = console.run(run)["state"]
        closed = is_closed(still)
        console.command(run, "stop")
        console.leave()
    counts = np.array([len(reader.seen) for reader in readers])
    offsets = [np.array(reader.seen) @ [1.0, -1.0] for reader in readers]
    zero = min(float(offset.min()) for offset in offsets)
    late = np.concatenate([offset - zero for offset in offsets])
    print(f"{READING} readers: {counts.min()} to {counts.max()} batches in {seconds:.0f} s, the least {counts.min() / counts.max():.1%}")
    print(f"later than the earliest: median {1e3 * np.median(late):.0f} ms, p99 {1e3 * np.quantile(late, 0.99):.0f} ms")
    print(f"memory of the server {after - before:+.1f} MB; the run was in {state}; the client that did not read was closed: {closed}")


if __name__ == "__main__":
    main()
