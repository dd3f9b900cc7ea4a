"""The private TCP protocol of UFACTORY controllers, and what they report by themselves.

Requests and answers (port 502): transaction, protocol and length as big-endian u16, then the register and its data; an answer has a status
byte in between. Numbers are little-endian single precision. Written from the maker's public manual of the protocol, its description of the
report ports, and, where both are silent, what its published client asks for.
"""

from __future__ import annotations

import struct
from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.fakes.xarm_arm import RESET, STOPPED, XarmArm

PROTOCOLS = (2, 3)
"""The private protocol, without and with a sign of life that is waited for."""
INVALID, NOT_READY, WARNED, FAILED = 0x08, 0x10, 0x20, 0x40
"""Bits of the status byte."""
NO_SUCH_REGISTER = 13
"""Warning code."""
MM = 1000.0


def floats(values: Array | list[float] | tuple[float, ...], count: int = 0) -> bytes:
    """Single precision, filled up with zeros to `count` numbers."""
    numbers = [*map(float, values)]
    numbers += [0.0] * (count - len(numbers))
    return struct.pack(f"<{len(numbers)}f", *numbers)


def read_floats(body: bytes, count: int) -> Array:
    """The first `count` numbers of a body.

    Raises:
        struct.error: it is shorter.
    """
    return np.array(struct.unpack_from(f"<{count}f", body))


class XarmPeer:
    """One client on the control port: takes bytes, gives answers."""

    def __init__(self, arm: XarmArm) -> None:
        self._arm, self._rest = arm, b""
        self.served = 0
        """Servo commands so far."""
        self.asked = 0
        """Questions for errors so far: what a client sends that has nothing to command."""
        self._registers: dict[int, Callable[[bytes], bytes]] = {
            1: lambda _: self._text(f"{arm.n},{arm.type},{arm.serial[:6]},{arm.box_serial[:6]},{arm.version}"),
            2: lambda _: self._text(f"{arm.serial}\0{arm.box_serial}"),
            11: lambda body: self._do(arm.enable, bool(body[1])),
            12: lambda body: self._do(arm.set_state, body[0]),
            13: lambda _: bytes([arm.state]),
            14: lambda _: struct.pack(">H", 0),
            15: lambda _: self._tell_errors(),
            16: lambda _: self._clear(error=True),
            17: lambda _: self._clear(error=False),
            19: lambda body: self._do(arm.set_mode, body[0]),
            29: self._servo,
            36: self._set_load,
            41: lambda _: _pose(*_tool(arm, _joints(arm)), turn="xyz"),
            42: self._tell_joints,
            44: lambda body: _pose(*_tool(arm, read_floats(body, arm.n)), turn="xyz"),
            45: lambda body: bytes([arm.is_beyond(read_floats(body, arm.n))]),
            91: lambda _: _pose(*_tool(arm, _joints(arm)), turn="vector"),
            200: lambda body: floats(arm.raw_force() if body[:1] == b"\x01" else arm.external_force()),
            201: self._switch_sensor,
            202: self._set_sensor_mode,
            203: lambda _: bytes([arm.sensor_mode]),
            206: lambda _: self._do(arm.set_sensor_zero),
            212: lambda _: self._tell_sensor(),
            254: lambda _: b"",
        }

    def take(self, data: bytes) -> bytes:
        """Answers to every request that is complete.

        Raises:
            ValueError: this is another protocol.
        """
        self._rest += data
        answers = b""
        while len(self._rest) >= 7:
            transaction, protocol, length = struct.unpack_from(">3H", self._rest)
            if protocol not in PROTOCOLS or not 1 <= length <= 1024:
                raise ValueError("not the private protocol")
            if len(self._rest) < 6 + length:
                break
            register, body = self._rest[6], self._rest[7 : 6 + length]
            self._rest = self._rest[6 + length :]
            status, told = self._answer(register, body)
            answers += struct.pack(">3HBB", transaction, protocol, 2 + len(told), register, status) + told
        return answers

    def _answer(self, register: int, body: bytes) -> tuple[int, bytes]:
        known = self._registers.get(register)
        status = 0
        told = b""
        try:
            if known is None:
                self._arm.warning = NO_SUCH_REGISTER
            else:
                told = known(body)
        except (struct.error, IndexError, ValueError):
            status |= INVALID
        arm = self._arm
        status |= FAILED * (arm.error != 0) | WARNED * (arm.warning != 0) | NOT_READY * (arm.state in {STOPPED, RESET})
        return status, told

    @staticmethod
    def _do(what: Callable[..., None], *given: int) -> bytes:
        what(*given)
        return b""

    @staticmethod
    def _text(said: str) -> bytes:
        return said.encode().ljust(40, b"\0")

    def _clear(self, *, error: bool) -> bytes:
        if error:
            self._arm.error = 0
        else:
            self._arm.warning = 0
        return b""

    def _tell_errors(self) -> bytes:
        self.asked += 1
        return bytes([self._arm.error, self._arm.warning])

    def _servo(self, body: bytes) -> bytes:
        self._arm.servo(read_floats(body, 10)[: self._arm.n])
        self.served += 1
        return struct.pack(">H", 0)

    def _set_load(self, body: bytes) -> bytes:
        mass, *com = read_floats(body, 4)
        self._arm.set_load(float(mass), np.array(com) / MM)
        return struct.pack(">H", 0)

    def _tell_joints(self, body: bytes) -> bytes:
        sample = self._arm.samples[-1]
        told = (sample.q, sample.dq, sample.tau)[: body[0] & 0x0F] if body else (sample.q,)
        return b"".join(floats(values[self._arm.order], 7) for values in told)

    def _switch_sensor(self, body: bytes) -> bytes:
        self._arm.sensor_on = bool(body[0])
        return b""

    def _set_sensor_mode(self, body: bytes) -> bytes:
        self._arm.sensor_mode = body[0]
        return b""

    def _tell_sensor(self) -> bytes:
        arm = self._arm
        told = struct.pack(">4BH", arm.sensor_mode, arm.sensor_on, 0, 8, round(1.0 / arm.period))
        return (told + floats([0.0] * 5) + floats(arm.sensor_zero)).ljust(280, b"\0")


