"""RTDE, protocol version 2, as a controller speaks it, from its public description."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from typing import cast

import numpy as np

OUTPUT_TYPES = {
    "timestamp": "DOUBLE",
    "target_q": "VECTOR6D",
    "target_qd": "VECTOR6D",
    "actual_q": "VECTOR6D",
    "actual_qd": "VECTOR6D",
    "actual_TCP_pose": "VECTOR6D",
    "tcp_offset": "VECTOR6D",
    "ft_raw_wrench": "VECTOR6D",
    "robot_mode": "INT32",
    "safety_mode": "INT32",
    "runtime_state": "UINT32",
    "speed_scaling": "DOUBLE",
    "payload": "DOUBLE",
    "payload_cog": "VECTOR3D",
    "payload_inertia": "VECTOR6D",
    **{f"output_int_register_{k}": "INT32" for k in range(48)},
    **{f"output_double_register_{k}": "DOUBLE" for k in range(48)},
}
INPUT_TYPES = {
    **{f"input_int_register_{k}": "INT32" for k in range(48)},
    **{f"input_double_register_{k}": "DOUBLE" for k in range(48)},
}
LETTERS = {"DOUBLE": "d", "INT32": "i", "UINT32": "I", "VECTOR3D": "ddd", "VECTOR6D": "dddddd"}
MOST_BYTES = 4096


class RtdePeer:
    """What one client of the controller has agreed on with it.

    Args:
        version: of the controller.
        taken: input fields that other clients write.
    """

    def __init__(self, version: tuple[int, int, int, int], taken: set[str]) -> None:
        self.version, self.taken = version, taken
        self.received = b""
        self.outputs: list[str] = []
        self.inputs: dict[int, list[str]] = {}
        self.every = 1
        self.started = False

    def take(self, data: bytes) -> tuple[bytes, list[tuple[str, float]]]:
        """What the controller answers to these bytes, and which registers they write.

        Raises:
            ValueError: no client that keeps to the protocol sends them.
        """
        self.received += data
        answer, written = b"", list[tuple[str, float]]()
        while len(self.received) >= 3:
            (size,) = struct.unpack(">H", self.received[:2])
            if size < 3 or size > MOST_BYTES:
                raise ValueError(size)
            if len(self.received) < size:
                break
            kind, body = chr(self.received[2]), self.received[3:size]
            self.received = self.received[size:]
            if kind == "U":
                written += self._inputs_of(body)
            else:
                reply = self._answer(kind, body)
                answer += struct.pack(">HB", 3 + len(reply), ord(kind)) + reply
        return answer, written

    def package(self, values: Mapping[str, object]) -> bytes:
        """A data package with what this client has asked for."""
        body = b"\x01"
        for name in self.outputs:
            letters = LETTERS[OUTPUT_TYPES[name]]
            numbers = np.atleast_1d(cast("float", values.get(name, 0))).tolist()
            body += struct.pack(">" + letters, *(int(x) if letters in "iI" else x for x in numbers))
        return struct.pack(">HB", 3 + len(body), ord("U")) + body

    def _answer(self, kind: str, body: bytes) -> bytes:
        if kind == "V":
            return b"\x01" if struct.unpack(">H", body)[0] == 2 else b"\x00"
        if kind == "v":
            return struct.pack(">4I", *self.version)
        if kind == "O":
            (rate,) = struct.unpack(">d", body[:8])
            self.every = max(1, round(500.0 / rate))
            return self._set_up_outputs(body[8:].decode("ascii").rstrip(",").split(","))
        if kind == "I":
            return self._set_up_inputs(body.decode("ascii").rstrip(",").split(","))
        if kind in "SP":
            self.started = kind == "S"
            return b"\x01"
        raise ValueError(kind)

    def _set_up_outputs(self, names: list[str]) -> bytes:
        types = [OUTPUT_TYPES.get(name, "NOT_FOUND") for name in names]
        if "NOT_FOUND" not in types:
            self.outputs = names
        return b"\x01" + ",".join(types).encode()

    def _set_up_inputs(self, names: list[str]) -> bytes:
        types = ["IN_USE" if name in self.taken else INPUT_TYPES.get(name, "NOT_FOUND") for name in names]
        if {"IN_USE", "NOT_FOUND"} & set(types):
            return b"\x00" + ",".join(types).encode()
        number = len(self.inputs) + 1
        self.inputs[number] = names
        return bytes([number]) + ",".join(types).encode()

    def _inputs_of(self, body: bytes) -> list[tuple[str, float]]:
        names = self.inputs.get(body[0])
        if names is None:
            raise ValueError(body[0])
        letters = "".join(LETTERS[INPUT_TYPES[name]] for name in names)
        return list(zip(names, struct.unpack(">" + letters, body[1:]), strict=True))
