"""Words on a screen that no catalogue has made longer: such as stand there are names, units and states as PackML calls them."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from typing import Any

from playwright.sync_api import Page

from server.runs.packml import State
from tests.server.real_service import ROOT

MARK = "ë"
"""What words are made longer with."""
UNITS = {"kg", "mm", "min", "ms", "Hz", "rad", "mrad", "SHA", "ISO", "Nm", "kB", "MB", "GB"}
AXES = {a + b for a in "xyz" for b in "xyz"} | {a + b for a in "ft" for b in "xyz"}
MONTHS = {"Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"}
PEOPLE = {"operator", "engineer", "account", "ben"}
SCREENS = {"Tablet", "Smartphone", "PC"}
"""What a screen is called until somebody names it, in every language."""

TEXTS = """() => {
    const shown = each => each.checkVisibility() && !each.closest('script, style, [lang=en], svg, code, pre');
    return [...document.querySelectorAll('body, body *')].filter(shown).flatMap(each => [
        ...[...each.childNodes].filter(node => node.nodeType === 3).map(node => node.data),
        ...['aria-label', 'title', 'placeholder', 'alt'].map(name => each.getAttribute(name) ?? '')]) }"""


def words_of_no_catalogue(page: Page) -> set[str]:
    """Of a page whose catalogue is the longer one, beside what a cell calls things, as a whole."""
    own = UNITS | AXES | MONTHS | PEOPLE | SCREENS | {state.value for state in State}
    names = re.compile("|".join(rf"(?<!\w){re.escape(name)}(?!\w)" for name in sorted(_names(), key=len, reverse=True)))
    said = {word for text in page.evaluate(TEXTS) for word in re.findall(r"\w+", names.sub(" ", text))}
    return {word for word in said if re.fullmatch(r"[^\W\d_]{2,}", word) and MARK not in word} - own


def _names() -> set[str]:
    """Whatever cells call things: their texts, and payloads by their keys."""
    cells = [tomllib.loads(file.read_text()) for file in (ROOT / "cells").glob("*/cell.toml")]
    return {name for cell in cells for name in (*_texts(cell), *cell.get("payloads", ()))}


def _texts(content: Any) -> Iterator[str]:
    if isinstance(content, str):
        yield content
    elif isinstance(content, dict | list):
        for value in content.values() if isinstance(content, dict) else content:
            yield from _texts(value)
