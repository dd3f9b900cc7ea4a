"""Many trials at once: one process per core, or the workers of a Dask cluster; each outcome as it comes."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import active_children, get_context
from pathlib import Path

from threadpoolctl import threadpool_limits

from core.errors import BadInput, HeftError
from core.trial.draw import DrawnTrial
from core.trial.outcome import TrialOutcome, make_stopped_outcome
from core.trial.run import run_trial
from core.words.message import Message

CONNECT_S = 10


@contextmanager
def on_cores(count: int) -> Iterator[Executor]:
    """Processes of this machine, which inherit the plans. When the run is interrupted they end at once, and what they were at is lost."""
    others = set(active_children())
    with ProcessPoolExecutor(count, mp_context=get_context("fork"), initializer=_alone) as pool:
        try:
            yield pool
        except BaseException:
            for child in set(active_children()) - others:
                child.terminate()
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _alone() -> None:
    """A worker keeps to its core, and leaves it to its parent to be interrupted."""
    threadpool_limits(1)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)


def cores() -> int:
    """How many this process may use."""
    return len(os.sched_getaffinity(0))


@contextmanager
def on_cluster(address: str) -> Iterator[Executor]:
    """The workers of a Dask cluster that runs already; Heft has to be installed on them in the same version.

    Args:
        address: of its scheduler, as in `tcp://10.0.0.5:8786`.

    Raises:
        BadInput: Dask is not installed, or nothing answers there.
    """
    try:
        from distributed import Client  # noqa: PLC0415 - an optional extra
    except ImportError:
        raise BadInput("--dask", "trial-dask-missing") from None
    try:
        client = Client(address, timeout=CONNECT_S)  # type: ignore[no-untyped-call]  # Dask ships few types
    except (OSError, ValueError) as error:
        raise BadInput(f"--dask {address}", "trial-no-scheduler", reason=str(error)) from None
    with client, client.get_executor() as executor:  # type: ignore[no-untyped-call]  # Dask ships few types
        yield executor


def outcomes(drawn: Sequence[DrawnTrial], executor: Executor, keep: Path | None = None) -> Iterator[TrialOutcome]:
    """Runs the trials and gives each outcome as soon as it is there, in whatever order. A trial that fails has an outcome that says why.

    Args:
        keep: see `run_trial`.

    Raises:
        BrokenProcessPool: a worker has been killed from outside, as for want of memory.
    """
    futures = {executor.submit(run_trial, one, keep): one.sealed for one in drawn}
    try:
        for future in as_completed(futures):
            error = future.exception()
            if isinstance(error, BrokenProcessPool):
                raise error
            yield future.result() if error is None else make_stopped_outcome(futures[future], _explain(error))
    finally:
        for future in futures:
            future.cancel()


def _explain(error: BaseException) -> Message:
    """Why a trial failed."""
    reason = error.message if isinstance(error, HeftError) else str(error)
    return Message.of("trial-failed", error=type(error).__name__, reason=reason)
