"""Sensors at the end of a serial line, played on a pseudo terminal from what is published of their frames; nothing of the drivers is used.

Check sums are those of `binascii` and a table made here, and the recorded request of the maker's manual is a test of its own.
"""

from __future__ import annotations

import os
import random
import select
import struct
import threading
import time
import tty
from collections.abc import Callable, Sequence
from pathlib import Path
from types import TracebackType
from typing import Self

START_STREAM = bytes.fromhex("0910019a0001020200cdca")
"""Robotiq, FT 300 manual: 512 into register 410 of slave 9."""


def make_reflected_table(polynomial: int) -> list[int]:
    table = []
    for byte in range(256):
        value = byte
        for _ in range(8):
            value = (value >> 1) ^ polynomial if value & 1 else value >> 1
        table.append(value)
    return table


MODBUS, X25 = make_reflected_table(0xA001), make_reflected_table(0x8408)


def check_sum(data: bytes, table: list[int]) -> int:
    value = 0xFFFF
    for byte in data:
        value = table[(value ^ byte) & 0xFF] ^ (value >> 8)
    return value


def modbus_sum(data: bytes) -> bytes:
    return struct.pack("<H", check_sum(data, MODBUS))


def x25_sum(data: bytes) -> bytes:
    return struct.pack("<H", check_sum(data, X25) ^ 0xFFFF)


class SerialSensor:
    """Sends a frame every period, once it may.

    Args:
        frame: the bytes for a time since the entry, s.
        on_request: begins with this request and ends with bytes 0xFF; at once where None.
        spoilt, lost: shares of frames with one byte changed, and of those that are not sent.
    """

    def __init__(
        self,
        frame: Callable[[float], bytes],
        *,
        rate_hz: float,
        on_request: bytes | None = None,
        spoilt: float = 0.0,
        lost: float = 0.0,
        seed: int = 0,
    ) -> None:
        self._frame, self._period, self._request = frame, 1.0 / rate_hz, on_request
        self._spoilt, self._lost, self._random = spoilt, lost, random.Random(seed)
        self._here, there = os.openpty()
        tty.setraw(there)
        self.port = Path(os.ttyname(there))
        self._there = there
        self.heard = b""
        self.sent = self.left_out = self.broken = 0
        self._end = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self._end.set()
        self._thread.join()
        os.close(self._here)
        os.close(self._there)

    def _run(self) -> None:
        zero, count = time.monotonic(), 0
        streams = self._request is None
        if streams:
            os.write(self._here, self._frame(0.0)[-5:])  # somebody who connects hears the end of a frame first
        while not self._end.is_set():
            if select.select([self._here], [], [], 0.0)[0]:
                self.heard += os.read(self._here, 4096)
            if self._request is not None:
                streams = self._request in self.heard and not self.heard.endswith(b"\xff" * 20)
            while streams and (count + 1) * self._period <= time.monotonic() - zero:
                count += 1
                self._send(self._frame(count * self._period))
            time.sleep(0.0005)

    def _send(self, frame: bytes) -> None:
        if self._random.random() < self._lost:
            self.left_out += 1
            return
        if self._random.random() < self._spoilt:
            at = self._random.randrange(2, len(frame))
            frame = frame[:at] + bytes([frame[at] ^ 0x10]) + frame[at + 1 :]
            self.broken += 1
        if select.select([], [self._here], [], 0.0)[1]:
            os.write(self._here, frame)
            self.sent += 1


def bota_frame(
    wrench: Callable[[float], Sequence[float]], status: Callable[[float], int] = lambda _: 0, first_us: int = 0
) -> Callable[[float], bytes]:
    def frame(t: float) -> bytes:
        data = struct.pack("<H", status(t)) + struct.pack("<6f", *wrench(t))
        data += struct.pack("<If", (first_us + round(1e6 * t)) % 2**32, 31.5)
        return b"\xaa" + data + x25_sum(data)

    return frame


def robotiq_frame(wrench: Callable[[float], Sequence[float]]) -> Callable[[float], bytes]:
    def frame(t: float) -> bytes:
        fx, fy, fz, tx, ty, tz = wrench(t)
        data = b"\x20\x4e" + struct.pack("<6h", *(round(100 * f) for f in (fx, fy, fz)), *(round(1000 * m) for m in (tx, ty, tz)))
        return data + modbus_sum(data)

    return frame
