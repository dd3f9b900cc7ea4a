"""A protected zone somewhere else for a while."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime

from core.cell.folder import load_cell
from tests.server.real_service import ROOT, Console

AT_THE_ROBOT = (0.95, 0.0, 0.625)
"""Where the zone of `lwr4_bench` reaches into the robot at home."""


@contextmanager
def zone_at(person: Console, xyz_m: tuple[float, float, float]) -> Iterator[str]:
    """The protected zone of `lwr4_bench` is there; back where it was afterwards."""
    [zone] = load_cell(ROOT / "cells" / "lwr4_bench").zones
    try:
        _place(person, zone.name, xyz_m)
        yield zone.name
    finally:
        _place(person, zone.name, zone.shape.pose.xyz_m)


def _place(person: Console, zone: str, xyz_m: tuple[float, float, float]) -> None:
    body = {"pose": {"xyz_m": xyz_m}, "measured_at": datetime.now(UTC).isoformat()}
    answer = person.http.put(f"/api/cells/lwr4_bench/zones/{zone}", json=body)
    assert answer.status_code == 200, answer.text
