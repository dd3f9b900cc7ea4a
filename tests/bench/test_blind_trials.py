"""`bench.blind_trials`: cells of robots that others have described, for the blind check."""

from __future__ import annotations

from pathlib import Path

from bench.blind_trials import ARMS, make_cells
from core.cell.folder import load_cell


def test_each_arm_gets_a_cell_with_payloads_that_is_left_alone_the_next_time(tmp_path: Path) -> None:
    folders = make_cells(tmp_path)
    cells = [load_cell(folder) for folder in folders]
    assert [cell.name for cell in cells] == list(ARMS)
    assert all(set(cell.payloads) == {"steel_block", "cylinder"} for cell in cells)
    made = [(folder / "cell.toml").stat().st_mtime_ns for folder in folders]
    assert [(folder / "cell.toml").stat().st_mtime_ns for folder in make_cells(tmp_path)] == made
