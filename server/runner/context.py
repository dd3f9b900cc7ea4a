"""How processes are started: forked from a small server that has imported the engine already, so that a run begins at once.

That server has no threads and no state; it ends when the last of us that knows it has ended.
"""

from __future__ import annotations

from multiprocessing import forkserver, get_context

CONTEXT = get_context("forkserver")
CONTEXT.set_forkserver_preload(["server.runner.control"])


def warm_up() -> None:
    """Starts that server; the imports go on in the background."""
    forkserver.ensure_running()
