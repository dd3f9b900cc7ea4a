"""`core.gap.materiality`: whom to believe where something acts on the wrench and the payload is not the reference."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from core.effects.library import library
from core.gap.diagnosis import examine
from core.gap.evidence import Evidence
from core.gap.fit_all import one_by_one
from core.gap.materiality import find_margins, is_doubtful, is_material
from core.payload.inertia import InertialParameters
from core.plant.mechanics import Drives
from core.recording.recording import Recording
from tests.core.gap.recorded_run import plan_of, recorded

FEW = tuple(effect for effect in library() if effect.id in ("base_tilt", "time_delay", "sensor_gain", "sensor_lowpass"))


def near_a_magnet() -> tuple[Recording, InertialParameters]:
    """A run past a magnet, which no effect describes: a gap of 1.5, and an inertia that is off. With the true payload."""
    recording = recorded("ur5e_line", magnet=0.45, drives=Drives(damping_s=0.0, friction=0.0))
    return recording, plan_of("ur5e_line", "cylinder")[0].payloads["cylinder"].parameters


def examined(reference: InertialParameters | None) -> tuple[str, Evidence, set[str]]:
    """Verdict, evidence, and what matters beside them, with that reference; of the joints, which rub less than stated, nothing."""
    recording = replace(near_a_magnet()[0], reference=reference, reference_source="CAD")
    diagnosis, evidence = examine(recording, FEW, fit_all=one_by_one)
    assert evidence is not None
    beside = {each.id for each in diagnosis.also if each.material and each.side != "joints"}
    return diagnosis.verdict, evidence, beside


@pytest.mark.thorough
def test_a_reference_that_is_off_by_far_more_than_the_gap_is_doubted_all_the_same() -> None:
    _, true = near_a_magnet()
    verdict, _, beside = examined(InertialParameters(1.3 * true.phi))
    assert verdict == "no_gap"
    assert beside == {"payload_mismatch"}


@pytest.mark.thorough
def test_without_a_reference_nobody_can_know() -> None:
    verdict, *_ = examined(None)
    assert verdict == "no_gap"


PHI = np.array([2.0, 0.03, -0.04, 0.12, 0.02, 0.001, -0.002, 0.015, 0.003, 0.01])
"""2 kg, a first moment of 0.13 kg m, a largest moment of inertia of 0.02 kg m2."""
SAMPLES = 25.0


def windows_of(reference: np.ndarray | None = None, newtons_per_kg: float = 0.0) -> SimpleNamespace:
    """Forty windows of 25 samples each; of the payload nothing but the mass moves the wrench."""
    X = np.zeros((6, 40, 26))
    X[:, :, 0] = newtons_per_kg
    return SimpleNamespace(X=X, samples_per_row=SAMPLES, basis=SimpleNamespace(reference=reference))


def fit_of(phi: np.ndarray, *, std: np.ndarray | None = None, held_out: float = 2.0) -> SimpleNamespace:
    """A fit with one effect that leaves the same chi-square in every row: a gap of 1.02, as long as nothing else is said."""
    return SimpleNamespace(
        phi=phi, phi_std=1e-9 * np.ones(10) if std is None else std, held_out=np.full((6, 40), held_out), effects=("one",)
    )


@pytest.mark.parametrize(
    ("k", "limit"),
    [(0, 0.020), (1, 0.0013), (3, 0.0013), (4, 0.0006), (5, 0.0006), (9, 0.0006)],
    ids=["m", "mcx", "mcz", "Ixx", "Ixy", "Izz"],
)
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_payload_has_moved_from_a_hundredth_of_mass_and_first_moment_and_three_of_the_inertia_on(
    k: int, limit: float, sign: float
) -> None:
    """20 g of 2 kg, 1.3 g m of 0.13 kg m, 0.0006 of 0.02 kg m2."""
    for share, moved in ((0.98, False), (1.02, True)):
        change = sign * share * limit * np.eye(10)[k]
        nominal, best = fit_of(PHI - change), fit_of(PHI)
        assert find_margins(windows_of(), nominal, best).moved == pytest.approx(share)  # type: ignore[arg-type]  # all that is read
        assert is_material(windows_of(), nominal, best) is moved  # type: ignore[arg-type]  # all that is read


def test_a_payload_has_moved_only_beyond_twice_its_standard_uncertainty() -> None:
    change = 0.2 * np.eye(10)[0]
    for std, moved in ((0.102, False), (0.098, True)):
        best = fit_of(PHI, std=np.full(10, std))
        assert is_material(windows_of(), fit_of(PHI - change), best) is moved  # type: ignore[arg-type]  # all that is read


def test_what_hides_behind_the_noise_moves_no_payload() -> None:
    for gap, material in ((1.008, False), (1.012, True)):
        nominal = fit_of(PHI - 0.2 * np.eye(10)[0], held_out=1.0 + SAMPLES * (gap**2 - 1.0))
        assert is_material(windows_of(), nominal, fit_of(PHI)) is material  # type: ignore[arg-type]  # all that is read


def test_a_reference_that_the_estimate_agrees_with_counts_more_than_what_an_explanation_moves() -> None:
    nominal, best = fit_of(PHI), fit_of(PHI + 0.2 * np.eye(10)[0])
    assert is_material(windows_of(), nominal, best)  # type: ignore[arg-type]  # all that is read
    assert not is_material(windows_of(PHI), nominal, best)  # type: ignore[arg-type]  # all that is read


def test_an_estimate_is_off_its_reference_by_what_the_best_explanation_knows_of_the_payload() -> None:
    """What the gap does to the estimate makes it uncertain, too; the explanation takes that off."""
    off = PHI + 0.05 * np.eye(10)[0]
    vague, sharp = np.full(10, 0.05), np.full(10, 0.001)
    windows = windows_of(PHI)
    assert not is_material(windows, fit_of(off, std=vague), fit_of(PHI, std=vague))  # type: ignore[arg-type]  # all that is read
    assert is_material(windows, fit_of(off, std=vague), fit_of(PHI, std=sharp))  # type: ignore[arg-type]  # all that is read


def test_a_gap_matters_from_twice_the_noise_of_a_sample_on() -> None:
    """The mean square over samples of what the twin is off by is 4 times that of the noise; the excess of a window is 25 times as large."""
    for gap, material in ((1.97, False), (2.03, True)):
        fit = fit_of(PHI, held_out=1.0 + SAMPLES * (gap**2 - 1.0))
        assert is_material(windows_of(), fit, fit) is material  # type: ignore[arg-type]  # all that is read


def test_a_reference_is_doubted_from_a_signature_of_twice_the_gap_on() -> None:
    """0.1 kg at 50 per kg moves every row by 5; the gap leaves 2.45 or 2.55 of root mean square beyond the noise."""
    windows = windows_of(PHI - 0.1 * np.eye(10)[0], newtons_per_kg=50.0)
    for beyond, unsure in ((2.45, False), (2.55, True)):
        fit = fit_of(PHI, held_out=1.0 + beyond**2)
        assert is_doubtful(windows, fit) is unsure  # type: ignore[arg-type]  # all that is read
        assert is_material(windows, fit, fit) is unsure  # type: ignore[arg-type]  # all that is read
