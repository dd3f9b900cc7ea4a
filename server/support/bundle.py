"""The support bundle: one zip that tells an engineer elsewhere how this service is, and holds nothing that opens a door."""

from __future__ import annotations

import io
import json
import logging
import os
import resource
import zipfile
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from datetime import datetime
from typing import Any

from pydantic import BaseModel
from sqlalchemy import func, select
from sqlalchemy.engine import make_url
from sqlalchemy.exc import SQLAlchemyError

from core.errors import HeftError
from core.words.message import Message
from server.cells.folder import CellFolder
from server.cells.now import read_now
from server.http.flaws import list_flaws
from server.people.accounts import Account
from server.people.audit import AuditEntry
from server.people.audit_routes import show_entry, verify_entries
from server.runner.messages import Answered, Failed
from server.runner.work import run_work
from server.runs import ledger as run_ledger
from server.runs.tables import JobRow, RunRow, Webhook
from server.settings import Settings
from server.store.store import Store
from server.support.disk import read_disk
from server.support.redaction import GONE, redact
from server.support.versions import read_versions
from server.telemetry.metrics import Metrics
from server.telemetry.recent_log import RecentLog

log = logging.getLogger("heft.support")

AUDIT_ENTRIES, RUNS = 1000, 50

CONTENTS = """Heft support bundle, made {made_at}

versions.json      Heft, its libraries, the database, the operating system
settings.json      all settings; of the database only its kind
health.json        whether the store answers, load, memory, what is under way, how much was logged at which level
disk.json          room on the disk of the data folder, and what takes it
log.jsonl          the latest lines of the log, one JSON object each, without requests that were answered as usual
metrics.txt        figures as Prometheus reads them
runs.json          the latest {runs} runs, newest first; no recordings
cells.json         for each cell the digest of its files, what speaks against planning in it now, and what `heft cell check` finds
audit.json         the latest {audit} entries of the audit log, newest first
verification.json  whether the audit log's chain is unbroken

Passwords, keys, tokens and secrets are not in here; of addresses of the network scheme and host are left, and names that somebody typed
at a refused sign-in are left out unless they are those of an account. For that reason the hashes of audit.json cannot be computed again
from it; verification.json was made from the log itself. The bundle does name accounts, cells and the addresses of devices.
A part that could not be read says why in "not_read".
"""


