"""The clock's line against a generator that knows offset, drift and delays."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.array import Array
from core.errors import BadState
from core.sensors.clock import ClockLine, DeviceClock

Delays = Callable[[np.random.Generator, int], Array]


def listen(
    rng: np.random.Generator, *, seconds: float, rate_hz: float, offset_s: float, drift: float, delays: Delays, lost: float = 0.0
) -> DeviceClock:
    """A clock that has heard of samples in the order of their arrival."""
    true = np.arange(int(seconds * rate_hz)) / rate_hz
    arrivals = true + delays(rng, true.size)
    kept = np.flatnonzero(rng.random(true.size) >= lost)
    clock = DeviceClock("sensor")
    for k in kept[np.argsort(arrivals[kept])]:
        clock.add((true[k] * (1.0 + drift)) - offset_s, arrivals[k])
    return clock


def mapping_error_s(line: ClockLine, at_s: float, offset_s: float, drift: float) -> float:
    return line.to_here(at_s * (1.0 + drift) - offset_s) - at_s


JITTERS = {
    "uniform": lambda rng, n: rng.uniform(0.0, 0.020, n),
    "exponential": lambda rng, n: rng.exponential(0.020, n),
    "half normal": lambda rng, n: np.abs(rng.normal(0.0, 0.020, n)),
}


@pytest.mark.parametrize("kind", JITTERS)
@pytest.mark.parametrize("drift", [0.0, 90e-6, -90e-6])
def test_offset_and_drift_are_found_to_half_a_millisecond_under_jitter_and_loss(kind: str, drift: float):
    offset = 86_400.25
    clock = listen(np.random.default_rng(3), seconds=20.0, rate_hz=1000.0, offset_s=offset, drift=drift, delays=JITTERS[kind], lost=0.05)
    assert max(abs(mapping_error_s(clock.line, at, offset, drift)) for at in (10.0, 15.0, 20.0)) < 0.5e-3
    assert clock.line.spread_s == pytest.approx(np.median(JITTERS[kind](np.random.default_rng(1), 100_000)), rel=0.25)


def test_before_the_drift_can_be_told_none_is_assumed():
    clock = listen(np.random.default_rng(0), seconds=1.9, rate_hz=500.0, offset_s=0.0, drift=50e-6, delays=JITTERS["uniform"])
    assert clock.line.drift == 0.0
    assert abs(mapping_error_s(clock.line, 1.9, 0.0, 50e-6)) < 0.5e-3


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 2**32 - 1), st.floats(-80e-6, 80e-6), st.floats(-1e6, 1e6))
def test_no_sample_is_mapped_to_later_than_it_arrived(seed: int, drift: float, offset: float):
    rng = np.random.default_rng(seed)
    clock = listen(rng, seconds=12.0, rate_hz=50.0, offset_s=offset, drift=drift, delays=lambda r, n: 0.001 + r.exponential(0.01, n))
    true = np.arange(600) / 50.0
    assert (np.array([mapping_error_s(clock.line, at, offset, drift) for at in true]) < 0.06).all()
    assert clock.line.to_device(clock.line.to_here(3.0)) == pytest.approx(3.0, abs=1e-6)


def test_a_clock_that_is_set_is_noticed():
    early, late = DeviceClock("sensor"), DeviceClock("sensor")
    with pytest.raises(BadState, match=r"jumped by -2\.00 s"):
        for k in range(8000):
            early.add(k / 1000 + (2.0 if k > 5000 else 0.0), k / 1000)
    with pytest.raises(BadState, match=r"jumped by 1\.00 s"):
        for k in range(20_000):
            late.add(k / 1000 - (1.0 if k > 10_000 else 0.0), k / 1000)


def test_a_second_without_samples_that_come_all_at_once_later_is_no_jump():
    clock = DeviceClock("sensor")
    for k in range(10_000):
        at = k / 1000
        clock.add(at, max(at, 6.0) if 5.0 < at <= 6.0 else at)
    assert clock.line.to_here(9.0) == pytest.approx(9.0, abs=1e-6)


def test_a_device_that_sends_at_another_rate_than_it_says_is_told():
    clock = DeviceClock("sensor")
    with pytest.raises(BadState, match="slower than it says"):
        for k in range(20_000):
            clock.add(k / 1000, k / 990)
            _ = clock.line
