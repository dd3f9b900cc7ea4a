"""A hose whose friction holds, against Dahl's equation in short steps along a way that is written down here."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from core.effects.cable_drag import CableDrag
from core.effects.cable_that_sticks import CableThatSticks
from core.effects.memory import Memory
from core.effects.scene import Scene
from tests.core.effects import mechanical_truth as brisk
from tests.core.effects.plain_fit import fitted
from tests.core.effects.synthetic_scene import first_rows, scene

Array = np.ndarray
RUN = scene(seconds=9.0)
EFFECT = CableThatSticks()
GRIP = np.array([0.02, -0.03, 0.05])
RUB, YIELD = 1.5, 0.03


def rubbing(p: Array) -> Array:
    """(N, 3), N, in base axes, of a point that goes straight from each place (N, 3) to the next: Dahl's equation in 200 steps for each."""
    z, held = np.zeros(3), [np.zeros(3)]
    for here, there in pairwise(p):
        for _ in range(200):
            ds = (there - here) / 200
            z = z + (ds - np.linalg.norm(ds) * z) / YIELD
        held.append(z)
    return -RUB * np.array(held)


def reading(run: Scene, force: Array) -> Array:
    """(N, 6), of a force (N, 3), base axes, at the grip."""
    f = np.einsum("nij,ni->nj", run.rotation, force)
    return run.nominal - np.hstack([f, np.cross(GRIP, f)])


def planted(run: Scene = RUN, **values: float) -> Array:
    values = {"friction_n": RUB, "yield_m": YIELD, **dict(zip(("at_x_m", "at_y_m", "at_z_m"), GRIP, strict=True)), **values}
    return np.array([values.get(p.name, p.absent) for p in EFFECT.parameters(run)])


def place(run: Scene) -> Array:
    return run.position + np.einsum("nij,j->ni", run.rotation, GRIP)


@pytest.mark.parametrize("every", [1, 40])
def test_friction_yields_as_dahl_has_it_in_steps_of_any_length(every: int) -> None:
    run = RUN[::every]
    np.testing.assert_allclose(EFFECT.wrench(run, run.nominal, planted()), reading(run, rubbing(place(run))), atol=0.01)


def test_friction_holds_while_the_arm_rests() -> None:
    change = EFFECT.wrench(RUN, RUN.nominal, planted()) - RUN.nominal
    resting = np.flatnonzero((RUN.t > 3.1) & (RUN.t < 3.9))
    assert np.linalg.norm(change[resting, :3], axis=1).min() > 0.9 * RUB
    plain = np.where(np.arange(15) == 9, 0.0, planted())
    assert np.abs((CableDrag().wrench(RUN, RUN.nominal, plain) - RUN.nominal)[resting]).max() < 0.01


def test_friction_never_exceeds_its_size() -> None:
    change = EFFECT.wrench(RUN, RUN.nominal, planted(yield_m=0.001)) - RUN.nominal
    assert np.linalg.norm(change[:, :3], axis=1).max() <= RUB + 1e-9


def test_rows_in_blocks_give_the_friction_of_the_whole() -> None:
    memory = Memory()
    blocks = [EFFECT.wrench(replace(RUN[a:b], memory=memory), RUN.nominal[a:b], planted()) for a, b in pairwise((0, 1, 150, 151, len(RUN)))]
    np.testing.assert_allclose(np.concatenate(blocks), EFFECT.wrench(RUN, RUN.nominal, planted()), atol=1e-9)


def test_a_fit_finds_friction_and_the_distance_over_which_it_yields_where_the_plain_cable_cannot() -> None:
    run = brisk.scene()
    measured = reading(run, rubbing(place(run)))
    fit = fitted(EFFECT, measured, 0.0)
    assert fit.closure > 0.9999
    assert fit.theta[4] == pytest.approx(RUB, rel=0.02)
    assert fit.theta[9] == pytest.approx(YIELD, rel=0.05)
    assert fitted(CableDrag(), measured, 0.0).closure < 0.99


def test_without_joints_it_has_no_torsion_and_the_advice_counts_no_distance_as_friction() -> None:
    bare = replace(first_rows(RUN, 50), q=None, dq=None, jacobian=None)
    theta = planted(bare)
    assert len(theta) == 11
    assert EFFECT.wrench(bare, bare.nominal, theta).shape == (50, 6)
    assert EFFECT.advice(bare, theta).parameters["friction_n"] == pytest.approx(RUB)
