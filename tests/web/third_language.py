"""A copy of what has words, with a language that Heft does not have: made of English, as somebody would who translates it."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

from fluent.syntax import FluentParser, FluentSerializer
from fluent.syntax import ast as ftl
from fluent.syntax.visitor import Transformer

from tests.server.real_service import ROOT

CODE, OWN_NAME = "eo", "Esperanto"
MARK = "ŝ"
"""Ends every text of the language, as no English one does."""
KEPT_OUT = shutil.ignore_patterns("node_modules", "dist", "__pycache__", "*.pyc", "pictures")


class Translator(Transformer):
    """Marks the words of messages, and nothing that they name."""

    def visit_TextElement(self, node: ftl.TextElement) -> ftl.TextElement:  # noqa: N802 - the library's name
        words = re.sub(r"(?<=\w)(?=\W*$)", MARK, node.value, count=1)
        return ftl.TextElement(words)


def copy_with_language(folder: Path) -> Path:
    """Copies engine, console and manual, and adds the files of a language where those of English are: nothing else changes."""
    for part in ("core", "web", "docs", "cells"):
        shutil.copytree(ROOT / part, folder / part, ignore=KEPT_OUT)
    (folder / "web" / "node_modules").symlink_to(ROOT / "web" / "node_modules")
    words = folder / "core" / "words"
    (words / CODE).mkdir()
    for file in (words / "en").glob("*.ftl"):
        resource = FluentParser(with_spans=False).parse(file.read_text(encoding="utf-8"))
        (words / CODE / file.name).write_text(FluentSerializer().serialize(Translator().visit(resource)), encoding="utf-8")
    own = folder / "web" / "src" / "words"
    for file in own.glob("en*.ts"):
        text = file.read_text(encoding="utf-8").replace("core/words/en/", f"core/words/{CODE}/").replace("'./en", f"'./{CODE}")
        (own / file.name.replace("en", CODE, 1)).write_text(re.sub(r"'([A-Z][^'\\]*)'", rf"'\1{MARK}'", text), encoding="utf-8")
    return folder
