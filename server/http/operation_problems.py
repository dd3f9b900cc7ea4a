"""Which problems each operation may answer with: what it refuses itself stands here, what stands before many follows from the operation.

A test holds every problem that the service answers in any test against this table.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

CELL = ("request-cell-unknown",)
RUN = ("runs-unknown",)
SAVED = ("library-unknown",)
JOB = ("jobs-unknown",)
STATE = ("runs-command-not-possible", "runs-command-impossible")
HELD = ("runs-control-free", "runs-control-elsewhere")
CONTROL = (*HELD, "runs-command-repeated", "runs-command-late")
RESULT = (*RUN, "runs-no-result", "runs-no-result-because")
REPEATED = ("request-key-reused", "request-key-busy")
ZIP = ("uploads-no-zip", "uploads-not-unpackable", "uploads-too-many-files", "uploads-longer-than-listed", "uploads-encrypted-file",
       "uploads-compression-unknown")  # fmt: skip
CELL_ZIP = (
    *ZIP, "uploads-checker-ended", "uploads-outside-file", "uploads-program", "uploads-too-many-bytes", "uploads-symbolic-link",
    "uploads-special-file", "uploads-name-outside", "uploads-name-unusual", "uploads-kind-unknown", "uploads-same-names",
    "uploads-no-cell-file", "uploads-check-too-large", "uploads-check-too-slow", "uploads-check-broken-off", "uploads-cell-misnamed",
    "uploads-model-not-buildable",
)  # fmt: skip
DRAWN_ZONE = ("zone-too-small", "zone-too-large", "zone-too-far", "zone-not-looked-at", "jobs-work-lost")
DRAFT = ("drafts-unknown",)
DRAFT_WORK = ("drafts-busy", "drafts-work-ended", "uploads-outside-file", "uploads-program")
IMPORT = ("imports-unknown",)
UNREAD = (*IMPORT, "imports-not-read", "imports-question-open", "imports-contradicted")
UNUSABLE = ("bad-cell", "bad-robot")
"""Kinds of what the engine says of a cell, with codes of its own."""

REFUSALS: dict[str, tuple[str, ...]] = {
    "GET /health": ("store-unavailable",),
    "GET /problems/{code}": ("request-problem-unknown",),
    "POST /api/now/{cell}/stop": ("runs-nothing-to-stop",),
    "POST /api/session": ("people-sign-in-refused", "people-sign-in-blocked", "store-unavailable"),
    "DELETE /api/sessions/{session}": ("people-session-unknown",),
    "PUT /api/session/password": ("people-key-without-password", "people-password-wrong", "people-sign-in-blocked"),
    "POST /api/accounts": ("people-account-exists",),
    "PATCH /api/accounts/{account}": ("people-account-unknown", "people-last-admin"),
    "POST /api/keys": ("people-key-exists", "people-role-not-for-machines"),
    "DELETE /api/keys/{key}": ("people-key-unknown",),
    "POST /api/cells": (*CELL_ZIP, "uploads-cell-exists"),
    "POST /api/cells/validate": CELL_ZIP,
    "GET /api/cells/{cell}": CELL,
    "PUT /api/cells/{cell}": (*CELL_ZIP, "uploads-other-cell"),
    "POST /api/cells/{cell}/zones": (*CELL, *DRAWN_ZONE, "zone-name-taken", "zone-exists"),
    "PUT /api/cells/{cell}/zones/{zone}/shape": (*CELL, *DRAWN_ZONE, "zone-unknown"),
    "DELETE /api/cells/{cell}/zones/{zone}": (*CELL, "zone-unknown"),
    "POST /api/drafts": (
        *ZIP, "uploads-too-many-bytes", "uploads-symbolic-link", "uploads-special-file", "uploads-name-outside", "uploads-name-unusual",
        "uploads-same-names", "drafts-no-description", "drafts-too-many",
    ),
    "GET /api/drafts/{draft}": DRAFT,
    "DELETE /api/drafts/{draft}": DRAFT,
    "POST /api/drafts/{draft}/robot": (*DRAFT, *DRAFT_WORK, "drafts-file-unknown"),
    "PUT /api/drafts/{draft}/cell": (*DRAFT, *DRAFT_WORK, "drafts-not-read"),
    "GET /api/drafts/{draft}/picture": (*DRAFT, "drafts-no-picture"),
    "POST /api/drafts/{draft}/import": (*DRAFT, *CELL_ZIP, "drafts-not-made", "uploads-cell-exists"),
    "PUT /api/cells/{cell}/zones/{zone}": (*CELL, "zone-unknown", "zone-clock-ahead", "zone-measured-before"),
    "POST /api/cells/{cell}/zones/{zone}/check": (*CELL, "zone-unknown", "zone-not-looked-at", "jobs-work-lost"),
    "POST /api/cells/{cell}/zones/{zone}/undo": (*CELL, "zone-unknown", "zone-not-moved", "zone-moved-on"),
    "PUT /api/cells/{cell}/views/{view}": CELL,
    "GET /api/cells/{cell}/twin": CELL,
    "POST /api/cells/{cell}/twin": (*CELL, *JOB, "jobs-no-effect-yet"),
    "DELETE /api/cells/{cell}/twin/{effect}": (*CELL, "jobs-effect-not-in-twin"),
    "GET /api/cells/{cell}/tools": CELL,
    "GET /api/cells/{cell}/payloads": CELL,
    "GET /api/cells/{cell}/payloads/{saved}": (*CELL, *SAVED),
    "POST /api/cells/{cell}/payloads": (
        *CELL, *RESULT, "library-name-taken", "library-full", "library-run-of-other-cell", "library-without-box", "library-mass-range",
    ),
    "PATCH /api/cells/{cell}/payloads/{saved}": (*CELL, *SAVED, "library-name-taken", "library-mass-range"),
    "DELETE /api/cells/{cell}/payloads/{saved}": (*CELL, *SAVED),
    "POST /api/control": (*CELL, "runs-control-taken", "runs-control-overtaken"),
    "GET /api/control/{cell}": CELL,
    "DELETE /api/control/{cell}": CELL,
    "POST /api/control/{cell}/request": (*CELL, "runs-control-asked", "runs-control-overtaken"),
    "POST /api/control/{cell}/request/answer": (*CELL, *HELD, "runs-control-not-asked"),
    "DELETE /api/control/{cell}/request": CELL,
    "POST /api/runs": (
        *CELL, "runs-cell-without-payload", "runs-payload-unknown", "library-mass-range", "runs-speed-not-allowed",
        "runs-start-of-other-robot", *RUN, "torques-run-not-empty", "torques-not-together",
        "runs-no-recording", *REPEATED,
    ),
    "GET /api/runs/{run}": RUN,
    "DELETE /api/runs/{run}": (*RUN, *STATE),
    "POST /api/runs/{run}/continuation": (*RUN, *CELL, "runs-nothing-left", "runs-recording-not-there", *REPEATED),
    "GET /api/runs/{run}/plan": (*RUN, "runs-no-plan"),
    "POST /api/runs/{run}/release": (
        *RUN, *CELL, *STATE, *CONTROL, "runs-plan-void", "runs-offer-foreign", "runs-offer-old", "runs-disk-too-full",
        "store-release-waits", "store-release-not-taken",
    ),
    "POST /api/runs/{run}/commands": (
        *RUN, *STATE, *CONTROL, "runs-command-without-control", "runs-recording-open", "store-resume-waits",
    ),
    "GET /api/runs/{run}/result": RESULT,
    "POST /api/runs/{run}/acceptance": (*RESULT, "runs-accepted-already", "store-result-not-there"),
    "GET /api/runs/{run}/comparison/{other}": (*RESULT, *CELL, "runs-no-common-frame"),
    "GET /api/series": (*RESULT, *CELL, "runs-no-common-frame"),
    "GET /api/timeline": (*RUN, *JOB),
    "GET /api/runs/{run}/exports": (*RESULT, *CELL),
    "GET /api/runs/{run}/exports/{target}": (*RESULT, *CELL),
    "GET /api/runs/{run}/certificate": (*RESULT, "jobs-work-lost"),
    "GET /api/runs/{run}/certificate.pdf": (*RESULT, "jobs-work-lost"),
    "GET /api/runs/{run}/recording": (*RUN, "runs-no-recording"),
    "GET /api/runs/{run}/report": (*RUN, "runs-no-report"),
    "GET /api/runs/{run}/events": RUN,
    "POST /api/diagnoses": (*RUN, "runs-no-recording"),
    "POST /api/diagnoses/uploads": (*ZIP, *CELL, "uploads-recording-too-large", "uploads-two-recordings", "uploads-no-manifest",
        "jobs-upload-of-other-cell", "jobs-upload-of-other-robot",
    ),
    "GET /api/diagnoses/{diagnosis}": JOB,
    "DELETE /api/diagnoses/{diagnosis}": (*JOB, "jobs-over"),
    "GET /api/diagnoses/{diagnosis}/overlay": (*JOB, "jobs-no-overlay"),
    "GET /api/diagnoses/{diagnosis}/report": (*JOB, "jobs-no-report"),
    "POST /api/diagnoses/{diagnosis}/motion": (
        *JOB, *RUN, *CELL, "jobs-no-cell", "jobs-recording-gone", "jobs-payload-unknown", "jobs-payload-unnamed", "jobs-payload-differs",
        "jobs-no-motion-yet", "jobs-no-motion-proposed", "jobs-no-motion-asked", "jobs-motion-refused", "jobs-motion-not-planned",
        "jobs-robot-changed", "jobs-gravity-changed", *REPEATED,
    ),
    "POST /api/imports": ("imports-too-many",),
    "GET /api/imports/{log_import}": IMPORT,
    "DELETE /api/imports/{log_import}": (*IMPORT, "imports-busy"),
    "PUT /api/imports/{log_import}/files/{file}": (
        *IMPORT, "imports-busy", "imports-too-many-files", "imports-name-unusual", "imports-kind-unknown", "imports-file-empty",
        "imports-disk-too-full", "imports-not-writable", "imports-unpacks-too-large", "imports-own-recording", "imports-no-log-inside",
        "uploads-two-recordings", *ZIP,
    ),
    "DELETE /api/imports/{log_import}/files/{file}": (*IMPORT, "imports-busy", "imports-file-unknown"),
    "PUT /api/imports/{log_import}/reading": (
        *IMPORT, *CELL, "imports-busy", "imports-no-log-yet", "imports-several", "imports-reading-ended", "uploads-outside-file",
        "uploads-program",
    ),
    "GET /api/imports/{log_import}/mapping": UNREAD,
    "GET /api/imports/{log_import}/recording": UNREAD,
    "POST /api/imports/{log_import}/identification": (
        *UNREAD, *CELL, "imports-busy", "imports-without-itself", "jobs-upload-of-other-cell", "jobs-upload-of-other-robot",
        "jobs-work-lost",
    ),
    "GET /api/imports/{log_import}/result": (*IMPORT, "imports-not-identified"),
    "GET /api/imports/{log_import}/report": (*IMPORT, "imports-not-identified"),
    "POST /api/imports/{log_import}/diagnosis": (
        *UNREAD, *CELL, "imports-busy", "jobs-upload-of-other-cell", "jobs-upload-of-other-robot",
    ),
    "GET /api/trials/{trials}": JOB,
    "DELETE /api/trials/{trials}": (*JOB, "jobs-over"),
    "DELETE /api/webhooks/{webhook}": ("runs-webhook-unknown",),
    "GET /api/webhooks/{webhook}/deliveries": ("runs-webhook-unknown",),
    "POST /api/webhooks/{webhook}/test": ("runs-webhook-unknown",),
    "POST /api/alarms/{alarm}/acknowledgement": ("alarms-unknown", "alarms-acknowledged-already"),
}  # fmt: skip
"""Codes of the service's own refusals."""

