"""A run that comes in blocks of rows shows every effect exactly as the run as a whole does."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.effects.effect import Effect
from core.effects.library import library
from core.effects.memory import Memory
from core.effects.scene import Scene
from tests.core.effects.synthetic_scene import poses_only, scene

RUN = scene(seconds=4.0)
every_effect = pytest.mark.parametrize("effect", library(), ids=lambda effect: effect.id)


def drawn(effect: Effect, seed: int, run: Scene = RUN) -> np.ndarray:
    """Parameters well away from their absent values, within the bounds; what happens once happens in the middle of the run."""
    parameters = effect.parameters(run)
    rng = np.random.default_rng(seed)
    away = rng.uniform(0.3, 1.5, len(parameters)) * rng.choice([-1, 1], len(parameters))
    away = np.where([p.lower == p.absent for p in parameters], np.abs(away), away)
    away[[p.name in ("at_s", "step_time_s") for p in parameters]] = 0.0
    return np.array([np.clip(p.absent + x * p.scale, p.lower, p.upper) for p, x in zip(parameters, away, strict=True)])


def in_blocks(effect: Effect, theta: np.ndarray, edges: list[int], run: Scene = RUN) -> np.ndarray:
    """The effect's wrench, block after block, each of which knows its own rows only."""
    memory = Memory()
    blocks = []
    for begin, end in pairwise(edges):
        block = replace(run[begin:end], memory=memory)
        blocks.append(effect.wrench(block, run.nominal[begin:end], theta))
    return np.concatenate(blocks)


@every_effect
@settings(max_examples=6)
@given(seed=st.integers(0, 1000), cuts=st.sets(st.integers(1, len(RUN) - 1), max_size=40))
def test_blocks_of_any_sizes_give_the_wrench_of_the_whole(effect: Effect, seed: int, cuts: set[int]) -> None:
    theta = drawn(effect, seed)
    whole = effect.wrench(RUN, RUN.nominal, theta)
    np.testing.assert_allclose(in_blocks(effect, theta, [0, *sorted(cuts), len(RUN)]), whole, rtol=1e-9, atol=1e-9)


@every_effect
def test_one_row_at_a_time_gives_the_wrench_of_the_whole(effect: Effect) -> None:
    for seed in (1, 2):
        theta = drawn(effect, seed)
        whole = effect.wrench(RUN, RUN.nominal, theta)
        assert np.abs(whole - RUN.nominal).max() > 1e-3, "the effect does not show in this run"
        np.testing.assert_allclose(in_blocks(effect, theta, list(range(len(RUN) + 1))), whole, rtol=1e-9, atol=1e-9)


@every_effect
def test_a_batch_leaves_nothing_behind_for_the_next(effect: Effect) -> None:
    theta = drawn(effect, 3)
    np.testing.assert_array_equal(effect.wrench(RUN, RUN.nominal, theta), effect.wrench(RUN, RUN.nominal, theta))


@every_effect
def test_what_cannot_come_row_by_row_is_said_in_words(effect: Effect) -> None:
    bare = replace(poses_only(RUN), position=RUN.position)
    if effect.explain_lack(bare) is not None:
        return
    theta = drawn(effect, 4, bare)
    apart = np.abs(in_blocks(effect, theta, list(range(len(bare) + 1)), bare) - effect.wrench(bare, bare.nominal, theta)).max()
    reason = effect.explain_tie_to_run(bare)
    assert effect.explain_tie_to_run(RUN) is None
    assert (apart < 1e-9) == (reason is None), reason
    assert reason is None or reason.code == "effect-no-range"
