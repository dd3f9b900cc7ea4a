"""The cells at hand, with a lease that a browser keeps which draws without a graphics card on two cores that it shares with the service,
the robot and other tests. A tablet has a processor of its own; what a run does when its lease ends is the same for every length."""

from __future__ import annotations

import shutil
from pathlib import Path

from core.cell import CELL_FILE, list_cells

LEASE_S = 3.0


def patient_cells(data: Path) -> None:
    """Puts them into the data folder of a service that is to be started."""
    for cell in list_cells():
        shutil.copytree(cell, data / "cells" / cell.name)
        with (data / "cells" / cell.name / CELL_FILE).open("a") as file:
            file.write(f"\n[control]\nlease_s = {LEASE_S}\n")
