"""How processes are started: forked from a small server that has imported the engine already, so that a run begins at once.

That server has no threads and no state; it ends when the last of us that knows it has ended. The service itself never imports the engine:
a process is named by its module, which is imported where it runs.
"""

from __future__ import annotations

from importlib import import_module
from multiprocessing import forkserver, get_context
from multiprocessing.context import ForkServerProcess

CONTEXT = get_context("forkserver")
CONTEXT.set_forkserver_preload(["server.runner.preloaded"])


def warm_up() -> None:
    """Starts that server; the imports go on in the background."""
    forkserver.ensure_running()


def start_process(module: str, *arguments: object, name: str, daemon: bool = False) -> ForkServerProcess:
    """A process that calls `main(*arguments)` of a module."""
    process = CONTEXT.Process(target=_main_of, args=(module, *arguments), name=name, daemon=daemon)
    process.start()
    return process


def _main_of(module: str, *arguments: object) -> None:
    import_module(module).main(*arguments)
