"""Who may call what: every endpoint of the service stands here, and what does not stand here is refused.

docs/service.md shows this table; a test holds them together, another calls each endpoint as each role.
"""

from __future__ import annotations

from server.people.roles import Role

viewer, operator, engineer, mes, admin = Role.viewer, Role.operator, Role.engineer, Role.mes, Role.admin

ANYBODY: frozenset[Role] | None = None
"""Also who is not signed in."""
SIGNED_IN = frozenset(Role)
AT_THE_CELL = frozenset({operator, engineer})

AUTHORITY: dict[str, frozenset[Role] | None] = {
    "GET /": ANYBODY,
    "GET /assets/{path:path}": ANYBODY,
    "GET /health": ANYBODY,
    "GET /openapi.json": ANYBODY,
    "GET /problems/{code}": ANYBODY,
    "GET /metrics": frozenset({viewer, engineer, admin}),
    "GET /api/now": ANYBODY,
    "WS /api/now/live": ANYBODY,
    "POST /api/now/{cell}/stop": ANYBODY,
    "POST /api/session": ANYBODY,
    "GET /api/session": SIGNED_IN,
    "DELETE /api/session": SIGNED_IN,
    "PUT /api/session/password": SIGNED_IN,
    "GET /api/accounts": frozenset({admin}),
    "POST /api/accounts": frozenset({admin}),
    "PATCH /api/accounts/{account}": frozenset({admin}),
    "GET /api/keys": frozenset({admin}),
    "POST /api/keys": frozenset({admin}),
    "DELETE /api/keys/{key}": frozenset({admin}),
    "GET /api/audit": frozenset({engineer, admin}),
    "GET /api/cells": SIGNED_IN,
    "POST /api/cells": frozenset({engineer}),
    "POST /api/cells/validate": frozenset({engineer}),
    "GET /api/cells/{cell}": SIGNED_IN,
    "WS /api/cells/{cell}/live": SIGNED_IN,
    "PUT /api/cells/{cell}": frozenset({engineer}),
    "PUT /api/cells/{cell}/zones/{zone}": AT_THE_CELL,
    "POST /api/cells/{cell}/zones/{zone}/check": AT_THE_CELL,
    "POST /api/cells/{cell}/zones/{zone}/undo": AT_THE_CELL,
    "GET /api/cells/{cell}/twin": SIGNED_IN,
    "POST /api/cells/{cell}/twin": frozenset({engineer}),
    "DELETE /api/cells/{cell}/twin/{effect}": frozenset({engineer}),
    "POST /api/control": frozenset({operator}),
    "GET /api/control/{cell}": SIGNED_IN,
    "DELETE /api/control/{cell}": frozenset({operator}),
    "WS /api/control/{cell}/lease": frozenset({operator}),
    "POST /api/runs": frozenset({operator, mes}),
    "GET /api/runs": SIGNED_IN,
    "GET /api/runs/{run}": SIGNED_IN,
    "DELETE /api/runs/{run}": frozenset({operator, mes}),
    "POST /api/runs/{run}/continuation": frozenset({operator, mes}),
    "GET /api/runs/{run}/plan": SIGNED_IN,
    "POST /api/runs/{run}/release": frozenset({operator}),
    "POST /api/runs/{run}/commands": AT_THE_CELL,
    "GET /api/runs/{run}/result": SIGNED_IN,
    "POST /api/runs/{run}/acceptance": frozenset({operator}),
    "GET /api/runs/{run}/comparison/{other}": SIGNED_IN,
    "GET /api/runs/{run}/exports": SIGNED_IN,
    "GET /api/runs/{run}/exports/{target}": SIGNED_IN,
    "GET /api/runs/{run}/recording": SIGNED_IN,
    "GET /api/runs/{run}/report": SIGNED_IN,
    "GET /api/runs/{run}/events": SIGNED_IN,
    "WS /api/runs/{run}/live": SIGNED_IN,
    "GET /viewer/{cell}": SIGNED_IN,
    "GET /viewer/{cell}/{path:path}": SIGNED_IN,
    "WS /viewer/{cell}": SIGNED_IN,
    "POST /api/diagnoses": AT_THE_CELL,
    "POST /api/diagnoses/uploads": AT_THE_CELL,
    "GET /api/diagnoses": SIGNED_IN,
    "GET /api/diagnoses/{diagnosis}": SIGNED_IN,
    "DELETE /api/diagnoses/{diagnosis}": AT_THE_CELL,
    "GET /api/diagnoses/{diagnosis}/overlay": SIGNED_IN,
    "GET /api/diagnoses/{diagnosis}/report": SIGNED_IN,
    "POST /api/diagnoses/{diagnosis}/motion": frozenset({operator, mes}),
    "POST /api/trials": frozenset({engineer}),
    "GET /api/trials": SIGNED_IN,
    "GET /api/trials/{trials}": SIGNED_IN,
    "DELETE /api/trials/{trials}": frozenset({engineer}),
    "POST /api/webhooks": frozenset({admin}),
    "GET /api/webhooks": frozenset({admin}),
    "DELETE /api/webhooks/{webhook}": frozenset({admin}),
    "GET /api/webhooks/{webhook}/deliveries": frozenset({admin}),
}
