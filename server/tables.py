"""Every table of the store, known to its metadata once this is imported."""

from server.alarms.tables import AlarmRow
from server.cells.payloads import SavedPayload
from server.cells.zones import ZonePosition
from server.people.accounts import Account, ApiKey, SignIn
from server.people.audit import AuditEntry
from server.people.login_limit import LoginFailures
from server.runs.tables import ControlFence, Delivery, IdempotencyKey, JobRow, RunEventRow, RunRow, Webhook
from server.store.store import Table

__all__ = [
    "Account",
    "AlarmRow",
    "ApiKey",
    "AuditEntry",
    "ControlFence",
    "Delivery",
    "IdempotencyKey",
    "JobRow",
    "LoginFailures",
    "RunEventRow",
    "RunRow",
    "SavedPayload",
    "SignIn",
    "Table",
    "Webhook",
    "ZonePosition",
]
