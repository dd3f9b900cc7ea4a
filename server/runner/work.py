"""Work in a process of its own that gives way to every control loop: the server only hears what it says."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from typing import Any

from server.runner.context import CONTEXT, started
from server.runner.messages import Advanced, Failed, FromWork

NICENESS = 10


def said(module: str, *arguments: Any) -> Iterator[FromWork]:
    """What `main(*arguments, connection)` of a module says, up to its first word that is no `Advanced`. Closing the iterator ends the process."""
    connection, theirs = CONTEXT.Pipe(duplex=False)
    process = started(module, *arguments, theirs, name=f"heft-{module.rpartition('.')[2]}", daemon=True)
    theirs.close()
    try:
        while True:
            word: FromWork = connection.recv()
            yield word
            if not isinstance(word, Advanced):
                return
    except EOFError:
        yield Failed("WorkLost", "the process that did it ended unexpectedly; ask for it again. The service's log may know more.")
    finally:
        process.kill()
        process.join()
        connection.close()


def give_way() -> None:
    """At the beginning of such a process: its end is the server's to decide, and it is in nobody's way."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.nice(NICENESS)
