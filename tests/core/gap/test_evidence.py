"""`core.gap.evidence`: what is fitted to a recording beyond each effect by itself."""

from __future__ import annotations

from bench.calibration.planting import plant_trial
from core.effects.delay_that_grows import DelayThatGrows
from core.effects.library import library
from core.gap.basis import basis_of
from core.gap.evidence import gather
from core.gap.fit_all import one_by_one
from core.gap.windows import Windows

RUNS_OFF = 42
"""A clock that runs off: too early at first, too late in the end, so that a constant delay explains a fifth."""


def test_a_richer_shape_is_sought_although_four_other_effects_explain_more_than_the_plain_one() -> None:
    names = ("time_delay", "external_contact", "sensor_offset_step", "sensor_creep", "sensor_lowpass")
    effects = [effect for effect in library() if effect.id in names]
    evidence = gather(Windows(basis_of(plant_trial(RUNS_OFF).recording)), effects, one_by_one)
    (effect,) = evidence.best.effects
    assert isinstance(effect, DelayThatGrows)
    assert evidence.verdict == "explained"