ENGINE_REFUSALS: dict[str, tuple[str, ...]] = {
    "POST /api/cells": (*UNUSABLE, "bad-twin", "bad-input"),
    "POST /api/cells/validate": (*UNUSABLE, "bad-twin", "bad-input"),
    "PUT /api/cells/{cell}": (*UNUSABLE, "bad-twin", "bad-input"),
    "POST /api/cells/{cell}/zones": (*UNUSABLE, "bad-zone"),
    "PUT /api/cells/{cell}/zones/{zone}/shape": (*UNUSABLE, "bad-zone"),
    "DELETE /api/cells/{cell}/zones/{zone}": UNUSABLE,
    "POST /api/drafts": ("bad-robot",),
    "POST /api/drafts/{draft}/robot": (*UNUSABLE, "bad-input"),
    "PUT /api/drafts/{draft}/cell": (*UNUSABLE, "bad-input", "bad-payload"),
    "POST /api/drafts/{draft}/import": (*UNUSABLE, "bad-twin", "bad-input"),
    "PUT /api/cells/{cell}/zones/{zone}": UNUSABLE,
    "POST /api/cells/{cell}/zones/{zone}/check": UNUSABLE,
    "POST /api/cells/{cell}/zones/{zone}/undo": UNUSABLE,
    "GET /api/cells/{cell}/twin": (*UNUSABLE, "bad-twin"),
    "POST /api/cells/{cell}/twin": (*UNUSABLE, "bad-twin"),
    "DELETE /api/cells/{cell}/twin/{effect}": (*UNUSABLE, "bad-twin"),
    "GET /api/cells/{cell}/tools": UNUSABLE,
    "GET /api/cells/{cell}/payloads": UNUSABLE,
    "GET /api/cells/{cell}/payloads/{saved}": UNUSABLE,
    "POST /api/cells/{cell}/payloads": (*UNUSABLE, "bad-payload"),
    "PATCH /api/cells/{cell}/payloads/{saved}": (*UNUSABLE, "bad-payload"),
    "POST /api/runs": (*UNUSABLE, "bad-payload"),
    "POST /api/runs/{run}/continuation": UNUSABLE,
    "POST /api/runs/{run}/release": UNUSABLE,
    "GET /api/runs/{run}/comparison/{other}": (*UNUSABLE, "bad-payload"),
    "GET /api/series": (*UNUSABLE, "bad-payload", "bad-input"),
    "GET /api/timeline": ("bad-input",),
    "GET /api/runs/{run}/exports": (*UNUSABLE, "bad-payload"),
    "GET /api/runs/{run}/exports/{target}": (*UNUSABLE, "bad-payload", "bad-input"),
    "GET /api/runs/{run}/certificate": ("bad-recording",),
    "GET /api/runs/{run}/certificate.pdf": ("bad-recording",),
    "POST /api/diagnoses/uploads": (*UNUSABLE, "bad-recording"),
    "PUT /api/imports/{log_import}/files/{file}": ("bad-input",),
    "PUT /api/imports/{log_import}/reading": (*UNUSABLE, "bad-recording", "bad-input"),
    "POST /api/imports/{log_import}/identification": (*UNUSABLE, "bad-twin", "bad-recording"),
    "POST /api/imports/{log_import}/diagnosis": (*UNUSABLE, "bad-recording"),
    "POST /api/diagnoses/{diagnosis}/motion": (*UNUSABLE, "bad-recording"),
}
"""Kinds of what the engine refuses there."""

