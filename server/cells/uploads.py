"""Takes uploaded cells in: has them checked by the process `server.cells.check`, and puts those that hold into their place."""

from __future__ import annotations

import json
import os
import secrets
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from threading import Lock
from typing import Annotated, Any

from core.errors import HeftError
from server.cells.archive import CELL
from server.cells.folder import NEW, CellFolder
from server.http.dependencies import depend_on
from server.http.errors import Unprocessable
from server.http.flaws import raise_refused
from server.people import audit
from server.store.store import Store
from server.telemetry.metrics import Metrics

ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


@dataclass
class CellChecker:
    """The checking process; begun when it is first needed or by `start`, and again should it have died."""

    _process: subprocess.Popen[str] | None = None
    _busy: Lock = field(default_factory=Lock)

    def start(self) -> None:
        """Begins the process, so that the first upload need not wait for it."""
        with self._busy:
            self._begin()

    def close(self) -> None:
        """Ends it."""
        with self._busy:
            if self._process is not None:
                self._process.kill()  # between two checks it holds nothing
                self._process.communicate()
                self._process = None

    def check(self, folder: Path) -> str:
        """Has the upload in the folder unpacked and loaded.

        Returns:
            The cell's name.

        Raises:
            BadInput: of the kind that the check found.
        """
        with self._busy:
            answer = self._ask(folder)
        raise_refused(answer)
        return str(answer["name"])

    def _begin(self) -> subprocess.Popen[str]:
        if self._process is None or self._process.poll() is not None:
            self._process = subprocess.Popen(
                [sys.executable, "-m", "server.cells.check"],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
                env=os.environ | ONE_THREAD,
                cwd=Path(__file__).parents[2],
            )
        return self._process

    def _ask(self, folder: Path) -> dict[str, Any]:
        process = self._begin()
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(f"{folder}\n")
        process.stdin.flush()
        line = process.stdout.readline()
        if not line:
            process.wait(timeout=10)
            raise Unprocessable("uploads-checker-ended")
        answer: dict[str, Any] = json.loads(line)
        return answer


@contextmanager
def upload_folder(cells: CellFolder) -> Iterator[Path]:
    """A folder beside the cells for one upload; nothing of it stays."""
    folder = cells.folder.resolve() / f"{NEW}{secrets.token_hex(8)}"
    folder.mkdir()
    try:
        yield folder
    finally:
        shutil.rmtree(folder)


def take_in(checker: CellChecker, cells: CellFolder, folder: Path, *, name: str | None) -> str:
    """Checks the upload in a folder and puts the cell into its place.

    Args:
        name: of the cell that it replaces; None for a new cell.

    Raises:
        BadInput: the cell cannot be used.
        Unprocessable: it has another name than the one it is to replace.
        Conflict: there is one of that name already.
    """
    found = checker.check(folder)
    if name is not None and found != name:
        raise Unprocessable("uploads-other-cell", cell=found, name=name)
    cells.install(folder / CELL, found, replace=name is not None)
    return found


def import_cell(
    store: Store, cells: CellFolder, metrics: Metrics, checker: CellChecker, folder: Path, name: str | None, who: str, now: datetime
) -> tuple[str, str]:
    """`take_in`, counted and written down; the cell's name, and the SHA-256 of its files.

    Args:
        name: of the cell that it replaces; None for a new cell.

    Raises:
        BadInput, Unprocessable, Conflict: as `take_in`.
    """
    counted = metrics.cells_checked.labels
    try:
        found = take_in(checker, cells, folder, name=name)
    except HeftError:
        counted("refused").inc()
        raise
    counted("taken in").inc()
    sha256 = cells.digest(found)
    with store.write() as db:
        audit.record(db, who, "cell.create" if name is None else "cell.replace", {"cell": found, "sha256": sha256}, now=now)
    return found, sha256


CheckerDep = Annotated[CellChecker, depend_on("checker")]
