"""Takes what opens a door out of a text, however it got into it."""

from __future__ import annotations

import re
from collections.abc import Iterable

GONE = "[removed]"

ADDRESS = re.compile(r"\b[a-z][a-z0-9+.-]*://[^\s\"'<>\\]+", re.IGNORECASE)
"""A webhook's may be a secret as a whole, in its path, its query or as a password."""
KEY = re.compile(r"\bheft_[A-Za-z0-9_-]{40,}")
TOKEN = re.compile(
    r"(?<![\w-])(?=[\w-]*[A-Z])(?=[\w-]*[a-z])(?:[A-Za-z0-9_-]{32}|[A-Za-z0-9_-]{43})(?![\w-])",
    re.ASCII,
)
"""As the service draws them: of sessions, against forged requests, of webhooks."""
PASSWORD_HASH = re.compile(r"\$argon2[a-z]*\$[^\s\"'\\]+")
BEARER = re.compile(r"\bbearer\s+[^\s\"'\\]+", re.IGNORECASE)


def redact(text: str, secrets: Iterable[str]) -> str:
    """The text without secrets: of addresses scheme and host are left.

    Args:
        secrets: texts that are known to be some, as they are and as JSON writes them.
    """
    for secret in sorted(secrets, key=len, reverse=True):
        text = text.replace(secret, GONE)
    text = ADDRESS.sub(_shorten_address, text)
    for pattern in (PASSWORD_HASH, KEY, BEARER, TOKEN):
        text = pattern.sub(GONE, text)
    return text


def _shorten_address(found: re.Match[str]) -> str:
    scheme, _, rest = found.group().partition("://")
    host = re.split(r"[/?#]", rest, maxsplit=1)[0].rpartition("@")[2]
    return f"{scheme}://{host}" if rest in (host, f"{host}/") else f"{scheme}://{host}/{GONE}"
