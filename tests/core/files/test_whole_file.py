"""A file is there as a whole or not at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from core.files.whole_file import write_whole


def test_an_older_file_is_replaced_and_nothing_else_is_left(tmp_path: Path) -> None:
    file = tmp_path / "answer.json"
    write_whole(file, "older")
    write_whole(file, "größer")
    assert file.read_text(encoding="utf-8") == "größer"
    assert list(tmp_path.iterdir()) == [file]


def test_what_cannot_be_written_leaves_the_older_file(tmp_path: Path) -> None:
    file = tmp_path / "answer.json"
    write_whole(file, "older")
    with pytest.raises(UnicodeEncodeError):
        write_whole(file, "\ud800")
    assert file.read_text(encoding="utf-8") == "older"
    assert list(tmp_path.iterdir()) == [file]
