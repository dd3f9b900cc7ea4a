"""Work for the tests of jobs, as short as it can be."""

from __future__ import annotations

import os
import time
from multiprocessing.connection import Connection

from server.runner.messages import Advanced, Answered, Failed
from tests.server.sentence import sentence


def main(what: str, connection: Connection) -> None:
    """Does what it is told."""
    connection.send(Advanced(0.25))
    connection.send(Advanced(0.5, told='["sealed"]'))
    if what == "die":
        os._exit(3)
    if what == "wait":
        time.sleep(600)
    connection.send(Failed("BadRecording", sentence("a sentence")) if what == "fail" else Answered('"done"'))
