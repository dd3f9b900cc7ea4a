"""Names of columns: what is left without the unit and the spaces, and the unit."""

from __future__ import annotations

import re
from collections.abc import Iterable

WITH_UNIT = re.compile(r"(.*?)[\s_]*[\[(]\s*([^\])]*?)\s*[\])]\s*")


def bare_name(name: str) -> str:
    """`Force X [N]` is `Force_X`; namespaces of topics are kept as dots."""
    match = WITH_UNIT.fullmatch(name)
    return re.sub(r"[\s/]+", "_", (match[1] if match else name).strip().strip("/"))


def unit_of(name: str, units: Iterable[str]) -> str | None:
    """That of the units which the name bears in brackets; None where it bears none of them."""
    match = WITH_UNIT.fullmatch(name)
    plain = {_plain(unit): unit for unit in units}
    return plain.get(_plain(match[2])) if match else None


def _plain(unit: str) -> str:
    return re.sub(r"[\s·*.\-]", "", unit.replace("°", "deg").replace("µ", "u")).casefold()
