"""`heft` that waits as long for an answer as its robots do. Run with `python -m`."""

from __future__ import annotations

from unittest.mock import patch

from server import control_lease
from server.command_line import main
from server.runner import process
from tests.web import patient_robot

if __name__ == "__main__":
    process.CONTROL = patient_robot.__name__
    with patch.object(control_lease, "LEASE_S", patient_robot.PATIENT_S):
        main()
