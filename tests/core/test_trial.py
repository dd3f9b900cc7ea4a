"""The blind check itself."""

from __future__ import annotations

from core.trial import CELLS, draw, run_trial


def test_the_same_seed_plants_the_same_and_its_seal_holds():
    drawn = draw(11)
    assert draw(11).sealed.hash == drawn.sealed.hash
    assert drawn.sealed.model_copy(update={"size": drawn.sealed.size + 1e-6}).hash != drawn.sealed.hash


def test_trials_are_of_every_kind_in_both_cells():
    drawn = [draw(seed).sealed for seed in range(60)]
    assert {sealed.kind for sealed in drawn} == {"none", "single", "double", "unknown"}
    assert {sealed.cell for sealed in drawn} == set(CELLS)
    assert all(len(sealed.ids) == {"none": 0, "double": 2}.get(sealed.kind, 1) for sealed in drawn)


def test_a_trial_without_a_fault_is_not_called_a_gap():
    drawn = next(drawn for drawn in map(draw, range(100, 200)) if drawn.sealed.kind == "none")
    outcome = run_trial(drawn)
    assert outcome.verdict == "no_gap"
    assert outcome.right
