"""Work in a process of its own that gives way to every control loop: the server only hears what it says."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from typing import Any

from core.words.message import Message
from server.runner.context import CONTEXT, start_process
from server.runner.messages import Advanced, Failed, FromWork
from server.runner.priority import Priority, take


class Work:
    """A process that calls `main(*arguments, connection)` of a module."""

    def __init__(self, module: str, *arguments: Any) -> None:
        self._connection, theirs = CONTEXT.Pipe(duplex=False)
        self._process = start_process(module, *arguments, theirs, name=f"heft-{module.rpartition('.')[2]}", daemon=True)
        theirs.close()

    def words(self) -> Iterator[FromWork]:
        """What it says, up to the first word that is no `Advanced`; a `Failed` of our own where it died. Closing this ends the process."""
        try:
            while True:
                word: FromWork = self._connection.recv()
                yield word
                if not isinstance(word, Advanced):
                    return
        except EOFError:
            yield Failed("WorkLost", Message.of("jobs-work-lost"))
        finally:
            self.kill()
            self._process.join()
            self._connection.close()

    def kill(self) -> None:
        """Whatever it is at; from any thread."""
        self._process.kill()


def run_work(module: str, *arguments: Any) -> Iterator[FromWork]:
    """The words of such a process that nobody ends before it is done."""
    return Work(module, *arguments).words()


def give_way(priority: Priority = Priority.BACKGROUND) -> None:
    """At the beginning of such a process: its end is the server's to decide, and it is in nobody's way.

    Args:
        priority: a higher one where somebody waits for it on a page, as for a plan.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    take(priority)
