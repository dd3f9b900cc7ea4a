"""The disk that the data folder lies on: what is free, what that is enough for, and what takes the rest."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Literal

from pydantic import Field

from server.http.schemas import Answer
from server.runs.releases import BYTES_A_SECOND, SPARE_BYTES
from server.settings import STORE_FILE, Settings

LITTLE_S = 3600.0
"""Of robot time; a disk with room for less is worth a warning: a run takes minutes."""

PartName = Literal["recordings", "reports", "trials", "cells", "database", "other"]


class DiskPart(Answer):
    """What takes room in the data folder."""

    name: PartName = Field(description="What it is; `other` is whatever else lies in the data folder.")
    size_bytes: int = Field(description="Of all its files, bytes.", examples=[52_428_800])
    files: int = Field(description="How many.", examples=[12])


class Disk(Answer):
    """Room for what runs leave behind. A run is refused its release where the disk has too little for it (`runs-disk-too-full`)."""

    free_bytes: int = Field(description="Room on the disk that the data folder lies on, bytes.", examples=[81_604_378_624])
    total_bytes: int = Field(description="Size of that disk, bytes.", examples=[250_685_575_168])
    robot_s: float = Field(description="Robot time, s, that still can be recorded.", examples=[81_000.0])
    little: bool = Field(description=f"Whether that is less than {LITTLE_S:.0f} s.")
    parts: list[DiskPart] = Field(description="What takes room in the data folder, the largest first.")


def read_disk(settings: Settings) -> Disk:
    """Looks at every file of the data folder, and at the cells where they lie elsewhere."""
    usage = shutil.disk_usage(settings.data)
    robot_s = max(0.0, (usage.free - SPARE_BYTES) / BYTES_A_SECOND)
    return Disk(free_bytes=usage.free, total_bytes=usage.total, robot_s=robot_s, little=robot_s < LITTLE_S, parts=_measure_parts(settings))


def _measure_parts(settings: Settings) -> list[DiskPart]:
    folders: dict[Path, PartName] = {
        settings.recordings_folder: "recordings",
        settings.reports_folder: "reports",
        settings.trials_folder: "trials",
        settings.cells_folder: "cells",
    }
    sizes: dict[PartName, list[int]] = {name: [] for name in (*folders.values(), "database", "other")}
    for folder, name in folders.items():
        sizes[name] += _sizes(folder)
    for entry in settings.data.iterdir():
        if entry not in folders:
            sizes["database" if entry.name.startswith(STORE_FILE) else "other"] += _sizes(entry)
    parts = [DiskPart(name=name, size_bytes=sum(each), files=len(each)) for name, each in sizes.items() if each]
    return sorted(parts, key=lambda part: -part.size_bytes)


def _sizes(place: Path) -> Iterator[int]:
    """Of a file, or of all files in a folder; what vanishes meanwhile counts for nothing."""
    for file in [place] if place.is_file() else place.rglob("*"):
        try:
            if file.is_file() and not file.is_symlink():
                yield file.stat().st_size
        except FileNotFoundError:
            continue
