"""A part that knocks against its stops, against `knocking_part`."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import least_squares

from core.array import Array
from core.effects.loose_with_knocks import LooseWithKnocks
from tests.core.effects.knocking_part import AXIS, MASS, PLACE, RUN, STOP, average, knock
from tests.core.effects.synthetic_scene import NOISE


@pytest.mark.parametrize(("drag", "spring"), [(8.0, 0.0), (1.5, 250.0)])
def test_a_part_on_a_slide_adds_what_newton_says_until_and_after_it_knocks(drag: float, spring: float) -> None:
    planted = knock(drag, spring)
    theta = np.array([*(MASS * STOP * AXIS), STOP, drag, spring * STOP, *PLACE])
    added = LooseWithKnocks().wrench(RUN, RUN.nominal, theta) - RUN.nominal
    assert np.abs(planted[:, :3]).max() > 1.0
    assert np.square(average(added - planted)).sum() < 0.03 * np.square(average(planted)).sum()


def test_a_fit_finds_how_far_it_slides_and_how_much_it_moves() -> None:
    planted, effect = knock(8.0, 0.0), LooseWithKnocks()
    scale = np.array([p.scale for p in effect.parameters(RUN)])
    lower, upper = (np.array([getattr(p, name) for p in effect.parameters(RUN)]) for name in ("lower", "upper"))

    def left(x: Array) -> Array:
        return np.asarray(average(effect.wrench(RUN, RUN.nominal, x) - RUN.nominal - planted).ravel())

    begun = min((np.clip(start, lower, upper) for start in effect.starts(RUN, planted / NOISE)), key=lambda x: float(left(x) @ left(x)))
    fit = least_squares(left, begun, bounds=(lower - 1e-9, upper), x_scale=scale)
    assert 2.0 * fit.cost < 0.1 * np.square(average(planted)).sum()
    assert np.linalg.norm(fit.x[:3]) == pytest.approx(MASS * STOP, rel=0.1)
    assert fit.x[3] == pytest.approx(STOP, rel=0.1)


def test_what_moves_nothing_adds_nothing() -> None:
    effect = LooseWithKnocks()
    absent = np.array([p.absent for p in effect.parameters(RUN)])
    np.testing.assert_array_equal(effect.wrench(RUN, RUN.nominal, absent), RUN.nominal)
    assert effect.explain_tie_to_run(RUN) is not None
