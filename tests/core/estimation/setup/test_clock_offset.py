"""Offsets of a clock that were planted by a generator of its own."""

from __future__ import annotations

import numpy as np
import pytest

from core.estimation.setup.clock_offset import estimate_clock_offset
from core.recording.recording import Recording
from tests.core.recording.logs.payload_log import log_payload


def recorded(late_s: float, seed: int, *, noise: float = 0.1, seconds: float = 20.0) -> Recording:
    made = log_payload(seconds, late_s=late_s, noise=noise, seed=seed)
    return Recording(
        t=made.t, gravity=np.array([0.0, 0.0, -9.81]), wrench=made.wrench, orientation=made.orientation, position=made.position
    )


@pytest.mark.parametrize("late_s", [-0.3, -0.0127, 0.0, 0.004, 0.21])
def test_an_offset_is_recovered_to_half_a_millisecond_within_its_uncertainty(late_s: float) -> None:
    found = estimate_clock_offset(recorded(late_s, seed=3))
    assert found is not None
    assert abs(found.late_s - late_s) < 5e-4
    assert abs(found.late_s - late_s) < 4.0 * found.std_s


def test_its_uncertainty_is_that_of_its_scatter() -> None:
    found = [estimate_clock_offset(recorded(0.01, seed, noise=0.5, seconds=10.0)) for seed in range(12)]
    scatter = float(np.std([each.late_s for each in found if each]))
    stated = float(np.mean([each.std_s for each in found if each]))
    assert 0.4 < scatter / stated < 2.0


def test_a_hand_that_rests_tells_nothing_of_clocks() -> None:
    resting = recorded(0.0, seed=1)
    still = Recording(
        t=resting.t,
        gravity=resting.gravity,
        wrench=np.tile(resting.wrench[0], (len(resting), 1)) + np.random.default_rng(1).normal(scale=0.1, size=(len(resting), 6)),
        orientation=np.tile(resting.orientation[0], (len(resting), 1, 1)),
        position=np.tile(resting.position[0], (len(resting), 1)),
    )
    assert estimate_clock_offset(still) is None
    assert estimate_clock_offset(recorded(0.0, seed=1, seconds=1.0)) is None


def test_a_hand_that_pushes_is_not_taken_for_a_clock_that_is_behind() -> None:
    pushed = recorded(0.0, seed=1)
    pushes = 40.0 * np.exp(-(((pushed.t[:, None] - [4.0, 9.0, 15.0]) / 0.4) ** 2)).sum(axis=1)
    wrench = pushed.wrench + np.outer(pushes, [1.0, 0.5, -0.5, 0.05, 0.1, 0.0])
    touched = Recording(t=pushed.t, gravity=pushed.gravity, wrench=wrench, orientation=pushed.orientation, position=pushed.position)
    assert estimate_clock_offset(touched) is None
