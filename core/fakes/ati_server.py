"""An ATI Net F/T box as its public manual describes it (9620-05-NET FT): RDT over UDP, configuration pages over HTTP.

Written from the manual alone; nothing of the driver is known here. What a line does to packets is played as well.
"""

from __future__ import annotations

import heapq
import random
import socket
import struct
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from types import TracebackType
from typing import Self

Wrench = Sequence[float]
"""Fx Fy Fz Tx Ty Tz, N and N m."""
PAGE = """<?xml version="1.0" encoding="ISO-8859-1"?>
<netft><prodname>{product}</prodname><runstat>0x{status:08x}</runstat><runrate>{inner}</runrate>
<cfgnam>heft</cfgnam><cfgcalsel>0</cfgcalsel><cfgcalsn>{serial}</cfgcalsn>
<scfgfu>{force_unit}</scfgfu><scfgtu>{torque_unit}</scfgtu><cfgcpf>{per_force}</cfgcpf><cfgcpt>{per_torque}</cfgcpt>
<cfgtfx>{transform}</cfgtfx><scfgtdu>mm</scfgtdu><scfgtau>degrees</scfgtau><cfgmr>{ranges}</cfgmr>
<setcfgsel>0</setcfgsel><setuserfilter>{low_pass}</setuserfilter><setbias>{bias}</setbias>
<comrdte>{rdt}</comrdte><comrdtrate>{rate}</comrdtrate><comrdtbsiz>1</comrdtbsiz><mfgdigver>2.2.59</mfgdigver></netft>
"""
CALIBRATION_PAGE = "<netft><calsn>{serial}</calsn><calpn>SI-145-5</calpn></netft>"


@dataclass
class Setup:
    """The active configuration. Counts are per `force_unit` and `torque_unit`, which are `newton` N and `newton_metre` N m."""

    product: str = "Net F/T"
    serial: str = "FT27462"
    inner: int = 7000
    rate: int = 1000
    force_unit: str = "N"
    torque_unit: str = "Nm"
    newton: float = 1.0
    newton_metre: float = 1.0
    per_force: int = 1_000_000
    per_torque: int = 1_000_000
    transform: str = "0;0;0;0;0;0"
    bias: str = "0;0;0;0;0;0"
    ranges: str = "145;145;290;5;5;5"
    low_pass: int = 0
    rdt: str = "Enabled"
    status: int = 0
    leave_out: tuple[str, ...] = ()

    def page(self) -> str:
        text = PAGE.format(**vars(self))
        for tag in self.leave_out:
            begin, end = text.find(f"<{tag}>"), text.find(f"</{tag}>")
            text = text[:begin] + text[end + len(tag) + 3 :]
        return text


@dataclass
class LossyLine:
    """What happens to packets on their way: shares of them, s."""

    lost: float = 0.0
    repeated: float = 0.0
    jitter_s: float = 0.0
    delay_s: float = 0.0
    silent: Callable[[float], bool] = field(default=lambda _: False)
    """Whether nothing gets through at this time since the stream began, s."""


