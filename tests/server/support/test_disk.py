"""What is left on the disk, and what takes the room, as it is on the disk."""

from __future__ import annotations

from collections import namedtuple
from pathlib import Path

import pytest

from server.settings import Settings
from server.support.disk import read_disk

Usage = namedtuple("Usage", "total used free")


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    settings = Settings(data=tmp_path / "data")
    for file, size in (("recordings/r1/samples", 5000), ("recordings/r1/manifest", 50), ("heft.sqlite", 900), ("heft.sqlite-wal", 90),
                       ("cells/bench/cell.toml", 70), ("reports/d1/page.html", 300), ("stray/file", 10)):  # fmt: skip
        path = settings.data / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b"x" * size)
    (settings.data / "recordings" / "again").symlink_to(settings.data / "recordings" / "r1" / "samples")
    return settings


def test_each_part_is_what_its_files_are_and_the_largest_stands_first(settings: Settings) -> None:
    parts = [(each.name, each.size_bytes, each.files) for each in read_disk(settings).parts]
    assert parts == [("recordings", 5050, 2), ("database", 990, 2), ("reports", 300, 1), ("cells", 70, 1), ("other", 10, 1)]


def test_cells_that_lie_elsewhere_are_counted_too(settings: Settings, tmp_path: Path) -> None:
    elsewhere = tmp_path / "elsewhere"
    (elsewhere / "bench").mkdir(parents=True)
    (elsewhere / "bench" / "cell.toml").write_bytes(b"x" * 7)
    parts = {each.name: each.size_bytes for each in read_disk(settings.model_copy(update={"cells": elsewhere})).parts}
    assert (parts["cells"], parts["other"]) == (7, 80)


@pytest.mark.parametrize(("free", "robot_s", "little"), [(0, 0, True), (50_000_000, 0, True), (4_000_000_000, 3950, False)])
def test_what_is_free_is_told_as_time_that_a_robot_may_move(
    settings: Settings, monkeypatch: pytest.MonkeyPatch, free: int, robot_s: float, little: bool
) -> None:
    monkeypatch.setattr("server.support.disk.shutil.disk_usage", lambda _: Usage(10**10, 10**10 - free, free))
    found = read_disk(settings)
    assert (found.free_bytes, found.robot_s, found.little) == (free, robot_s, little)
