"""Bota Systems' sensors with a serial line (Rokubi, SensONE, MegaONE): they stream frames as soon as they have power.

A frame is 37 bytes, as the maker's own drivers publish it: 0xAA; status (16 bits: skips, overrange, invalid, raw); six floats, N and N m;
time stamp, microseconds, 32 bits; temperature, degC; CRC-16/X-25 of what stands between. All little-endian, 460 800 baud.
"""

from __future__ import annotations

import math
import struct
import time
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Self

import numpy as np

from core.errors import BadState, NotConnected
from core.sensors.sensor import ForceSensor, Reading
from core.sensors.sequence import Tally
from core.sensors.serial_line import FrameReader, SerialLine, crc_of
from core.words.message import Message

BAUD, HEADER, LENGTH = 460_800, b"\xaa", 37
DATA = struct.Struct("<xH6fIf2x")
WRAP_US = 1 << 32
FIRST_S = 2.0
ANEW_US = 1 << 31
"""A stamp that is this far ahead is one from before."""
FAULTS = {
    2: "sensors-fault-invalid",
    1: "sensors-fault-saturated",
    3: "sensors-fault-raw",
    0: "sensors-fault-skipping",
}
"""By the bit of the status, the gravest first."""


class BotaSerial(ForceSensor):
    """Reads every frame.

    Args:
        port: the device, as `/dev/ttyUSB0`.
        clock: monotonic, s.
    """

    def __init__(self, port: Path, *, clock: Callable[[], float] = time.monotonic) -> None:
        self.name = f"Bota ({port})"
        self.tally = Tally()
        self._port, self._clock = port, clock
        self._line: SerialLine | None = None
        self._first: list[Reading] = []

    def __enter__(self) -> Self:
        self.tally = Tally()
        self._frames = FrameReader(HEADER, LENGTH, lambda data: crc_of(data, 0x8408, 0xFFFF), self.tally, begin=1)
        self._last_us: int | None = None
        self._whole_us, self._step_us = 0, math.inf
        self._line = SerialLine(self._port, BAUD, self.name)
        until = self._clock() + FIRST_S
        while not self._first and self._clock() < until:
            self._first = self.read(0.1)
        if not self._first:
            self._close()
            raise NotConnected("sensors-no-frames", sensor=self.name, seconds=FIRST_S)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self._close()

    def read(self, wait_s: float = 0.0) -> list[Reading]:
        """The frames that have come since.

        Raises:
            BadState: its clock begins anew: it was switched off meanwhile.
        """
        found, self._first = self._first, []
        assert self._line is not None
        data = self._line.read(0.0 if found else wait_s)
        arrival_s = self._clock()
        return found + [self._take(frame, arrival_s) for frame in self._frames.cut(data)]

    def _take(self, frame: bytes, arrival_s: float) -> Reading:
        status, *values, stamp_us, temperature = DATA.unpack(frame)
        self._count(stamp_us)
        fault = find_bota_fault(status, [*values, temperature])
        return Reading(1e-6 * self._whole_us, arrival_s, np.array(values), temperature if math.isfinite(temperature) else None, fault)

    def _count(self, stamp_us: int) -> None:
        """Unwraps the stamp; frames are missing where it goes on by several of the shortest steps."""
        if self._last_us is not None:
            step = (stamp_us - self._last_us) % WRAP_US
            if step >= ANEW_US:
                raise BadState("sensors-began-anew", sensor=self.name, value=float(stamp_us), limit=math.inf)
            self._whole_us += step
            self._step_us = min(self._step_us, step) or self._step_us
            self.tally.lost += max(0, round(step / self._step_us) - 1)
        else:
            self._whole_us = stamp_us
        self._last_us = stamp_us
        self.tally.received += 1

    def _close(self) -> None:
        if self._line is not None:
            self._line.close()
            self._line = None


def find_bota_fault(status: int, values: list[float]) -> Message | None:
    """Why a frame is no measurement; None where it is one."""
    for bit, code in FAULTS.items():
        if status >> bit & 1:
            return Message.of(code, status=f"0x{status:04X}")
    return None if all(map(math.isfinite, values)) else Message.of("sensors-fault-not-finite")
