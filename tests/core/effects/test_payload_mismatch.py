"""The payload against its reference: only what is large and certain is material."""

from __future__ import annotations

import numpy as np
import pytest

from core.effects.effect import Finding, View
from core.effects.payload_mismatch import PayloadMismatch
from core.payload.inertia import InertialParameters
from core.recording.recording import Recording

REFERENCE = InertialParameters.from_com(2.4, [0.01, -0.02, 0.08], np.diag([0.006, 0.007, 0.004]))
STD = np.array([1e-3, *[1e-4] * 3, *[5e-5] * 6])


def observe(phi: np.ndarray, std: np.ndarray = STD, reference: InertialParameters | None = REFERENCE) -> Finding | None:
    recording = Recording(t=np.arange(3.0), gravity=np.array([0, 0, -9.81]), reference=reference, reference_source="CAD")
    return PayloadMismatch().observe(recording, View((), np.ones(6), phi, std))


def other(**changes: float) -> np.ndarray:
    """The reference with some of its parameters multiplied."""
    phi = REFERENCE.phi.copy()
    for index, factor in changes.items():
        phi[int(index[1:])] *= factor
    return phi


def test_without_a_reference_or_an_estimate_there_is_nothing_to_compare() -> None:
    assert observe(REFERENCE.phi, reference=None) is None
    assert observe(np.full(10, np.nan), np.full(10, np.nan)) is None


def test_the_same_payload_is_no_mismatch() -> None:
    finding = observe(REFERENCE.phi)
    assert finding is not None
    assert not finding.material
    assert finding.sigma < 0


@pytest.mark.parametrize(
    ("phi", "std", "material"),
    [
        (other(_0=1.02), STD, True),
        (other(_0=1.005), STD, False),  # certain, yet small
        (other(_0=1.02), 30 * STD, False),  # large, yet uncertain
        (other(_3=1.02), STD, True),
        (other(_3=1.004), STD, False),
        (other(_4=1.05), STD, True),
        (other(_4=1.02), STD, False),
    ],
)
def test_a_mismatch_is_material_when_it_is_large_and_certain(phi: np.ndarray, std: np.ndarray, material: bool) -> None:
    finding = observe(phi, std)
    assert finding is not None
    assert finding.material == material
    np.testing.assert_allclose(finding.theta, phi - REFERENCE.phi)


def test_what_was_not_determined_does_not_count() -> None:
    phi, std = other(_0=1.02), STD.copy()
    phi[4:], std[4:] = np.nan, np.nan
    finding = observe(phi, std)
    assert finding is not None
    assert finding.material
    assert np.isnan(finding.theta[4:]).all()
    assert "2.0 % heavier" in finding.message.text
    assert "inertia" not in finding.message.text
    assert "48 g heavier" in PayloadMismatch().advice(finding).text


def test_a_centred_payload_is_compared_on_a_lever_of_a_millimetre() -> None:
    centred = InertialParameters.from_com(2.0, [0.0, 0.0, 0.0], np.diag([0.004, 0.004, 0.004]))
    phi = centred.phi.copy()
    phi[1] = 1e-6
    finding = observe(phi, 1e-3 * STD, centred)
    assert finding is not None
    assert not finding.material


def test_chance_alone_is_hardly_ever_material() -> None:
    rng = np.random.default_rng(0)
    uncertain = np.array([0.05, *[5e-3] * 3, *[1e-3] * 6])
    findings = [observe(REFERENCE.phi + uncertain * rng.normal(size=10), uncertain) for _ in range(1000)]
    assert sum(finding.material for finding in findings if finding is not None) <= 3


def test_sigma_is_on_the_scale_of_a_normal_distribution_by_chance() -> None:
    rng = np.random.default_rng(0)
    sigma = [observe(REFERENCE.phi + STD * rng.normal(size=10)).sigma for _ in range(1000)]  # type: ignore[union-attr]  # a None fails here
    assert abs(np.mean(sigma)) < 0.15
    assert 0.85 < np.std(sigma) < 1.15
