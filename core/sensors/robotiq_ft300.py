"""Robotiq FT 300 and FT 300-S on a serial line: its data stream (Modbus RTU at slave 9, 19 200 baud; 100 frames a second).

The stream begins when 0x0200 is written to register 410, and ends with a break of bytes 0xFF. A frame is 16 bytes: 0x20 0x4E, six 16-bit
numbers, 0.01 N and 0.001 N m, CRC-16/MODBUS of all before; little-endian. It bears neither a number nor a time nor a status: samples get
the time of their arrival, lost ones show as gaps alone, and nobody is told that the sensor is saturated but by its range in the cell.
"""

from __future__ import annotations

import struct
import time
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Self

import numpy as np

from core.errors import NotConnected
from core.sensors.sensor import ForceSensor, Reading
from core.sensors.sequence import Tally
from core.sensors.serial_line import FrameReader, SerialLine, crc_of
from core.words.message import Message

BAUD, SLAVE, HEADER, LENGTH = 19_200, 9, b"\x20\x4e", 16
PERIOD_S = 0.01
WRITE_REGISTERS, STREAM_REGISTER, STREAM = 0x10, 410, 0x0200
DATA = struct.Struct("<2x6h2x")
SCALE = np.array([0.01] * 3 + [0.001] * 3)
FIRST_S = 2.0


def crc_modbus(data: bytes) -> int:
    """CRC-16/MODBUS."""
    return crc_of(data, 0xA001, 0)


class RobotiqFt300(ForceSensor):
    """Reads every frame.

    Args:
        port: the device, as `/dev/ttyUSB0`.
        clock: monotonic, s.
    """

    def __init__(self, port: Path, *, clock: Callable[[], float] = time.monotonic) -> None:
        self.name = f"Robotiq FT 300 ({port})"
        self.tally = Tally()
        self._port, self._clock = port, clock
        self._line: SerialLine | None = None
        self._first: list[Reading] = []

    def __enter__(self) -> Self:
        self.tally = Tally()
        self._frames = FrameReader(HEADER, LENGTH, crc_modbus, self.tally, begin=0)
        self._last_s = -np.inf
        self._line = SerialLine(self._port, BAUD, self.name)
        request = struct.pack(">BBHHBH", SLAVE, WRITE_REGISTERS, STREAM_REGISTER, 1, 2, STREAM)
        until = self._clock() + FIRST_S
        self._line.write(request + crc_modbus(request).to_bytes(2, "little"))
        while not self._first and self._clock() < until:
            self._first = self.read(0.1)
        if not self._first:
            self._close()
            raise NotConnected("sensors-no-frames", sensor=self.name, seconds=FIRST_S)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self._close()

    def read(self, wait_s: float = 0.0) -> list[Reading]:
        """The frames that have come since; of several at once the last one came now, the others a period apart before it."""
        found, self._first = self._first, []
        assert self._line is not None
        frames = self._frames.cut(self._line.read(0.0 if found else wait_s))
        now = self._clock()
        for before, frame in zip(range(len(frames) - 1, -1, -1), frames, strict=True):
            stamp_s = now - before * PERIOD_S
            if stamp_s <= self._last_s:
                stamp_s = 0.5 * (self._last_s + now)
            self.tally.received += 1
            self._last_s = stamp_s
            found.append(Reading(stamp_s, stamp_s, np.array(DATA.unpack(frame)) * SCALE))
        return found

    def remarks(self) -> list[Message]:
        """That its samples have no clock."""
        return [Message.of("sensors-no-stamps", sensor=self.name)]

    def _close(self) -> None:
        if self._line is not None:
            self._line.write(b"\xff" * 50)
            self._line.close()
            self._line = None