def fast_report(arm: XarmArm) -> bytes:
    """Port 30000, every period."""
    sample, order = arm.samples[-1], arm.order
    zero = np.zeros(arm.n)
    before = arm.samples[-2].dq if len(arm.samples) > 1 else sample.dq
    acceleration = (sample.dq - before) / 0.001
    joints = (arm.target, (arm.target - arm.last) / arm.period, zero, sample.q, sample.dq, acceleration, zero, sample.tau)
    told = struct.pack(">QBH", round(arm.t * 1e6), arm.state | arm.mode << 4, 0) + bytes(17)
    told += b"".join(floats(values[order], 7) for values in joints) + bytes(168)
    told += _pose(*_tool(arm, arm.target[order]), turn="vector") + bytes(24)
    told += _pose(*_tool(arm, sample.q[order]), turn="vector") + bytes(24 + 24 + 144)
    return _count(told + floats(arm.raw_force()) + floats(arm.external_force()) + bytes(48))


def short_report(arm: XarmArm) -> bytes:
    """Port 30003."""
    return _count(_short(arm) + floats(arm.external_force()) + floats(arm.raw_force()))


def normal_report(arm: XarmArm) -> bytes:
    """Port 30001."""
    return _count(_normal(arm))


def rich_report(arm: XarmArm) -> bytes:
    """Port 30002."""
    limits = [value for pair in zip(arm.lower, arm.upper, strict=True) for value in pair]
    told = _normal(arm) + bytes([arm.type, arm.n, 0, 0, 0, 0]) + arm.version.encode().ljust(30, b"\0")
    told += floats([2000.0, 1.0, 50000.0, 0.1, 1000.0, 20.0, 0.01, 20.0, 0.0001, arm.joint_speed, 2.3, 2.7]) + bytes(14 + 2)
    told += bytes([30] * 7) + floats([0.0]) + floats(((arm.target - arm.last) / arm.period)[arm.order], 7)
    told += struct.pack(">I", 0) + bytes(24 + 2) + bytes([arm.simulation, 1, 0]) + bytes(24 + 14 + 28 + 2 + 16 + 32)
    told += floats(arm.external_force()) + floats(arm.raw_force()) + bytes(1 + 12 + 1) + bytes([arm.reduced]) + bytes(12)
    told += floats([1000.0, arm.joint_speed]) + floats(limits, 14) + bytes(2 + 4) + bytes([arm.sensor_on]) + bytes(8)
    return _count(told)


def _count(told: bytes) -> bytes:
    return struct.pack(">I", 4 + len(told)) + told


def _short(arm: XarmArm) -> bytes:
    told = struct.pack(">BH", arm.state | arm.mode << 4, 0) + floats(_joints(arm), 7)
    return told + _pose(*_tool(arm, _joints(arm)), turn="xyz") + floats(arm.samples[-1].tau[arm.order], 7)


def _normal(arm: XarmArm) -> bytes:
    motors = (1 << arm.n) - 1 if arm.enabled else 0
    offset = [*(arm.tcp_offset[:3] * MM), *arm.tcp_offset[3:]]
    told = _short(arm) + bytes([motors, motors, arm.error, arm.warning]) + floats(offset)
    return told + floats([arm.payload, *(arm.payload_com * MM)]) + bytes([3, 3]) + floats([0.0, 0.0, -1.0])


def _joints(arm: XarmArm) -> Array:
    return arm.samples[-1].q[arm.order]


def _tool(arm: XarmArm, q: Array) -> tuple[Array, Array]:
    """Position, m, and rotation of the tool centre point."""
    position, rotation = arm.flange(q)
    return position + rotation @ arm.tcp_offset[:3], rotation @ Rotation.from_euler("xyz", arm.tcp_offset[3:]).as_matrix()


def _pose(position: Array, rotation: Array, *, turn: str) -> bytes:
    turned = Rotation.from_matrix(rotation)
    angles = turned.as_rotvec() if turn == "vector" else turned.as_euler("xyz")
    return floats([*(position * MM), *angles])
