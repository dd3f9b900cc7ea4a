"""What is planted, and its seal."""

from __future__ import annotations

from core.trial.draw import CELLS, draw


def test_the_same_seed_plants_the_same_and_its_seal_holds():
    drawn = draw(11)
    assert draw(11).sealed.hash == drawn.sealed.hash
    assert drawn.sealed.model_copy(update={"size": drawn.sealed.size + 1e-6}).hash != drawn.sealed.hash


def test_trials_are_of_every_kind_in_both_cells():
    drawn = [draw(seed).sealed for seed in range(60)]
    assert {sealed.kind for sealed in drawn} == {"none", "single", "double", "unknown"}
    assert {sealed.cell for sealed in drawn} == set(CELLS)
    assert all(len(sealed.ids) == {"none": 0, "double": 2}.get(sealed.kind, 1) for sealed in drawn)
    assert all(len(sealed.planted) == len(sealed.ids) for sealed in drawn)
