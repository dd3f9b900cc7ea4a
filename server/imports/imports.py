"""Logs that are being imported: each a folder in the data folder, gone when a recording has been made of it, when it is left, or old."""

from __future__ import annotations

import asyncio
import secrets
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from pathlib import Path
from typing import Annotated

from core.estimation.result import Result
from core.words.catalogue import LANGUAGES
from server.http.dependencies import depend_on
from server.http.draft_folders import DraftFolder, DraftFolders
from server.http.errors import Conflict, NotFound
from server.imports.sent_file import SentFile
from server.runner.log_folder import LOGS, RECORDING, WORK, locate_report
from server.runner.log_schemas import LogReading
from server.settings import Settings

LASTS = timedelta(hours=2)
"""How long one is kept that nobody asks for."""
MOST = 10
"""At a time."""
LOOKED_AT_S = 300.0
"""How often those that nobody asks for any more are looked for."""


@dataclass
class LogImport(DraftFolder):
    """A log that is being imported."""

    files: dict[str, SentFile] = field(default_factory=dict)
    """By the names with which they were sent."""
    answers: dict[str, str] = field(default_factory=dict)
    """Keys of the mapping that were given for what was read last."""
    cell: str | None = None
    """In which it was made, as somebody said; None where that is none of ours."""
    progress: float | None = None
    """Share of the reading that is done; None while nothing is read."""
    reading: LogReading | None = None
    """How far it is understood; None before it was read, or when a file has come or gone since."""
    identified: Result | None = None
    """What its payload is; None before somebody asked, or when it was read anew since."""
    without: tuple[str, ...] = ()
    """Files of the log without the payload that it was compared with for that; none where it stood alone."""

    @property
    def logs(self) -> Path:
        """The folder of what was sent."""
        return self.folder / LOGS

    @property
    def recording(self) -> Path:
        """The folder of the recording, where one was made."""
        return self.folder / RECORDING

    @contextmanager
    def working(self) -> Iterator[None]:
        """One thing at a time.

        Raises:
            Conflict: something is under way.
        """
        if not self.busy.acquire(blocking=False):
            raise Conflict("imports-busy", log_import=self.id)
        try:
            yield
        finally:
            self.busy.release()

    def forget_reading(self) -> None:
        """What was read no longer holds."""
        self.reading = self.identified = None
        self.without = ()
        for name in (RECORDING, WORK):
            shutil.rmtree(self.folder / name, ignore_errors=True)
        for language in LANGUAGES:
            locate_report(self.folder, language).unlink(missing_ok=True)


class Imports(DraftFolders[LogImport]):
    """All of the service; what an earlier one has left is removed at the start.

    Args:
        now: tells the service's time.
    """

    def __init__(self, settings: Settings, now: Callable[[], datetime]) -> None:
        super().__init__(LogImport, LASTS, MOST)
        self._folder, self._now = settings.imports_folder, now
        self._looking: asyncio.Task[None] | None = None

    async def start(self) -> None:
        """Begins to look for those that nobody asks for any more."""
        shutil.rmtree(self._folder, ignore_errors=True)
        self._folder.mkdir()
        self._looking = asyncio.create_task(self._look())

    async def close(self) -> None:
        """Nothing of them stays."""
        if self._looking is not None:
            self._looking.cancel()
        shutil.rmtree(self._folder, ignore_errors=True)

    async def _look(self) -> None:
        while True:
            await asyncio.sleep(LOOKED_AT_S)
            await asyncio.to_thread(self.forget_old, self._now())

    def _choose_folder(self) -> Path:
        return self._folder.absolute() / secrets.token_hex(8)

    def _refuse_more(self) -> Conflict:
        return Conflict("imports-too-many", most_imports=MOST)

    def _refuse_unknown(self, name: str) -> NotFound:
        return NotFound("imports-unknown", log_import=name)


ImportsDep = Annotated[Imports, depend_on("imports")]
