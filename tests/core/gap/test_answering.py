"""`core.gap.answering`: what is read off the recording stands beside an effect only where it is something of its own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import cast

import numpy as np
import pytest

from core.effects.effect import Effect, Finding, Symptom
from core.effects.library import library, symptoms
from core.gap.answer import Verdict
from core.gap.answering import concerns
from core.gap.evidence import Evidence
from core.gap.symptoms import Observed


@dataclass(frozen=True)
class _Fit:
    effects: tuple[Effect, ...]


@dataclass(frozen=True)
class _Answered:
    """As much of the evidence as the rule looks at."""

    verdict: Verdict
    best: _Fit


def _evidence(verdict: Verdict, *names: str) -> Evidence:
    effects = tuple(effect for effect in library() if effect.id in names)
    assert len(effects) == len(names)
    return cast(Evidence, _Answered(verdict, _Fit(effects)))


def _seen(name: str) -> Observed:
    symptom: Symptom = next(symptom for symptom in symptoms() if symptom.id == name)
    return Observed(symptom, Finding(np.zeros(1), np.ones(1), 50.0, True, "It is there."), {})


@pytest.mark.parametrize("swinging", ["payload_loose", "joint_elasticity", "tool_flexibility"])
def test_what_swings_in_the_holds_is_not_taken_for_noise_of_the_sensor_besides(swinging: str) -> None:
    assert not concerns(_seen("sensor_noise"), _evidence("explained", swinging))


def test_noise_is_named_beside_an_effect_that_cannot_look_like_it() -> None:
    assert concerns(_seen("sensor_noise"), _evidence("explained", "time_delay"))
    assert concerns(_seen("sensor_noise"), _evidence("no_gap"))


def test_friction_is_named_beside_what_swings() -> None:
    assert concerns(_seen("joint_friction"), _evidence("explained", "payload_loose"))


def test_the_reference_is_doubted_only_where_nothing_acts_on_the_wrench() -> None:
    assert concerns(_seen("payload_mismatch"), _evidence("no_gap"))
    assert not concerns(_seen("payload_mismatch"), _evidence("explained", "time_delay"))
    assert not concerns(_seen("payload_mismatch"), _evidence("unknown"))


def test_every_effect_that_a_symptom_may_be_taken_for_exists() -> None:
    known = {effect.id for effect in library()}
    assert {name for symptom in symptoms() for name in symptom.resembled_by} <= known
