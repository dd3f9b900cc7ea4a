"""What the service has logged of late, kept in memory: standard error belongs to whoever started it, and is not always kept."""

from __future__ import annotations

import logging
from collections import deque

from server.telemetry.logs import JsonLines, is_news

LINES = 2000


class RecentLog(logging.Handler):
    """The last lines, without the requests that were answered as usual: those alone would fill it within minutes."""

    def __init__(self, most: int = LINES) -> None:
        super().__init__()
        self._lines: deque[str] = deque(maxlen=most)
        self.setFormatter(JsonLines())
        self.addFilter(is_news)

    def emit(self, record: logging.LogRecord) -> None:
        """Keeps one line."""
        self._lines.append(self.format(record))

    def lines(self) -> list[str]:
        """One JSON object each, oldest first."""
        self.acquire()
        try:
            return list(self._lines)
        finally:
            self.release()

    def start(self) -> None:
        """Listens to every log of the process from now on."""
        logging.getLogger().addHandler(self)

    def end(self) -> None:
        """Listens no more; what it has stays."""
        logging.getLogger().removeHandler(self)
