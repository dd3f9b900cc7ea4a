"""ATI Net F/T: wrenches by Raw Data Transfer (RDT), one UDP packet for a record (Net F/T manual, 9620-05-NET FT).

The request is eight bytes: 0x1234, a command, how many records (0: until told to stop). A record is 36: number of the packet, number of the
sensor's sample, status, six counts; all big-endian. The bias command (0x42) is never sent: a zeroed sensor hides what is to be found.
"""

from __future__ import annotations

import contextlib
import math
import select
import socket
import struct
import time
from collections.abc import Callable
from types import TracebackType
from typing import Self

import numpy as np

from core.errors import BadState, NotConnected, UnusableSensor
from core.sensors.ati_configuration import NetFtConfiguration, read_configuration
from core.sensors.ati_status import find_fault
from core.sensors.sensor import ForceSensor, Reading
from core.sensors.sequence import Arrival, Sequence, Tally
from core.words.message import Message

RDT_PORT, HTTP_PORT = 49152, 80
HEADER, STOP, START = 0x1234, 0x0000, 0x0002
REQUEST, RECORD = struct.Struct(">HHI"), struct.Struct(">III6i")
FIRST_S = 2.0
"""The first record has to come within this time."""
WRAP = 1 << 32
BUFFER_BYTES = 1 << 22
"""As much as the system gives: what arrives while this computer is busy is not lost."""


class NetFt(ForceSensor):
    """Reads every record that the box sends; its clock is the number of its sample over its inner rate.

    Args:
        host: the box.
        calibration: serial number of the calibration that has to be in use; not looked at where None.
        clock: monotonic, s.
    """

    def __init__(
        self,
        host: str,
        *,
        rdt_port: int = RDT_PORT,
        http_port: int = HTTP_PORT,
        calibration: str | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.name = f"ATI Net F/T ({host})"
        self.tally = Tally()
        self._host, self._rdt_port, self._http_port = host, rdt_port, http_port
        self._calibration, self._clock = calibration, clock
        self._socket: socket.socket | None = None
        self._first: list[Reading] = []
        self.configuration: NetFtConfiguration | None = None
        """As the box says it, from the entry on."""

    def __enter__(self) -> Self:
        self.configuration, status = read_configuration(self._host, self._http_port)
        self._check(self.configuration, status)
        self.range = self.configuration.range
        self.tally = Tally()
        self._packets, self._samples = Sequence(WRAP, self.tally), Sequence(WRAP, Tally())
        try:
            self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER_BYTES)
            self._socket.connect((self._host, self._rdt_port))
            self._socket.setblocking(False)
            self._ask(STOP)
            self._drop_old()
            self._ask(START)
        except OSError as error:
            self._close()
            raise NotConnected("sensors-no-stream", sensor=self.name, port=self._rdt_port, seconds=FIRST_S) from error
        self._first = self.read(FIRST_S)
        if not self._first:
            self._close()
            raise NotConnected("sensors-no-stream", sensor=self.name, port=self._rdt_port, seconds=FIRST_S)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self._close()

    def read(self, wait_s: float = 0.0) -> list[Reading]:
        """The records that have arrived since, in the order of arrival; repeated ones are left out and counted.

        Raises:
            BadState: the box counts from the beginning: it was switched off meanwhile, or somebody else asked it for its stream.
        """
        found, self._first = self._first, []
        assert self._socket is not None
        if wait_s > 0.0 and not found:
            select.select([self._socket], [], [], wait_s)
        while (packet := self._receive()) is not None:
            arrival_s = self._clock()
            if len(packet) % RECORD.size or not packet:
                self.tally.malformed += 1
                continue
            for at in range(0, len(packet), RECORD.size):
                reading = self._take(packet[at : at + RECORD.size], arrival_s)
                if reading is not None:
                    found.append(reading)
        return found

    def remarks(self) -> list[Message]:
        """That it is filtered or biased."""
        said = self.configuration
        if said is None:
            return []
        named = (("sensors-filtered", said.filtered), ("sensors-biased", said.biased))
        return [Message.of(code, sensor=self.name) for code, here in named if here]

    def _check(self, said: NetFtConfiguration, status: int) -> None:
        if self._calibration is not None and said.calibration != self._calibration:
            raise UnusableSensor("sensors-wrong-calibration", sensor=self.name, found=said.calibration[:40], expected=self._calibration)
        fault = find_fault(status, axia=said.axia)
        if fault is not None:
            raise UnusableSensor("sensors-fault-at-entry", sensor=self.name, fault=fault)

    def _receive(self) -> bytes | None:
        """One packet of the box; None where there is none. A box that is gone sends none."""
        assert self._socket is not None
        with contextlib.suppress(OSError):
            return self._socket.recv(65536)
        return None

    def _take(self, record: bytes, arrival_s: float) -> Reading | None:
        said = self.configuration
        assert said is not None
        packet, sample, status, *counts = RECORD.unpack(record)
        arrival, number = self._packets.place(packet)
        if arrival is Arrival.REPEATED:
            return None
        if arrival is not Arrival.ANEW and said.inner_hz is not None:
            arrival, whole = self._samples.place(sample)
            stamp_s = whole / said.inner_hz
        else:
            stamp_s = number / said.rate_hz
        if arrival is Arrival.ANEW:
            raise BadState("sensors-began-anew", sensor=self.name, value=float(packet), limit=math.inf)
        return Reading(stamp_s, arrival_s, np.array(counts) * said.newtons, fault=find_fault(status, axia=said.axia))

    def _ask(self, command: int) -> None:
        assert self._socket is not None
        self._socket.send(REQUEST.pack(HEADER, command, 0))

    def _drop_old(self) -> None:
        """What an earlier stream has left."""
        while self._receive() is not None:
            pass

    def _close(self) -> None:
        if self._socket is not None:
            with contextlib.suppress(OSError):
                self._ask(STOP)
            self._socket.close()
            self._socket = None
