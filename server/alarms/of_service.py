"""What of the service itself needs a person: its disk, its cells, whom it tells of runs."""

from __future__ import annotations

import shutil
from pathlib import Path

from sqlalchemy import select
from sqlalchemy.orm import Session

from core.errors import HeftError
from core.words.message import Message
from server.alarms.kinds import Condition
from server.cells.folder import CellFolder
from server.cells.now import read_now
from server.runs.releases import BYTES_A_SECOND, SPARE_BYTES
from server.runs.tables import Delivery, Webhook

RUN_S = 120.0
"""Robot time of an usual run."""
FULL_BYTES = round(SPARE_BYTES + RUN_S * BYTES_A_SECOND)
"""With less a usual run is refused its release."""
FEW_RUNS = 10
ATTEMPTS = 3
"""After so many in a row a webhook counts as failing: within some 14 s."""


def judge_disk(folder: Path) -> list[Condition]:
    """Whether runs can still be recorded."""
    free = shutil.disk_usage(folder).free
    if free < FULL_BYTES:
        return [Condition("disk_full", "data", Message.of("alarms-disk-full", free_mb=free / 1e6))]
    if free < FEW_RUNS * FULL_BYTES:
        return [Condition("disk_nearly_full", "data", Message.of("alarms-disk-nearly-full", free_mb=free / 1e6))]
    return []


def judge_cells(cells: CellFolder, db: Session) -> list[Condition]:
    """Cells in which nothing can be planned now."""
    found = []
    for name in cells.names():
        flaw = _find_flaw(cells, db, name)
        if flaw is not None:
            found.append(Condition("cell_flawed", name, Message.of("alarms-cell-flawed", cell=name, flaw=flaw), name))
    return found


def _find_flaw(cells: CellFolder, db: Session, name: str) -> Message | None:
    try:
        flaws = cells.flaws(read_now(cells, db, name))
    except HeftError as error:
        return error.message
    return flaws[0].message if flaws else None


def judge_webhooks(db: Session) -> list[Condition]:
    """Those whose messages do not arrive and are still tried, with what was wrong last."""
    query = select(Delivery, Webhook).join(Webhook, Webhook.id == Delivery.webhook)
    query = query.where(Delivery.due_at.is_not(None), Delivery.attempts >= ATTEMPTS).order_by(Delivery.id)
    failing = {webhook.id: (webhook.url, delivery) for delivery, webhook in db.execute(query)}
    return [Condition("webhook_failing", each, _describe_webhook(*found)) for each, found in failing.items()]


def _describe_webhook(url: str, delivery: Delivery) -> Message:
    cause = Message.of("runs-ended") if delivery.last_error is None else Message.model_validate_json(delivery.last_error)
    return Message.of("alarms-webhook-failing", url=url, attempts=delivery.attempts, cause=cause)
