"""The words of every message, one folder of Fluent files (projectfluent.org) for each language: a new language is a new folder.

The console reads the same files. What numbers look like in them is said by functions that both have: `FIXED($x, digits: 2)`,
`SIGNIFICANT($x, digits: 3)`, `MILLI($x_s, digits: 0)` (thousandths: m as mm, s as ms), `DEGREES($x_rad, digits: 1)` and
`PERCENT($x, digits: 0)`; `PERSON($who)` is how people call who did something.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Mapping
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

FLAW = "flaw"
PERSON = "PERSON"
FOLDER = Path(__file__).parent


def _find_languages() -> tuple[str, ...]:
    """English, then every other language that has a folder with words, by its code."""
    others = sorted(file.parent.name for file in FOLDER.glob(f"*/{FLAW}.ftl") if file.parent.name != "en")
    return ("en", *others)


LANGUAGES = _find_languages()
if TYPE_CHECKING:
    from fluent.runtime import FluentBundle

    Language = str
else:
    Language = Literal[LANGUAGES]


def format_message(code: str, parameters: Mapping[str, bool | float | str], language: Language) -> str:
    """A message's words. One without words of its own, only `found` and `expected`, is a flaw and says where it is.

    A code that no catalogue has is said as it is: a message that cannot be worded must not hide what happened.
    """
    bundle = read_catalogue(language, code)
    if not bundle.has_message(code):
        return f"{code} {dict(parameters)}" if parameters else code
    if bundle.get_message(code).value is not None:
        return _format(bundle, code, None, parameters)
    parts = {part: _format(bundle, code, part, parameters) for part in ("found", "expected")}
    return _format(read_catalogue(language, FLAW), FLAW, None, {"where": parameters.get("where", ""), **parts})


def format_part(code: str, part: str, parameters: Mapping[str, bool | float | str], language: Language) -> str:
    """The words of one part of a message; all of them where it has no such part."""
    bundle = read_catalogue(language, code)
    if bundle.has_message(code) and part in bundle.get_message(code).attributes:
        return _format(bundle, code, part, parameters)
    return format_message(code, parameters, language)


def read_catalogue(language: Language, code: str) -> FluentBundle:
    """The messages of the file that has this one: its name is what the code begins with, up to the first hyphen."""
    name = code.partition("-")[0]
    return _read_file(language, name if name.isalnum() and (FOLDER / language / f"{name}.ftl").is_file() else FLAW)


def load_catalogue(language: Language) -> None:
    """Reads all files at once, for a process that must not wait for them later."""
    for file in sorted((FOLDER / language).glob("*.ftl")):
        _read_file(language, file.stem)


@cache
def _read_file(language: Language, name: str) -> FluentBundle:
    """The library is loaded when the first message is worded, and each file when it is needed: most processes never word one."""
    from fluent.runtime import FluentBundle, FluentResource  # noqa: PLC0415 - most processes never word a message

    functions: dict[str, Callable[..., Any]] = {function: partial(format_number, language) for function, format_number in NUMBERS.items()}
    functions[PERSON] = _name_person
    bundle = FluentBundle([language], use_isolating=False, functions=functions)
    bundle.add_resource(FluentResource((FOLDER / language / f"{name}.ftl").read_text(encoding="utf-8")))
    return bundle


def find_language() -> Language:
    """The language of the terminal: `HEFT_LANGUAGE`, else the system's (`LC_ALL`, `LC_MESSAGES`, `LANG`), else English."""
    for name in ("HEFT_LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG"):
        wanted = os.environ.get(name, "")
        if wanted:
            primary = re.split(r"[_.@-]", wanted.lower())[0]
            return primary if primary in LANGUAGES else "en"
    return "en"


def _format(bundle: FluentBundle, code: str, part: str | None, parameters: Mapping[str, bool | float | str]) -> str:
    from fluent.runtime.types import fluent_number  # noqa: PLC0415 - as above

    entry = bundle.get_message(code)
    pattern = entry.value if part is None else entry.attributes[part]
    if pattern is None:
        return ""
    said: dict[str, Any] = {}
    for name, value in parameters.items():
        if isinstance(value, bool):
            said[name] = str(value).lower()
        elif isinstance(value, str) or not math.isfinite(value):
            said[name] = str(value)
        else:
            said[name] = fluent_number(value, useGrouping=False)
    text, _ = bundle.format_pattern(pattern, said)
    return str(text)


def _fixed(language: Language, value: Any, digits: Any = 2, *, factor: float = 1.0) -> str:
    try:
        shown = f"{factor * float(value):.{int(digits)}f}"
    except (TypeError, ValueError):
        return str(value)
    return _mark(shown[1:] if shown.startswith("-") and not shown.strip("-0.") else shown, language)


def _significant(language: Language, value: Any, digits: Any = 3) -> str:
    try:
        mantissa, e, exponent = f"{float(value):.{int(digits)}g}".partition("e")
    except (TypeError, ValueError):
        return str(value)
    return _mark(mantissa + (f"e{int(exponent)}" if e else ""), language)


def _name_person(who: Any) -> str:
    """Accounts by their name alone; machines say that they are some: `account:anna` is anna, `key:line-3` stays."""
    return str(who).removeprefix("account:")


def _mark(shown: str, language: Language) -> str:
    return shown.replace(".", decimal_mark(language))


@cache
def decimal_mark(language: Language) -> str:
    """What a language writes between the whole and the rest of a number."""
    from babel.numbers import get_decimal_symbol  # noqa: PLC0415 - as above: most processes never word a message

    return get_decimal_symbol(language)


NUMBERS: dict[str, Callable[..., str]] = {
    "FIXED": _fixed,
    "SIGNIFICANT": _significant,
    "MILLI": partial(_fixed, digits=0, factor=1e3),
    "DEGREES": partial(_fixed, digits=1, factor=180.0 / math.pi),
    "PERCENT": partial(_fixed, digits=0, factor=100.0),
}
