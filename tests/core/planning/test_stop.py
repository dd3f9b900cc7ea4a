"""One stop as data: its label, what is refused, the shape of a wave."""

from __future__ import annotations

import numpy as np
import pytest
from pydantic import ValidationError

from core.planning.stop import Stop, Swings, Wave, wave_shape


def test_labels_are_those_of_a_recording():
    assert Stop(down=(0.0, -1.0, 0.0)).label == "y-"
    assert Stop(down=(0.6, 0.8, 0.0)).label == "free"


def test_a_rotation_without_a_number_is_repeated_as_needed():
    down = (0.0, 0.0, 1.0)
    assert Stop(down=down, swings=Swings(about="z", repetitions=None)).repeats_as_needed
    assert not Stop(down=down, swings=Swings(about="z")).repeats_as_needed
    assert not Stop(down=down).repeats_as_needed


@pytest.mark.parametrize("wrong", [{"down": (2.0, 0.0, 0.0)}, {"down": (0.0, 0.0, 1.0), "speed": 9}, {"down": (float("nan"), 0.0, 1.0)}])
def test_a_stop_from_a_file_that_cannot_be_is_refused(wrong):
    with pytest.raises(ValidationError):
        Stop.model_validate(wrong)


def test_a_wave_is_at_rest_at_both_ends_and_holds_its_band():
    shape = wave_shape(Wave(lowest_hz=2.0, highest_hz=8.0, seconds=10.0), 6, 0.002)
    assert np.abs(shape[[0, 1, -2, -1]]).max() < 1e-7
    assert np.abs(np.gradient(shape, 0.002, axis=0)).max(axis=0) == pytest.approx(np.ones(6))
    power = np.abs(np.fft.rfft(shape, axis=0)) ** 2
    frequency = np.fft.rfftfreq(len(shape), 0.002)
    inside = (frequency > 1.0) & (frequency < 9.0)
    assert power[inside].sum() > 0.99 * power.sum()
