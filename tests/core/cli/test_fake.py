"""Servers to try a driver with, as the command starts them."""

from __future__ import annotations

import socket
import struct
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from core.array import Array
from core.cli import fake
from core.cli.main import app
from core.fakes.ati_server import AtiServer
from tests.synthetic import payload


def first_force(monkeypatch: pytest.MonkeyPatch, carried: str) -> Array:
    """(3,), N, of the first record that the box sends; the command ends then."""
    boxes: list[AtiServer] = []
    read: list[Array] = []

    def box(*given: Any, setup: Any, rdt_port: int, http_port: int) -> AtiServer:
        assert (rdt_port, http_port) == (49152, 8049)
        boxes.append(AtiServer(*given, setup=setup))  # on ports that are free
        return boxes[0]

    def ask(_: float) -> None:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
            client.settimeout(30.0)
            client.sendto(bytes.fromhex("1234 0002 00000001"), ("127.0.0.1", boxes[0].rdt_port))
            read.append(np.array(struct.unpack("!6i", client.recv(100)[12:])[:3]) / boxes[0].setup.per_force)
        raise KeyboardInterrupt

    monkeypatch.setattr(fake, "AtiServer", box)
    monkeypatch.setattr(fake, "time", SimpleNamespace(sleep=ask))
    said = CliRunner().invoke(app, ["fake", "ati", "lwr4_bench", "--payload", carried])
    assert said.exit_code == 0, said.output
    return read[0]


def test_a_kuka_sends_to_its_client_and_tells_what_it_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    heard: list[int] = []

    def listen(_: float) -> None:
        heard.append(len(client.recv(2048)))
        raise KeyboardInterrupt

    def box(*given: Any, setup: Any, rdt_port: int, http_port: int) -> AtiServer:
        assert (rdt_port, http_port) == (49152, 8049)
        return AtiServer(*given, setup=setup)  # on ports that are free

    monkeypatch.setattr(fake, "AtiServer", box)
    monkeypatch.setattr(fake, "time", SimpleNamespace(sleep=listen))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.settimeout(30.0)
        client.bind(("127.0.0.1", 0))
        port = str(client.getsockname()[1])
        said = CliRunner().invoke(app, ["fake", "kuka", "lwr4_bench", "--port", port, "--period", "10"], terminal_width=1000)
    assert said.exit_code == 0, said.output
    assert heard[0] > 300
    assert f"a KUKA LBR at 127.0.0.1 sends to 127.0.0.1, port {port}, every 10 ms" in said.output
    assert "0 periods under command" in said.output
    refused = CliRunner().invoke(app, ["fake", "kuka", "ur5e_line"])
    assert refused.exit_code != 0 and refused.exception is not None
    assert "6 joints" in str(refused.exception)


def test_a_box_alone_reports_the_weight_that_its_sensor_holds(monkeypatch: pytest.MonkeyPatch) -> None:
    block, cylinder = (first_force(monkeypatch, name) for name in ("steel_block", "cylinder"))
    between = abs(payload("steel_block").phi[0] - payload("cylinder").phi[0]) * 9.81
    assert between > 0.5
    assert np.linalg.norm(block - cylinder) == pytest.approx(between, abs=0.3)  # the offset is the same, the noise is not


def test_a_franka_tells_its_version_and_states_go_to_whoever_connects(monkeypatch: pytest.MonkeyPatch) -> None:
    host, heard = "127.28.1.44", list[int]()

    def connect(_: float) -> None:
        with socket.create_connection((host, 1337), timeout=30.0) as line, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as states:
            states.bind((line.getsockname()[0], 0))
            states.settimeout(30.0)
            line.sendall(struct.pack("<IIIHH", 0, 0, 16, 7, states.getsockname()[1]))
            assert line.recv(15, socket.MSG_WAITALL) == struct.pack("<IIIBH", 0, 0, 15, 0, 7)
            heard.append(len(states.recv(4096)))
        raise KeyboardInterrupt

    def box(*given: Any, setup: Any, rdt_port: int, http_port: int) -> AtiServer:
        assert (rdt_port, http_port) == (49152, 8049)
        return AtiServer(*given, setup=setup)  # on ports that are free

    monkeypatch.setattr(fake, "AtiServer", box)
    monkeypatch.setattr(fake, "time", SimpleNamespace(sleep=connect))
    options = ["fake", "franka", "lwr4_bench", "--host", host, "--server-version", "7"]
    said = CliRunner().invoke(app, options, terminal_width=1000)
    assert said.exit_code == 0, said.output
    assert heard == [2373]
    assert f"a fr3 at {host}, port 1337, server version 7" in said.output
    refused = CliRunner().invoke(app, ["fake", "franka", "ur5e_line"])
    assert refused.exit_code != 0 and "6 joints" in str(refused.exception)
