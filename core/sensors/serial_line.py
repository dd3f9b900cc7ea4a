"""A serial line to a sensor that sends frames: a header, a fixed length, a check sum at the end."""

from __future__ import annotations

import contextlib
import os
import select
from collections.abc import Callable
from pathlib import Path

from core.errors import NotConnected
from core.sensors.sequence import Tally


class SerialLine:
    """Eight bits, no parity, one stop bit, nothing translated.

    Args:
        port: the device, as `/dev/ttyUSB0`.
        sensor: for messages.

    Raises:
        NotConnected: it is not there, is no serial line, or may not be used.
    """

    def __init__(self, port: Path, baud: int, sensor: str) -> None:
        self._file = -1
        try:
            self._file = os.open(port, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
            self._set_up(baud)
        except (OSError, ImportError, AttributeError) as error:
            self.close()
            raise NotConnected("sensors-no-line", sensor=sensor, reason=str(error)[:100]) from error

    def _set_up(self, baud: int) -> None:
        import termios  # noqa: PLC0415 - not on every system; there the line is refused in words

        try:
            mode = termios.tcgetattr(self._file)
            speed = getattr(termios, f"B{baud}")
            mode[:2] = 0, 0
            mode[2] = termios.CS8 | termios.CREAD | termios.CLOCAL
            mode[3:6] = 0, speed, speed
            termios.tcsetattr(self._file, termios.TCSANOW, mode)
            termios.tcflush(self._file, termios.TCIFLUSH)
        except termios.error as error:
            raise OSError(str(error)) from error

    def read(self, wait_s: float) -> bytes:
        """What has come; waits for it for `wait_s` at most. Nothing where the line is gone."""
        with contextlib.suppress(OSError):
            if select.select([self._file], [], [], max(0.0, wait_s))[0]:
                return os.read(self._file, 65536)
        return b""

    def write(self, data: bytes) -> None:
        """Sends all of it, as far as the line takes it."""
        with contextlib.suppress(OSError):
            os.write(self._file, data)

    def close(self) -> None:
        """Lets the line go."""
        if self._file >= 0:
            os.close(self._file)
            self._file = -1


class FrameReader:
    """Cuts frames out of what comes; what is none is passed over and counted once for each place where it begins.

    Args:
        header: a frame's first bytes. length: of a frame, with header and check sum.
        check: the sum of what stands between header and check sum, or of both, as the sensor has it; little-endian in the last two bytes.
        begin: where the sum begins.
    """

    def __init__(self, header: bytes, length: int, check: Callable[[bytes], int], tally: Tally, *, begin: int) -> None:
        self._header, self._length, self._check, self._tally, self._begin = header, length, check, tally, begin
        self._left = b""
        self._found_one = False

    def cut(self, data: bytes) -> list[bytes]:
        """The whole frames that are there now."""
        self._left += data
        found: list[bytes] = []
        passed_over = False
        while len(self._left) >= self._length:
            frame = self._left[: self._length]
            good = frame.startswith(self._header) and self._check(frame[self._begin : -2]) == int.from_bytes(frame[-2:], "little")
            if good:
                found.append(frame)
                self._left = self._left[self._length :]
            else:
                at = self._left.find(self._header, 1)
                self._left = self._left[at:] if at > 0 else self._left[-1:]
                self._tally.malformed += self._found_one and not passed_over  # the first frame is seldom caught at its beginning
            passed_over = not good
            self._found_one = self._found_one or good
        return found


def crc_of(data: bytes, polynomial: int, last: int) -> int:
    """CRC of 16 bits, least significant bit first, from 0xFFFF; `last` is added (XOR) at the end."""
    crc = 0xFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (polynomial if crc & 1 else 0)
    return crc ^ last
