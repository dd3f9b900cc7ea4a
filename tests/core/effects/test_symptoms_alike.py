"""What is true of every symptom that is read off raw recordings."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.effect import Symptom, View
from core.effects.sample_dropout import SampleDropout
from core.effects.sensor_interference import SensorInterference
from core.effects.sensor_noise import SensorNoise
from core.effects.sensor_quantization import SensorQuantization
from tests.core.effects.synthetic_readings import recording, seen
from tests.core.effects.test_library import check_names

SYMPTOMS = (SensorNoise(), SensorInterference(), SensorQuantization(), SampleDropout())


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("symptom", SYMPTOMS, ids=lambda symptom: symptom.id)
def test_nothing_is_seen_in_a_good_recording(symptom: Symptom, seed: int) -> None:
    assert seen(symptom, recording(seed=seed)) is None


@pytest.mark.parametrize("symptom", SYMPTOMS, ids=lambda symptom: symptom.id)
def test_names_carry_units_and_bounds_hold_the_absent_value(symptom: Symptom) -> None:
    parameters = symptom.parameters(recording())
    check_names(parameters)
    assert all(p.lower <= p.absent <= p.upper and p.scale > 0 for p in parameters)


@pytest.mark.parametrize("symptom", SYMPTOMS, ids=lambda symptom: symptom.id)
def test_a_recording_without_a_wrench_or_without_holds_shows_nothing(symptom: Symptom) -> None:
    record = recording()
    nothing = View((), np.full(6, np.nan), np.full(10, np.nan), np.full(10, np.nan))
    assert symptom.observe(replace(record, wrench=None), nothing) is None
    assert symptom.observe(record, nothing) is None
