"""Several effects at once: gears that shake the links of an arm on springs."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import pytest

from core.effects.composition import Composition, Term
from core.effects.gear_ripple import GearRipple
from core.effects.joint_elasticity import JointElasticity
from tests.core.effects.mechanical_truth import Array, brisk_scene, change, rms, truth
from tests.core.effects.planted_mechanics import RATIO, RIPPLE, SOFT, SWING, rippled, swung

SPRINGS = Term(JointElasticity(), np.array([*SOFT, 1.0, SWING]))
GEARS = Term(GearRipple(), np.tile([RATIO, *RIPPLE[:2]], 7))


@lru_cache
def together() -> Array:
    return Composition([SPRINGS, GEARS]).change(brisk_scene())


def test_gears_shake_an_arm_on_springs_as_its_equation_of_motion_says() -> None:
    true = swung(geared=rippled) - truth().wrench()
    apart = sum(change(term.effect, term.theta, brisk_scene()) for term in (SPRINGS, GEARS))
    assert rms(true - apart) > 0.3 * rms(true), "the gears hardly shake the springs"
    assert rms(true - together()) < 0.25 * rms(true - apart)


@pytest.mark.parametrize("size", [1, 70])
def test_blocks_of_a_shaken_arm_give_the_wrench_of_the_whole(size: int) -> None:
    run, parts = brisk_scene(), Composition([GEARS, SPRINGS])
    found = [parts.change(run[k : k + size]) for k in range(0, 140, size)]
    np.testing.assert_allclose(np.concatenate(found), together()[:140], rtol=1e-9, atol=1e-9)
