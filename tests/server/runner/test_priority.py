"""A control loop comes first while the robot moves, and what it begins meanwhile does not."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
import threading

import pytest

from server.runner.priority import REAL_TIME, begin_real_time, end_real_time


def policy() -> tuple[int, int]:
    """Of the calling thread, with its real-time priority."""
    return os.sched_getscheduler(0) & ~os.SCHED_RESET_ON_FORK, os.sched_getparam(0).sched_priority


def in_a_thread(ask: object) -> list[object]:
    """What a thread of its own answers, so that the test's own keeps what it has."""
    told: list[object] = []

    def run() -> None:
        assert callable(ask)
        told.append(ask())

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    return told


def try_it() -> bool:
    """Whether this process has the permission."""
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))
    except OSError:
        return False
    return True


@pytest.mark.skipif(in_a_thread(try_it) == [False], reason="this process may not")
def test_a_thread_comes_first_and_those_that_it_begins_do_not() -> None:
    def ask() -> object:
        begin_real_time()
        during, below = policy(), in_a_thread(policy)
        end_real_time()
        return during, below, policy()

    usual = (os.SCHED_OTHER, 0)
    assert in_a_thread(ask) == [((os.SCHED_FIFO, REAL_TIME), [usual], usual)]
    assert policy() == usual


GIVEN_BACK_BY_NOBODY = """
import os
from server.runner.priority import begin_real_time, end_real_time
begin_real_time()
print(os.sched_getscheduler(0) & ~os.SCHED_RESET_ON_FORK)
os.setuid(65534)
end_real_time()
print(os.sched_getscheduler(0) & ~os.SCHED_RESET_ON_FORK)
"""


@pytest.mark.skipif(os.geteuid() != 0 or in_a_thread(try_it) == [False], reason="only root can lose the permission meanwhile")
def test_it_is_given_back_without_the_permission_to_have_more() -> None:
    """As where a limit of the system allows real-time priority and nothing else."""
    said = subprocess.run([sys.executable, "-c", GIVEN_BACK_BY_NOBODY], capture_output=True, text=True, check=True).stdout
    assert said.split() == [str(os.SCHED_FIFO), str(os.SCHED_OTHER)]


@pytest.mark.parametrize("error", [PermissionError(errno.EPERM, ""), OSError(errno.ENOSYS, "")])
def test_without_the_permission_everything_runs_as_usual(error: OSError, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise error

    monkeypatch.setattr(os, "sched_setscheduler", refuse)
    begin_real_time()
    end_real_time()
    assert policy() == (os.SCHED_OTHER, 0)
