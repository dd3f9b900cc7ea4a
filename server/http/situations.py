"""What the service itself refuses, each situation with its code; of which kind it is, and what it names, as its English words have it."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

from core.words.catalogue import FOLDER

if TYPE_CHECKING:
    from fluent.syntax import ast as ftl

SITUATIONS: dict[str, tuple[str, ...]] = {
    "not-signed-in": ("people-key-refused", "people-session-over", "people-sign-in-refused", "people-not-signed-in"),
    "not-allowed": (
        "people-origin-foreign",
        "people-origin-missing",
        "people-csrf-token-wrong",
        "people-endpoint-closed",
        "people-role-lacking",
        "people-without-role",
        "people-key-without-password",
        "people-password-wrong",
    ),
    "not-found": (
        "runs-unknown",
        "alarms-unknown",
        "runs-webhook-unknown",
        "people-account-unknown",
        "people-key-unknown",
        "people-session-unknown",
        "jobs-unknown",
        "jobs-effect-not-in-twin",
        "zone-unknown",
        "library-unknown",
        "drafts-unknown",
        "imports-unknown",
        "imports-file-unknown",
        "request-cell-unknown",
        "request-problem-unknown",
        "request-console-file-unknown",
        "request-address-unknown",
    ),
    "conflict": (
        "runs-command-not-possible",
        "runs-command-impossible",
        "runs-no-plan",
        "runs-no-result",
        "runs-no-result-because",
        "runs-no-recording",
        "torques-run-not-empty",
        "torques-not-together",
        "runs-no-report",
        "runs-recording-open",
        "runs-nothing-left",
        "runs-recording-not-there",
        "runs-accepted-already",
        "alarms-acknowledged-already",
        "runs-nothing-to-stop",
        "runs-no-common-frame",
        "runs-speed-not-allowed",
        "runs-start-of-other-robot",
        "runs-control-taken",
        "runs-control-free",
        "runs-control-elsewhere",
        "runs-control-asked",
        "runs-control-not-asked",
        "runs-control-overtaken",
        "runs-command-without-control",
        "runs-command-repeated",
        "runs-command-late",
        "runs-plan-void",
        "runs-offer-foreign",
        "runs-offer-old",
        "people-account-exists",
        "people-last-admin",
        "people-key-exists",
        "jobs-over",
        "jobs-no-overlay",
        "jobs-no-report",
        "jobs-no-cell",
        "jobs-recording-gone",
        "jobs-payload-unknown",
        "jobs-payload-unnamed",
        "jobs-payload-differs",
        "jobs-no-motion-yet",
        "jobs-no-motion-proposed",
        "jobs-no-motion-asked",
        "jobs-motion-refused",
        "jobs-motion-not-planned",
        "jobs-robot-changed",
        "jobs-gravity-changed",
        "jobs-no-effect-yet",
        "imports-too-many",
        "imports-too-many-files",
        "imports-busy",
        "imports-no-log-yet",
        "imports-several",
        "imports-not-read",
        "imports-question-open",
        "imports-contradicted",
        "imports-not-identified",
        "imports-without-itself",
        "drafts-too-many",
        "drafts-busy",
        "drafts-not-read",
        "drafts-not-made",
        "drafts-no-picture",
        "library-name-taken",
        "library-full",
        "library-run-of-other-cell",
        "zone-measured-before",
        "zone-clock-ahead",
        "zone-not-moved",
        "zone-moved-on",
        "zone-exists",
        "uploads-cell-exists",
        "request-key-busy",
    ),
    "unprocessable": (
        "jobs-upload-of-other-cell",
        "jobs-upload-of-other-robot",
        "people-role-not-for-machines",
        "jobs-work-lost",
        "zone-not-looked-at",
        "library-without-box",
        "drafts-file-unknown",
        "drafts-work-ended",
        "imports-reading-ended",
        "uploads-no-zip",
        "uploads-other-cell",
        "uploads-checker-ended",
        "request-key-reused",
    ),
    "too-large": ("request-body-too-large",),
    "too-many": ("people-sign-in-blocked",),
    "store-unavailable": (
        "store-unavailable",
        "store-release-waits",
        "store-release-not-taken",
        "store-resume-waits",
        "store-result-not-there",
    ),
    "no-room": ("runs-disk-too-full", "imports-disk-too-full", "imports-not-writable"),
    "bad-input": (
        "uploads-outside-file",
        "uploads-program",
        "uploads-not-unpackable",
        "uploads-too-many-files",
        "uploads-two-recordings",
        "imports-name-unusual",
        "imports-kind-unknown",
        "imports-file-empty",
        "imports-unpacks-too-large",
        "imports-own-recording",
        "imports-no-log-inside",
    ),
    "bad-payload": ("runs-cell-without-payload", "runs-payload-unknown", "library-mass-range"),
    "bad-cell": (
        "uploads-not-unpackable",
        "uploads-too-many-files",
        "uploads-too-many-bytes",
        "uploads-longer-than-listed",
        "uploads-symbolic-link",
        "uploads-special-file",
        "uploads-encrypted-file",
        "uploads-compression-unknown",
        "uploads-name-outside",
        "uploads-name-unusual",
        "uploads-kind-unknown",
        "uploads-same-names",
        "uploads-no-cell-file",
        "uploads-check-too-large",
        "uploads-check-too-slow",
        "uploads-check-broken-off",
        "uploads-cell-misnamed",
    ),
    "bad-zone": ("zone-name-taken", "zone-too-small", "zone-too-large", "zone-too-far"),
    "bad-robot": (
        "uploads-model-not-buildable",
        "drafts-no-description",
        "uploads-not-unpackable",
        "uploads-too-many-files",
        "uploads-too-many-bytes",
        "uploads-longer-than-listed",
        "uploads-symbolic-link",
        "uploads-special-file",
        "uploads-encrypted-file",
        "uploads-compression-unknown",
        "uploads-name-outside",
        "uploads-name-unusual",
        "uploads-same-names",
    ),
    "bad-recording": (
        "uploads-not-unpackable",
        "uploads-too-many-files",
        "uploads-recording-too-large",
        "uploads-two-recordings",
        "uploads-no-manifest",
    ),
    "bad-request": ("request-unfit", "request-no-json"),
    "method-not-allowed": ("request-method-not-allowed",),
    "http-error": ("request-refused",),
    "internal-error": ("request-unforeseen",),
}
"""Codes of the problems that begin here, by their kind. A test holds them against the source."""


class Words(NamedTuple):
    """A message as the English catalogue has it: its source, and what it names."""

    source: str
    names: tuple[str, ...]


def list_kinds(code: str) -> list[str]:
    """Of which kinds a problem of the service with this code is; nothing of another's code."""
    return [kind for kind, codes in SITUATIONS.items() if code in codes]


