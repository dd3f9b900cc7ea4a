"""Vibrations against wrenches of a point mass: `m a` and its lever arm, by Newton and nothing else."""

from __future__ import annotations

import numpy as np
import pytest

from core.effects.effect import Finding, View
from core.effects.structure_vibration import StructureVibration
from core.recording.recording import Recording, SensorDescription

Array = np.ndarray
STEP = 0.025
NOISE = np.array([0.05, 0.05, 0.05, 0.002, 0.002, 0.002])
MASS, CENTRE = 1.3, np.array([0.01, -0.02, 0.09])
T = STEP * np.arange(1200)
RECORDING = Recording(t=T, gravity=np.array([0.0, 0.0, -9.81]), wrench=np.zeros((len(T), 6)), sensor=SensorDescription(noise_std=NOISE))


def seen(left: Array, expected: Array | None = None, t: Array = T) -> Finding | None:
    phi = np.concatenate(([MASS], MASS * CENTRE, np.full(6, 0.01)))
    noise = 0.3 * NOISE * np.random.default_rng(1).normal(size=left.shape)
    view = View((), NOISE, phi, np.zeros(10), left + noise, np.zeros_like(left) if expected is None else expected, t)
    return StructureVibration().observe(RECORDING, view)


def shaken(hz: float, size: float, at: Array = CENTRE) -> Array:
    """The wrench that it takes to shake a point mass along a direction, as windows of a cubic B-spline show it."""
    force = MASS * size * np.sinc(hz * STEP) ** 4 * np.outer(np.sin(2.0 * np.pi * hz * T), [0.6, 0.0, 0.8])
    return np.hstack((force, np.cross(at, force)))


@pytest.mark.parametrize("hz", [3.0, 5.0, 12.0])
def test_a_floor_that_shakes_is_found_with_frequency_and_acceleration(hz: float) -> None:
    finding = seen(shaken(hz, 0.4))
    assert finding is not None
    assert finding.material
    assert finding.theta[0] == pytest.approx(hz, abs=0.1)
    assert finding.theta[1:] == pytest.approx([0.24, 0.0, 0.32], abs=0.03)
    assert f"{hz:.1f} Hz" in finding.message.text
    assert f"{hz:.1f} Hz" in StructureVibration().advice(finding).text


def test_blows_that_ring_for_a_moment_are_found_too() -> None:
    decay = sum(np.where(at < T, np.exp(-(T - at) / 0.25), 0.0) for at in (3.0, 8.0, 14.0, 22.0))
    finding = seen(shaken(12.0, 4.0) * np.asarray(decay)[:, None])
    assert finding is not None
    assert finding.theta[0] == pytest.approx(12.0, abs=0.3)


def test_what_shakes_elsewhere_than_at_the_mass_is_no_vibration_of_the_structure() -> None:
    assert seen(shaken(5.0, 0.4, at=np.array([0.0, 0.1, 0.0]))) is None


def test_a_motion_that_the_twin_knows_of_and_predicts_late_is_none() -> None:
    known = shaken(3.0, 8.0)
    assert seen(np.roll(known, 1, axis=0) - known, known) is None


def test_noise_is_none_and_neither_is_a_load_that_wanders_or_too_little() -> None:
    wander = np.cumsum(np.random.default_rng(2).normal(size=(len(T), 3)), axis=0) * 0.05
    assert seen(np.zeros((len(T), 6))) is None
    assert seen(np.hstack((wander, np.cross(CENTRE, wander)))) is None
    assert seen(np.zeros((20, 6)), t=T[:20]) is None
    assert seen(np.zeros((0, 6)), t=T[:0]) is None