SAFE = frozenset({"GET", "HEAD", "OPTIONS"})
SIGN_IN = ("people-not-signed-in", "people-key-refused", "people-session-over", "people-without-role", "store-unavailable")


def list_problems(endpoint: str, operation: dict[str, Any], authority: frozenset[Any] | None) -> Iterator[str]:
    """Codes of the problems that an operation may answer with, but for those of the engine.

    Args:
        endpoint: as the table of authority names it, "GET /api/cells/{cell}".
        operation: its OpenAPI description.
        authority: who may call it; None for anybody.
    """
    yield from REFUSALS.get(endpoint, ())
    if authority is not None:
        yield from SIGN_IN
        yield "people-role-lacking"
    if endpoint.partition(" ")[0] not in SAFE:
        yield "people-origin-foreign"
        if authority is not None:
            yield "people-csrf-token-wrong"
    if "bad-cell" in ENGINE_REFUSALS.get(endpoint, ()):
        yield "uploads-cell-misnamed"
    if "{" in endpoint:
        yield "request-address-unknown"  # a name with a slash in it
    body = operation.get("requestBody", {}).get("content", {})
    if operation.get("parameters") or "application/json" in body:
        yield "request-unfit"
    if "application/json" in body:
        yield "request-no-json"
    if body:
        yield "request-body-too-large"
