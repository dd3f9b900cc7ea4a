"""What somebody has begun and not finished: each a folder of its own, gone when it is left, finished or old; none outlives the service."""

from __future__ import annotations

import secrets
import shutil
import threading
from abc import ABC, abstractmethod
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from pathlib import Path
from typing import Generic, TypeVar

from server.http.errors import Conflict, NotFound


@dataclass
class DraftFolder:
    """One of them.

    Args:
        folder: all of it.
        touched_at: when somebody asked for it last.
    """

    id: str
    folder: Path
    touched_at: datetime
    busy: threading.Lock = field(default_factory=threading.Lock)


D = TypeVar("D", bound=DraftFolder)


class DraftFolders(ABC, Generic[D]):
    """All of one kind.

    Args:
        kind: makes one of its identifier, folder and time.
        lasts: how long one is kept that nobody asks for.
        most: of them at a time.
    """

    def __init__(self, kind: type[D], lasts: timedelta, most: int) -> None:
        self._kind, self.lasts, self._most = kind, lasts, most
        self._known: dict[str, D] = {}
        self._changing = threading.Lock()

    @abstractmethod
    def _choose_folder(self) -> Path:
        """Where a new one lies."""

    @abstractmethod
    def _refuse_more(self) -> Conflict:
        """There are as many as there may be."""

    @abstractmethod
    def _refuse_unknown(self, name: str) -> NotFound:
        """There is none of that name, or not any more."""

    @contextmanager
    def begin(self, now: datetime) -> Iterator[D]:
        """A new one with an empty folder; it is kept where nothing goes wrong inside.

        Raises:
            Conflict: there are as many as there may be.
        """
        self.forget_old(now)
        with self._changing:
            if len(self._known) >= self._most:
                raise self._refuse_more()
            draft = self._kind(secrets.token_hex(12), self._choose_folder(), now)
            self._known[draft.id] = draft
        draft.folder.mkdir()
        try:
            yield draft
        except BaseException:
            self.remove(draft)
            raise

    def find(self, name: str, now: datetime) -> D:
        """One that somebody goes on with.

        Raises:
            NotFound: there is none, or not any more.
        """
        self.forget_old(now)
        draft = self._known.get(name)
        if draft is None:
            raise self._refuse_unknown(name[:80])
        draft.touched_at = now
        return draft

    def remove(self, draft: D) -> None:
        """Nothing of it stays."""
        self._known.pop(draft.id, None)
        shutil.rmtree(draft.folder, ignore_errors=True)

    def forget_old(self, now: datetime) -> None:
        """Removes those that nobody has asked for and nothing works on."""
        for draft in list(self._known.values()):
            if now - draft.touched_at > self.lasts and draft.busy.acquire(blocking=False):
                self.remove(draft)
