"""Which code made a result: the release, and a digest of the engine's sources."""

from __future__ import annotations

from functools import cache
from hashlib import sha256
from pathlib import Path

ENGINE = Path(__file__).parent
DIGITS = 10


@cache
def code_version() -> str:
    """Such as `0.1.0+3f9c2ab17d`: the release, then the first digits of the SHA-256 of the sources in the order of their paths.

    Two results that bear the same were made by the same engine, whether it was installed or checked out.
    """
    digest = sha256()
    for file in sorted(ENGINE.rglob("*.py")):
        digest.update(f"{file.relative_to(ENGINE).as_posix()}\n".encode())
        digest.update(file.read_bytes())
    return f"{release_version()}+{digest.hexdigest()[:DIGITS]}"


@cache
def release_version() -> str:
    """Such as `0.1.0`."""
    from importlib.metadata import PackageNotFoundError, version  # noqa: PLC0415 - slow to import, and hardly ever asked for

    try:
        return version("heft")
    except PackageNotFoundError:  # a checkout that was never installed
        return "0"
