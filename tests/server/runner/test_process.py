"""The server's end of a control process: the server never waits for the process to be there."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any

import pytest

from server.runner import process
from server.runner.messages import End, Failed, Paced
from server.runner.process import ControlProcess
from tests.server.sentence import sentence


class Made:
    """In place of a process that is started."""

    exitcode: int | None = None

    def kill(self) -> None:
        self.exitcode = -9

    def join(self) -> None:
        self.exitcode = self.exitcode or 0


class Order:
    run = "01"


def starting(monkeypatch: pytest.MonkeyPatch, begin: Callable[[Connection], Made]) -> None:
    monkeypatch.setattr(process, "start_process", lambda _module, _order, theirs, **_named: begin(theirs))


async def heard(control: ControlProcess) -> list[Any]:
    return [message async for message in control.messages()]


def test_what_a_process_is_told_before_it_is_there_reaches_it(monkeypatch: pytest.MonkeyPatch) -> None:
    there, told = threading.Event(), []

    def begin(theirs: Connection) -> Made:
        assert there.wait(30)
        told.append(theirs.recv())
        theirs.send(Paced(1, 0, 0.0, 0.0))
        return Made()

    async def run() -> list[Any]:
        control = ControlProcess(Order())  # type: ignore[arg-type]  # only its name is read
        control.tell(End(sentence("enough")))
        there.set()
        return await heard(control)

    starting(monkeypatch, begin)
    assert asyncio.run(run()) == [Paced(1, 0, 0.0, 0.0)]
    assert told == [End(sentence("enough"))]


def test_one_that_is_killed_before_it_is_there_is_killed_when_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    there = threading.Event()

    def begin(theirs: Connection) -> Made:
        assert there.wait(30)
        return Made()

    async def run() -> list[Any]:
        control = ControlProcess(Order())  # type: ignore[arg-type]  # only its name is read
        control.kill()
        there.set()
        return await heard(control)

    starting(monkeypatch, begin)
    [last] = asyncio.run(run())
    assert isinstance(last, Failed)
    assert "code -9" in str(last.message)


def test_one_that_cannot_be_started_is_lost(monkeypatch: pytest.MonkeyPatch) -> None:
    def begin(_theirs: Connection) -> Made:
        raise OSError(11, "no more processes")

    async def run() -> list[Any]:
        return await heard(ControlProcess(Order()))  # type: ignore[arg-type]  # only its name is read

    starting(monkeypatch, begin)
    [last] = asyncio.run(run())
    assert isinstance(last, Failed)
    assert last.error == "ControlProcessLost"
