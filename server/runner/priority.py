"""Who gets the processor first on a computer that is busy with other things, too.

More than the usual needs a permission (root, CAP_SYS_NICE, or `LimitNICE=-10` of a systemd unit); without it everything runs as usual.
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
