"""A service with the built console and the cells at hand, whose lease a browser keeps that draws without a graphics card on two cores
which it shares with the service, the robot and other tests. A tablet has a processor of its own; what a run does when its lease ends is
the same for every length."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from core.cell.cell import CELL_FILE
from core.cell.folder import list_cell_folders
from tests.server.real_service import ROOT, RealService, real_service

LEASE_S = 3.0


def patient_cells(data: Path) -> None:
    """Puts them into the data folder of a service that is to be started."""
    for cell in list_cell_folders():
        shutil.copytree(cell, data / "cells" / cell.name)
        with (data / "cells" / cell.name / CELL_FILE).open("a") as file:
            file.write(f"\n[control]\nlease_s = {LEASE_S}\n")


@contextmanager
def console_service(folder: Path) -> Iterator[RealService]:
    """`heft serve` in an empty folder with the console that `make web/dist/index.html` has built."""
    assert (ROOT / "web" / "dist" / "index.html").is_file(), "the console has not been built: make web/dist/index.html"
    patient_cells(folder / "data")
    with real_service(folder) as running:
        yield running