class AtiServer:
    """Serves one client at a time, on this machine.

    Args:
        wrench: of the time since the server was entered, s, on the true clock.
        drift: how much faster the box's crystal runs, as a share.
        first_packet, first_sample: numbers before the first.
        status: of the time, as above.
    """

    def __init__(
        self,
        wrench: Callable[[float], Wrench] = lambda _: (0.0,) * 6,
        *,
        setup: Setup | None = None,
        line: LossyLine | None = None,
        drift: float = 0.0,
        first_packet: int = 0,
        first_sample: int = 1_000_000,
        status: Callable[[float], int] = lambda _: 0,
        seed: int = 0,
        rdt_port: int = 0,
        http_port: int = 0,
    ) -> None:
        self.setup, self.line = setup or Setup(), line or LossyLine()
        self.commands: list[tuple[int, int]] = []
        self.sent = 0
        self.zero_s = 0.0
        self._wrench, self._status = wrench, status
        self._drift, self._first_packet, self._first_sample = drift, first_packet, first_sample
        self._random = random.Random(seed)
        self._rdt = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._rdt.bind(("127.0.0.1", rdt_port))
        self._rdt.setblocking(False)
        self.rdt_port: int = self._rdt.getsockname()[1]
        self._http = ThreadingHTTPServer(("127.0.0.1", http_port), self._handler())
        self.http_port: int = self._http.server_address[1]
        self._end = threading.Event()
        self._threads = [threading.Thread(target=run, daemon=True) for run in (self._stream, self._http.serve_forever)]

    def __enter__(self) -> Self:
        self.zero_s = time.monotonic()
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self._end.set()
        self._http.shutdown()
        for thread in self._threads:
            thread.join()
        self._http.server_close()
        self._rdt.close()

    def stamp(self, t: float) -> float:
        """What the box's sample counter shows at a time since the entry, samples."""
        return self._first_sample + t * (1.0 + self._drift) * self.setup.inner

    def _stream(self) -> None:
        """Answers requests and sends what is due: record k of a stream is taken at the box's sample nearest to k / rate."""
        client, begun, number = None, 0.0, 0
        waiting: list[tuple[float, int, bytes]] = []
        step = max(1, self.setup.inner // self.setup.rate)
        while not self._end.is_set():
            now = time.monotonic() - self.zero_s
            request = self._request()
            if request is not None:
                command, _, address = request
                client, begun, number = (None if command == 0 else address), now, 0
                waiting.clear()
            while client is not None:
                taken = begun + (number + 1) * step / self.setup.inner / (1.0 + self._drift)
                if taken > now:
                    break
                number += 1
                self._send_later(waiting, taken, begun, number)
            while waiting and waiting[0][0] <= now and client is not None:
                self._rdt.sendto(heapq.heappop(waiting)[2], client)
                self.sent += 1
            time.sleep(0.0003)

    def _send_later(self, waiting: list[tuple[float, int, bytes]], taken: float, begun: float, number: int) -> None:
        record = self._record(taken, number)
        if self.line.silent(taken - begun) or self._random.random() < self.line.lost:
            return
        for copy in range(2 if self._random.random() < self.line.repeated else 1):
            due = taken + self.line.delay_s + self._random.uniform(0.0, self.line.jitter_s)
            heapq.heappush(waiting, (due, 2 * number + copy, record))

    def _record(self, taken: float, number: int) -> bytes:
        force, torque = self.setup.per_force / self.setup.newton, self.setup.per_torque / self.setup.newton_metre
        counts = [round(value * per) for value, per in zip(self._wrench(taken), [force] * 3 + [torque] * 3, strict=True)]
        packet = (self._first_packet + number) % 2**32
        sample = round(self.stamp(taken)) % 2**32
        return struct.pack(">LLL6l", packet, sample, self._status(taken), *counts)

    def _request(self) -> tuple[int, int, tuple[str, int]] | None:
        try:
            data, address = self._rdt.recvfrom(64)
        except BlockingIOError:
            return None
        if len(data) != 8 or data[:2] != b"\x12\x34":
            return None
        command, count = int.from_bytes(data[2:4], "big"), int.from_bytes(data[4:], "big")
        self.commands.append((command, count))
        return (command, count, address) if command in (0, 2, 3) else None

    def _handler(self) -> type[BaseHTTPRequestHandler]:
        setup = self.setup

        class Pages(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                name = self.path.partition("?")[0]
                text = {"/netftapi2.xml": setup.page(), "/netftcalapi.xml": CALIBRATION_PAGE.format(serial=setup.serial)}.get(name)
                self.send_response(404 if text is None else 200)
                self.end_headers()
                self.wfile.write((text or "").encode("latin-1"))

            def log_message(self, *_: object) -> None:
                pass

        return Pages
