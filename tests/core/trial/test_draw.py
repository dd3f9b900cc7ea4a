"""What is planted, and its seal."""

from __future__ import annotations

from pathlib import Path

import pytest

from core.cell.cell import CELL_FILE
from core.cell.folder import find_cell
from core.errors import BadCell
from core.trial.draw import CELLS, draw

UR5E = "ur5e_line"
"""Its plans serve all of these tests."""


def test_the_same_seed_plants_the_same_and_its_seal_holds():
    drawn = draw(11, [UR5E])
    assert draw(11, [UR5E]).sealed.hash == drawn.sealed.hash
    assert drawn.sealed.model_copy(update={"size": drawn.sealed.size + 1e-6}).hash != drawn.sealed.hash


@pytest.mark.thorough
def test_trials_are_of_every_kind_in_both_cells():
    drawn = [draw(seed).sealed for seed in range(60)]
    assert {sealed.kind for sealed in drawn} == {"none", "single", "double", "unknown"}
    assert {sealed.cell for sealed in drawn} == set(CELLS)
    assert all(len(sealed.ids) == {"none": 0, "double": 2}.get(sealed.kind, 1) for sealed in drawn)
    assert all(len(sealed.planted) == len(sealed.ids) for sealed in drawn)


def test_they_are_drawn_from_the_cells_that_are_asked_for_by_name_or_folder():
    folder = str(find_cell(UR5E))
    assert {draw(seed, [folder]).sealed.cell for seed in range(8)} == {UR5E}


def test_a_cell_that_knows_no_payload_is_refused(tmp_path: Path):
    sound = find_cell("lwr4_bench")
    text = (sound / CELL_FILE).read_text()
    (tmp_path / CELL_FILE).write_text(text[: text.index("[payloads.")])
    (tmp_path / "robot.urdf").write_text((sound / "robot.urdf").read_text())
    with pytest.raises(BadCell, match="no payload"):
        draw(0, [str(tmp_path)])


def test_small_imperfections_of_an_arm_are_the_same_in_all_its_trials():
    drawn = [draw(seed, [UR5E]) for seed in range(3)]
    assert len({one.background[1:] for one in drawn}) == 1
    assert len({one.background[0] for one in drawn}) == 3
