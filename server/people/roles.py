"""Who may ask what in general: the five roles. An account can have several, a machine's key has one."""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum

from core.words.message import Message


class Role(StrEnum):
    """What somebody is at the plant."""

    viewer = "viewer"
    """Watches."""
    operator = "operator"
    """Stands at the cell and moves the robot."""
    engineer = "engineer"
    """Changes cells and reads diagnoses."""
    mes = "mes"
    """The plant's job system: queues runs, never releases motion."""
    admin = "admin"
    """Keeps accounts, keys and the audit log."""


MACHINE_ROLES = frozenset({Role.viewer, Role.engineer, Role.mes})
"""What a key may be: a machine never releases motion and never makes accounts."""


def name_roles(roles: Iterable[Role]) -> list[Message]:
    """Roles for a message that names them."""
    return [Message.of("people-role", role=each.value) for each in sorted(roles)]
