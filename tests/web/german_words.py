"""The German catalogue of what the engine says, read as the text that it is."""

from __future__ import annotations

import ast
import re

from tests.server.real_service import ROOT

_QUOTED = r"""'(?:[^'\\\n]|\\.)*'|"(?:[^"\\\n]|\\.)*\""""
_ENTRY = re.compile(rf"^  ({_QUOTED}|\w+):\s+({_QUOTED}),$", re.MULTILINE)


def german(part: str) -> dict[str, str]:
    """English phrases with how German says them, of `flaws` or `sentences`."""
    text = (ROOT / "web" / "src" / "words" / f"de-{part}.ts").read_text()
    body = text[text.index("= {") : text.rindex("};")]
    found = {_plain(english): _plain(said) for english, said in _ENTRY.findall(body)}
    assert len(found) == len(re.findall(r",$", body, re.MULTILINE)), "an entry that this cannot read"
    return found


def _plain(word: str) -> str:
    return str(ast.literal_eval(word)) if word[0] in "'\"" else word
