"""Who gets the processor first on a computer that is busy with other things, too.

More than the usual needs a permission (root, CAP_SYS_NICE, or `LimitNICE=-10` and `LimitRTPRIO=10` of a systemd unit); without it
everything runs as usual.
"""

from __future__ import annotations

import os
from contextlib import suppress
from enum import IntEnum


class Priority(IntEnum):
    """As `nice` counts: the lower, the sooner."""

    CONTROL = -10
    SERVICE = -5
    PLANNING = 0
    VIEWER = 5
    BACKGROUND = 10


def take(priority: Priority) -> None:
    """Of this process, and of those that it begins from now on."""
    now = os.getpriority(os.PRIO_PROCESS, 0)
    wanted = min(now, priority) if priority < 0 else max(now, priority)  # who was given more by somebody keeps it
    with suppress(PermissionError):
        os.setpriority(os.PRIO_PROCESS, 0, wanted)


REAL_TIME = 10
"""Above every process that has no such priority. `nice` gives a larger share and promises nothing about when: beside two browsers that draw
without a graphics card a thread at -10 waits up to 0.6 s for its turn, one at this priority none that can be seen."""


def begin_real_time() -> None:
    """This thread comes first until `end_real_time`. It has to sleep between its samples, or nothing else runs on its core; threads and
    processes that it begins meanwhile are not so."""
    with suppress(OSError):  # not permitted, or a kernel that has none
        os.sched_setscheduler(0, os.SCHED_FIFO | os.SCHED_RESET_ON_FORK, os.sched_param(REAL_TIME))


def end_real_time() -> None:
    """This thread has its `Priority` again."""
    with suppress(OSError):  # nothing to give back
        os.sched_setscheduler(0, os.SCHED_OTHER | os.SCHED_RESET_ON_FORK, os.sched_param(0))  # only root may take the flag away again
