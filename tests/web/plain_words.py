"""Words on a screen that no catalogue has made longer: such as stand there are names, units and states as PackML calls them."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from typing import Any

from playwright.sync_api import Page

from server.packml import State
from tests.server.real_service import ROOT

MARK = "ë"
"""What words are made longer with."""
UNITS = {"kg", "mm", "min", "ms", "Hz", "rad", "mrad", "SHA", "ISO", "Nm"}
AXES = {a + b for a in "xyz" for b in "xyz"} | {a + b for a in "ft" for b in "xyz"}
MONTHS = {"Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"}
PEOPLE = {"operator", "engineer", "account"}

WORDS = """() => {
    const shown = each => each.checkVisibility() && !each.closest('script, style, [lang=en], svg, code, pre');
    const texts = [...document.querySelectorAll('body, body *')].filter(shown).flatMap(each => [
        ...[...each.childNodes].filter(node => node.nodeType === 3).map(node => node.data),
        ...['aria-label', 'title', 'placeholder', 'alt'].map(name => each.getAttribute(name) ?? '')]);
    return texts.flatMap(text => text.match(/[\\p{L}\\p{N}_]+/gu) ?? []) }"""


def words_of_no_catalogue(page: Page) -> set[str]:
    """Of a page whose catalogue is the longer one."""
    own = _data() | UNITS | AXES | MONTHS | PEOPLE | {state.value for state in State}
    said = {word for word in page.evaluate(WORDS) if re.fullmatch(r"[^\W\d_]{2,}", word)}
    return {word for word in said if MARK not in word} - own


def _data() -> set[str]:
    """Whatever cells call things."""
    contents = [tomllib.loads(file.read_text()) for file in (ROOT / "cells").glob("*/cell.toml")]
    return {word for content in contents for text in _strings(content) for word in re.findall(r"[^\W\d_]+", text)}


def _strings(content: Any) -> Iterator[str]:
    if isinstance(content, str):
        yield content
    elif isinstance(content, dict):
        yield from content
        for value in content.values():
            yield from _strings(value)
    elif isinstance(content, list):
        for value in content:
            yield from _strings(value)
