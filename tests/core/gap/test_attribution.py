"""`core.gap.attribution` on fits that are made up: only how well they predict, and with how many parameters, is told."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.delay_that_wanders import DelayThatWanders
from core.effects.effect import Parameter
from core.effects.library import library
from core.gap.attribution import choose_variants, probabilities
from core.gap.effect_fit import EffectFit
from core.gap.weighing import count, find_left_share, read_figures, weigh_numbers

BY_ID = {effect.id: effect for effect in library()}
ROWS = 2000
NONE = np.zeros(0)


def fit(name: str, left_sigma2: float, parameters: int = 5) -> EffectFit:
    """Effects joined by a plus sign that leave so much chi-square per row beyond what noise leaves."""
    effects = tuple(BY_ID[part] for part in name.split("+")) if name else ()
    held_out = np.full((6, ROWS), 1.0 + left_sigma2)
    flat = np.zeros((6, ROWS))
    return EffectFit(effects, (), np.zeros(parameters), NONE, NONE, NONE, flat, 0.0, 0.0, held_out, flat)


def weighed(*fits: EffectFit, before: float = 100.0) -> dict[str, float]:
    """Probabilities by name; `before` is what the nominal twin leaves."""
    none, unknown, shares = probabilities(fit("", before, 0), list(fits))
    found = {"none": none, "unknown": unknown} | {it.name: share for it, share in zip(fits, shares, strict=True)}
    assert sum(found.values()) == pytest.approx(1.0)
    return found


def test_a_gap_that_an_effect_closes_to_the_noise_is_that_effect():
    assert weighed(fit("base_tilt", 0.0), fit("time_delay", 40.0))["base_tilt"] > 0.9


def test_the_more_is_left_over_the_less_certain_is_the_name():
    """Parts per thousand of the gap that are left over may be another shape of the same effect, or another effect."""
    lefts = (0.0, 0.2, 1.0, 5.0, 20.0)
    shares = [weighed(fit("base_tilt", left), fit("time_delay", 80.0))["base_tilt"] for left in lefts]
    assert shares == sorted(shares, reverse=True)
    assert shares[3] < shares[0] - 0.1
    each = [count(fit("", 100.0, 0), [fit("base_tilt", left), fit("time_delay", 80.0)]) for left in lefts]
    taught = [float(weigh_numbers(numbers, read_figures().figures)[2]) for numbers in each]
    assert taught == sorted(taught, reverse=True)
    assert taught[2] < taught[0] - 0.1  # by trials alone, whose causes have shapes that the library has


def test_where_nothing_explains_the_gap_it_is_unknown_but_never_for_certain():
    """Shares of a rest that is some effect of the library in a shape that it does not have."""
    found = weighed(fit("base_tilt", 90.0), fit("time_delay", 95.0))
    assert max(found, key=found.__getitem__) == "unknown"
    assert 0.5 < found["unknown"] < 0.95


def test_many_parameters_do_not_lose_to_few_that_fit_worse_by_far_where_they_fit_down_to_the_noise():
    """A wrong model may bend, but not exactly onto the noise: the gap is 12 000 times 100, the few leave 0.1 % of it."""
    assert weighed(fit("sensor_crosstalk", 0.0, 31), fit("sensor_hysteresis", 0.1, 13))["sensor_crosstalk"] > 0.9


def test_of_two_that_predict_alike_the_smaller_is_named():
    assert weighed(fit("sensor_crosstalk", 0.0, 31), fit("sensor_gain", 0.0, 12))["sensor_gain"] > 0.9


def test_two_effects_that_leave_a_remainder_are_not_believed():
    """Together they bend onto much: what one effect may leave is too much for two."""
    nominal, alone = fit("", 100.0, 0), fit("base_tilt", 30.0)
    pair = fit("base_tilt+joint_offset", 4.0, 20)
    assert find_left_share(nominal, pair) < 0.1
    found = weighed(alone, pair)
    assert max(found, key=found.__getitem__) == "unknown"
    assert weighed(alone, fit("base_tilt+joint_offset", 0.0, 20))["base_tilt+joint_offset"] > 0.9


def test_of_two_shapes_one_that_merely_follows_the_run_is_taken_only_where_it_is_clearly_more_probable():
    """What a tilt beside it has left of a delay: a fifth of that is no reason for a delay that wanders, nine tenths are."""
    change = Parameter("knot_1_s", "s", 0.0, -0.1, 0.1, 0.003, shown=False)
    plain = fit("time_delay", 10.0, 1)
    for left, taken in ((8.0, "TimeDelay"), (1.0, "DelayThatWanders")):
        wanders = replace(fit("time_delay", left, 2), effects=(DelayThatWanders(),), parameters=(replace(change, shown=True), change))
        (chosen,) = choose_variants(fit("", 100.0, 0), [wanders, plain])
        assert type(chosen.effects[0]).__name__ == taken
