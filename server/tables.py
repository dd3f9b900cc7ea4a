"""Every table of the store, known to its metadata once this is imported."""

from server.accounts import Account, ApiKey, SignIn
from server.audit import AuditEntry
from server.login_limit import LoginFailures
from server.run_tables import ControlFence, Delivery, IdempotencyKey, JobRow, RunEventRow, RunRow, Webhook
from server.store import Table
from server.zones import ZonePosition

__all__ = [
    "Account",
    "ApiKey",
    "AuditEntry",
    "ControlFence",
    "Delivery",
    "IdempotencyKey",
    "JobRow",
    "LoginFailures",
    "RunEventRow",
    "RunRow",
    "SignIn",
    "Table",
    "Webhook",
    "ZonePosition",
]