@dataclass(frozen=True)
class Bundle:
    """What a bundle is made from."""

    settings: Settings
    store: Store
    cells: CellFolder
    metrics: Metrics
    recent_log: RecentLog
    started_at: datetime

    def make(self, now: datetime) -> bytes:
        """The zip; it comes about whatever does not work."""
        secrets = self._list_secrets()
        made = io.BytesIO()
        with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as opened:
            opened.writestr("contents.txt", CONTENTS.format(made_at=now.isoformat(timespec="seconds"), runs=RUNS, audit=AUDIT_ENTRIES))
            for name, part in self._parts(now).items():
                opened.writestr(name, redact(_read(name, part), secrets))
        return made.getvalue()

    def _parts(self, now: datetime) -> dict[str, Callable[[], str]]:
        return {
            "versions.json": self._versions,
            "settings.json": self._settings,
            "health.json": lambda: self._health(now),
            "disk.json": lambda: _dump(read_disk(self.settings)),
            "runs.json": self._runs,
            "cells.json": self._cells,
            "audit.json": self._audit,
            "verification.json": self._verification,
            "metrics.txt": lambda: self.metrics.text().decode(),
            "log.jsonl": lambda: "".join(f"{line}\n" for line in self.recent_log.lines()),
        }

    def _list_secrets(self) -> list[str]:
        """What is secret and has no form of its own. Where the store does not answer, it does not tell any either."""
        known = [make_url(self.settings.store_url).password]
        try:
            with self.store.read() as db:
                known += db.scalars(select(Webhook.secret))
        except SQLAlchemyError:
            log.warning("the secrets of webhooks could not be read")
        texts = {each for each in known if each}
        return sorted(texts | {json.dumps(each)[1:-1] for each in texts})

    def _versions(self) -> str:
        with self.store.read() as db:
            return _dump(read_versions(db, self.started_at))

    def _settings(self) -> str:
        shown = self.settings.model_dump(mode="json", exclude={"database_url"})
        return _dump(shown | {"database": make_url(self.settings.store_url).get_backend_name()})

    def _health(self, now: datetime) -> str:
        levels = Counter(json.loads(line)["level"] for line in self.recent_log.lines())
        used = resource.getrusage(resource.RUSAGE_SELF)
        with self.store.read() as db:
            runs = dict(db.execute(select(RunRow.state, func.count()).group_by(RunRow.state)).all())
            jobs = dict(db.execute(select(JobRow.state, func.count()).group_by(JobRow.state)).all())
        return _dump({
            "made_at": now.isoformat(),
            "up_s": (now - self.started_at).total_seconds(),
            "store": "ok",
            "load": os.getloadavg(),
            "largest_memory_mb": used.ru_maxrss / 1024,
            "processor_s": used.ru_utime + used.ru_stime,
            "logged": dict(levels),
            "runs": runs,
            "jobs": jobs,
        })  # fmt: skip

    def _runs(self) -> str:
        with self.store.read() as db:
            rows = db.scalars(select(RunRow).order_by(RunRow.id.desc()).limit(RUNS))
            return _dump([run_ledger.build_answer(row) for row in rows])

    def _cells(self) -> str:
        names = self.cells.names()
        found = _findings(self.cells, names)
        with self.store.read() as db:
            return _dump([
                {"name": name, "sha256": self.cells.digest(name), "flaws": _flaws_now(self.cells, db, name), "findings": found[name]}
                for name in names
            ])  # fmt: skip

    def _audit(self) -> str:
        with self.store.read() as db:
            known = set(db.scalars(select(Account.name)))
            rows = db.scalars(select(AuditEntry).order_by(AuditEntry.number.desc()).limit(AUDIT_ENTRIES))
            return _dump([_without_typed_name(show_entry(row).model_dump(mode="json"), known) for row in rows])

    def _verification(self) -> str:
        with self.store.read() as db:
            return _dump(verify_entries(db))


def _read(name: str, part: Callable[[], str]) -> str:
    try:
        return part()
    except (HeftError, SQLAlchemyError, OSError) as error:
        log.exception("a part of the support bundle could not be read", extra={"part": name})
        return _dump({"not_read": f"{type(error).__name__}: {error}"})


def _without_typed_name(entry: dict[str, Any], known: set[str]) -> dict[str, Any]:
    """Somebody may have typed their password where their name belongs."""
    if entry["action"] == "session.refuse" and entry["detail"].get("account") not in known:
        entry["detail"]["account"] = GONE
    return entry


def _flaws_now(cells: CellFolder, db: Any, name: str) -> Any:
    """What speaks against planning in a cell, with its zones where they are."""
    try:
        return [flaw.model_dump(mode="json") for flaw in list_flaws(cells.flaws(read_now(cells, db, name)))]
    except HeftError as error:
        return [{"found": str(error), "code": error.message.code}]


def _findings(cells: CellFolder, names: list[str]) -> dict[str, Any]:
    """What is wrong or doubtful in each cell; takes a second or two."""
    *_, last = run_work("server.runner.cell_findings", [cells.folder / name for name in names])
    if isinstance(last, Answered):
        found: dict[str, Any] = json.loads(last.text)
        return found
    why = last.message if isinstance(last, Failed) else Message.of("jobs-work-lost")
    return {name: {"not_read": str(why)} for name in names}


def _dump(value: BaseModel | Iterable[Any]) -> str:
    def plain(each: Any) -> Any:
        return each.model_dump(mode="json")

    return json.dumps(plain(value) if isinstance(value, BaseModel) else value, indent=1, ensure_ascii=False, default=plain) + "\n"