@cache
def read_words() -> dict[str, Words]:
    """Every message of the catalogue; read for descriptions alone."""
    from fluent.syntax import FluentParser, FluentSerializer  # noqa: PLC0415 - for descriptions alone
    from fluent.syntax import ast as ftl  # noqa: PLC0415 - for descriptions alone

    entries: dict[str, ftl.Message] = {}
    for file in sorted((FOLDER / "en").glob("*.ftl")):
        parsed = FluentParser(with_spans=False).parse(file.read_text(encoding="utf-8")).body
        entries |= {entry.id.name: entry for entry in parsed if isinstance(entry, ftl.Message)}
    for entry in entries.values():
        entry.comment = None
    serialize = FluentSerializer().serialize_entry
    return {code: Words(serialize(entry).strip(), tuple(_list_names(entry, entries))) for code, entry in entries.items()}


def _list_names(entry: ftl.Message, entries: dict[str, ftl.Message]) -> list[str]:
    """What its words name, those of the messages that it refers to included, each once, in their order."""
    from fluent.syntax import ast as ftl  # noqa: PLC0415 - for descriptions alone

    names: list[str] = [] if entry.value is not None else ["where"]
    waiting: list[Any] = [entry.value, *entry.attributes]
    while waiting:
        node = waiting.pop(0)
        if isinstance(node, ftl.VariableReference):
            names.append(node.id.name)
        elif isinstance(node, ftl.MessageReference):
            names += _list_names(entries[node.id.name], entries)
        elif isinstance(node, ftl.BaseNode):
            waiting[:0] = [each for value in vars(node).values() for each in (value if isinstance(value, list) else [value])]
    return list(dict.fromkeys(names))
