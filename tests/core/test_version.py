"""The version tells one engine from another, whatever the folder is called."""

from __future__ import annotations

import re

import pytest

from core import version


def test_it_has_the_release_and_a_digest_that_follows_the_sources(tmp_path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert re.fullmatch(r"\d+\.\d+\.\d+\+[0-9a-f]{10}", version.code_version())
    found = []
    for folder, text in (("a", "x = 1"), ("b", "x = 1"), ("c", "x = 2")):
        (tmp_path / folder / "inner").mkdir(parents=True)
        (tmp_path / folder / "inner" / "file.py").write_text(text)
        monkeypatch.setattr(version, "ENGINE", tmp_path / folder)
        found.append(version.code_version.__wrapped__())
    assert found[0] == found[1] != found[2]
