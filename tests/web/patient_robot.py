"""A control process that waits longer for an answer of the screen in control.

A tablet has a processor of its own and answers within 220 ms; a browser that draws without a graphics card, on two cores that it shares
with the service, the robot and the tests, does not always. What happens after 220 ms is tested without a browser in `tests/server`, and
measured with one by `python -m bench.screen_latency`.
"""

from __future__ import annotations

from functools import partial
from multiprocessing.connection import Connection
from unittest.mock import patch

from core.sessions.leased import Lease
from server.runner import control
from server.runner.messages import Order

PATIENT_S = 3.0


def main(order: Order, connection: Connection) -> None:
    """As `server.runner.control.main`."""
    with patch.object(control, "Lease", partial(Lease, PATIENT_S)):
        control.main(order, connection)
