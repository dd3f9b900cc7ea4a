"""The documents lead where they say: each link within them to a file, each anchor to a heading."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
DOCUMENTS = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")])
LINK = re.compile(r"\]\((?!\w+:)([^)#\s]*)(?:#([^)\s]+))?\)")
CODE = re.compile(r"```.*?```|`[^`\n]*`", re.DOTALL)


def anchors_of(file: Path) -> set[str]:
    """Headings as an address has them: small letters, hyphens for blanks, no other marks."""
    headings = re.findall(r"^#{1,6} (.+)$", re.sub(r"```.*?```", "", file.read_text(encoding="utf-8"), flags=re.DOTALL), re.MULTILINE)
    return {re.sub(r"\s+", "-", re.sub(r"[^\w\s-]", "", heading.lower()).strip()) for heading in headings}


@pytest.mark.parametrize("document", DOCUMENTS, ids=[str(each.relative_to(ROOT)) for each in DOCUMENTS])
def test_every_link_leads_to_a_file_and_a_heading_that_exist(document: Path):
    for address, heading in LINK.findall(CODE.sub("", document.read_text(encoding="utf-8"))):
        target = (document.parent / address).resolve() if address else document
        assert target.exists(), f"{document.name} leads to {address}, which is not there"
        assert not heading or heading in anchors_of(target), f"{document.name}: no heading #{heading} in {target.name}"


def test_there_are_links_to_follow():
    assert sum(len(LINK.findall(each.read_text(encoding="utf-8"))) for each in DOCUMENTS) > 50
