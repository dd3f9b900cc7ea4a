"""A part that rubs on its slide and knocks against its stops, against `knocking_part`."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import OptimizeResult, least_squares

from core.array import Array
from core.effects.effect import Effect
from core.effects.loose_between_stops import LooseBetweenStops
from core.effects.loose_that_rubs import LooseThatRubs
from tests.core.effects.knocking_part import AXIS, MASS, PLACE, RUN, STOP, average, knock
from tests.core.effects.synthetic_scene import NOISE


@pytest.mark.parametrize(("drag", "spring", "dry"), [(8.0, 0.0, 0.0), (1.5, 250.0, 0.0), (1.0, 0.0, 2.5)])
def test_a_part_on_a_slide_adds_what_newton_says_until_and_after_it_knocks(drag: float, spring: float, dry: float) -> None:
    planted = knock(drag, spring, dry)
    theta = np.array([*(MASS * STOP * AXIS), STOP, drag, spring * STOP, dry, *PLACE])
    added = LooseThatRubs().wrench(RUN, RUN.nominal, theta) - RUN.nominal
    assert np.abs(planted[:, :3]).max() > 1.0
    assert np.square(average(added - planted)).sum() < 0.03 * np.square(average(planted)).sum()


def test_it_is_sought_along_a_slide_on_which_a_part_goes_without_knocks() -> None:
    planted, slide, effect = knock(1.0, 0.0, 2.5), LooseBetweenStops(), LooseThatRubs()

    def left(shape: Effect, x: Array) -> Array:
        return np.asarray(average(shape.wrench(RUN, RUN.nominal, x) - RUN.nominal - planted).ravel())

    def fit(shape: Effect, starts: list[Array]) -> OptimizeResult:
        scale, lower, upper = (np.array([getattr(p, name) for p in shape.parameters(RUN)]) for name in ("scale", "lower", "upper"))
        begun = sorted(starts, key=lambda x: float(left(shape, x) @ left(shape, x)))[: shape.followed]
        bounds = (lower - 1e-9, upper + 1e-9)
        fits = [least_squares(lambda x: left(shape, x), x, bounds=bounds, x_scale=scale) for x in begun]
        return min(fits, key=lambda fit: fit.cost)

    smooth = fit(slide, slide.starts(RUN, planted / NOISE))
    found = fit(effect, effect.starts_beside(RUN, planted / NOISE, smooth.x))
    assert isinstance(slide, effect.beside)
    assert found.cost < 0.2 * smooth.cost
    assert found.x[6] == pytest.approx(2.5, rel=0.1)


def test_what_moves_nothing_adds_nothing() -> None:
    effect = LooseThatRubs()
    absent = np.array([p.absent for p in effect.parameters(RUN)])
    np.testing.assert_array_equal(effect.wrench(RUN, RUN.nominal, absent), RUN.nominal)
    assert effect.explain_tie_to_run(RUN) is not None
