"""A process that is forked finds the engine imported and its compiled kinematics loaded."""

from __future__ import annotations

import sys
from multiprocessing.connection import Connection

from server.runner.context import CONTEXT, start_process


def main(connection: Connection) -> None:
    """What was there when the process began."""
    imported = "core.procedure.run" in sys.modules
    loaded = 0
    if "core.robot.chain" in sys.modules:
        chain = sys.modules["core.robot.chain"]
        loaded = sum(len(each.signatures) for each in (chain._forward, chain._jacobian, chain._forward_many, chain._jacobian_many))
    connection.send((imported, loaded))


def test_engine_and_kinematics_are_there_when_a_process_begins() -> None:
    ours, theirs = CONTEXT.Pipe(duplex=False)
    process = start_process(__name__, theirs, name="heft-preloaded")
    theirs.close()
    assert ours.recv() == (True, 4)
    process.join()
