"""What was told in a sentence is a message: a code with parameters, as JSON. Sentences of earlier versions have the code `text`."""

from __future__ import annotations

import json
from typing import Any

import sqlalchemy as sa
from alembic import op

revision = "0009"
down_revision = "0008"

SENTENCES = {"state_changed": "reason", "robot_stopped": "message", "waiting_for_zone": "message", "finished": "verdict"}
"""Where an event of a run had one."""


def upgrade() -> None:
    """Forward; there is no way back: restore the backup instead."""
    for table in ("runs", "jobs"):
        _convert(table, "reason")
    _convert("webhook_deliveries", "last_error")
    _convert_events()


def _convert(name: str, column: str) -> None:
    connection = op.get_bind()
    table = sa.table(name, sa.column("id"), sa.column(column))
    said = table.c[column]
    for row in connection.execute(sa.select(table).where(said.is_not(None))).mappings().all():
        connection.execute(table.update().where(table.c.id == row["id"]).values({column: json.dumps(_message(row[column]))}))


def _convert_events() -> None:
    """Those that have a sentence; most tell of a state that needs no reason."""
    connection = op.get_bind()
    events = sa.table("run_events", sa.column("run"), sa.column("sequence"), sa.column("body"))
    for kind, key in SENTENCES.items():
        has_sentence = [events.c.body.contains(part, autoescape=True) for part in (f'"kind":"{kind}"', f'"{key}":"')]
        query = sa.select(events).where(*has_sentence)
        for row in connection.execute(query).mappings().all():
            body = json.loads(row["body"])
            if isinstance(body["event"].get(key), str):
                body["event"][key] = {**_message(body["event"][key]), "text": body["event"][key]}
                same = (events.c.run == row["run"]) & (events.c.sequence == row["sequence"])
                connection.execute(events.update().where(same).values(body=json.dumps(body, separators=(",", ":"))))


def _message(sentence: str) -> dict[str, Any]:
    return {"code": "text", "parameters": {"text": sentence}}
