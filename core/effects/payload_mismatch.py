"""The payload is not what the reference says."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.stats import chi2

from core.array import Array
from core.effects.effect import Finding, Parameter, Symptom, View
from core.payload.inertia import PHI_NAMES, PHI_UNITS
from core.recording.recording import Recording
from core.words.message import Message

CHANCE = 1e-4
"""A difference that chance gives less often than this lies beyond the uncertainty."""
SMALLEST_LEVER = 1e-3
"""m; a first moment is compared with at least the mass on this lever, else a centred payload could never be right."""

_Part = Literal["mass", "first_moment", "inertia"]
_PARTS: dict[_Part, tuple[slice, float]] = {
    "mass": (slice(0, 1), 0.01),
    "first_moment": (slice(1, 4), 0.01),
    "inertia": (slice(4, 10), 0.03),
}
_SUFFIXES = {"kg": "kg", "kg m": "kgm", "kg m2": "kgm2"}
_SCALES = (0.1, *[0.01] * 3, *[0.002] * 6)


class PayloadMismatch(Symptom):
    """Estimate less reference, per parameter.

    Material when a part of it is off by more than 1 % (mass, of the mass; first moment, of its norm) or 3 % (inertia, any element, of the
    largest principal moment), and that part lies beyond the uncertainty: chi-square with a chance of less than 1e-4. Parameters that
    were not determined do not count.
    """

    id = "payload_mismatch"
    title = Message.of("effect-payload-mismatch-title")
    stage = "payload"
    side = "reference"

    def parameters(self, recording: Recording) -> tuple[Parameter, ...]:
        """Differences of the ten inertial parameters: kg, kg m, kg m2."""
        return tuple(
            Parameter(f"{name.lower()}_difference_{_SUFFIXES[unit]}", unit, 0.0, -1e3 * scale, 1e3 * scale, scale)
            for name, unit, scale in zip(PHI_NAMES, PHI_UNITS, _SCALES, strict=True)
        )

    def observe(self, recording: Recording, view: View) -> Finding | None:
        """Estimate less reference, where determined; None without a reference or with nothing determined."""
        known = np.isfinite(view.phi) & np.isfinite(view.phi_std) & (view.phi_std > 0)
        if recording.reference_of_whole is None or not known.any():
            return None
        reference = recording.reference_of_whole.phi
        difference = np.where(known, view.phi - reference, np.nan)
        z = np.where(known, difference / np.where(known, view.phi_std, 1.0), 0.0)
        shares = _shares(difference, reference)
        times = {part: _times(shares[part] / limit, z[rows], known[rows]) for part, (rows, limit) in _PARTS.items()}
        material = [part for part, so_many in times.items() if so_many > 1.0]
        return Finding(
            theta=difference,
            std=np.where(known, view.phi_std, np.nan),
            sigma=_sigma(float(z @ z), int(known.sum())),
            material=bool(material),
            times_expected=max(times.values()),
            message=_say_difference(difference, shares, tuple(material), recording.source_of_whole),
        )

    def advice(self, finding: Finding) -> Message:
        """Advises checking which payload is mounted and replacing the reference, with the difference of mass, g, where determined."""
        mass_kg = float(finding.theta[0])
        if not np.isfinite(mass_kg):
            return Message.of("advice-payload-mismatch")
        if mass_kg > 0:
            return Message.of("advice-payload-mismatch-heavier", mass_kg=mass_kg)
        return Message.of("advice-payload-mismatch-lighter", mass_kg=-mass_kg)


def _times(share: float, z: Array, known: NDArray[np.bool_]) -> float:
    """How many times the larger of tolerance and uncertainty a part is off; 0 where it was not determined.

    Args:
        share: times the tolerance.
        z: of its parameters, standard deviations; `known`: those that were determined.
    """
    beyond = float(np.sqrt(np.sum(z**2) / chi2.isf(CHANCE, max(int(known.sum()), 1))))
    return min(share, beyond) if np.isfinite(share) else 0.0


def _say_difference(difference: Array, shares: dict[_Part, float], material: tuple[_Part, ...], source: str | None) -> Message:
    """What is off, or by how little. The mass has a direction: more than the reference says, or less."""
    parts = [_say_part(part, shares[part], more=difference[0] > 0) for part in material or _PARTS if np.isfinite(shares[part])]
    reference = Message.of("symptom-reference-of", source=source) if source else Message.of("symptom-reference")
    if material:
        return Message.of("symptom-other-payload", reference=reference, differences=parts)
    return Message.of("symptom-as-referred", reference=reference, differences=parts)


def _say_part(part: _Part, share: float, *, more: bool) -> Message:
    match part:
        case "mass":
            return Message.of("symptom-heavier", mass_share=share) if more else Message.of("symptom-lighter", mass_share=share)
        case "first_moment":
            return Message.of("symptom-first-moment-off", first_moment_share=share)
        case "inertia":
            return Message.of("symptom-inertia-off", inertia_share=share)


def _shares(difference: Array, reference: Array) -> dict[_Part, float]:
    """How far each part is off as a share of its size; NaN where it was not determined."""
    m, mc, I6 = reference[0], reference[1:4], reference[4:]
    full = np.array([[I6[0], I6[1], I6[2]], [I6[1], I6[3], I6[4]], [I6[2], I6[4], I6[5]]])
    sizes = (abs(m), max(float(np.linalg.norm(mc)), abs(m) * SMALLEST_LEVER), float(np.abs(np.linalg.eigvalsh(full)).max()))
    found = (abs(difference[0]), _norm(difference[1:4]), _largest(difference[4:]))
    return {part: float(x / max(size, 1e-12)) for part, x, size in zip(_PARTS, found, sizes, strict=True)}


def _norm(d: Array) -> float:
    return float(np.sqrt(np.nansum(d**2))) if np.isfinite(d).any() else float("nan")


def _largest(d: Array) -> float:
    return float(np.nanmax(np.abs(d))) if np.isfinite(d).any() else float("nan")


def _sigma(chi_square: float, k: int) -> float:
    """Fisher's approximation: chi-square as standard deviations above what chance gives."""
    return float(np.sqrt(2.0 * chi_square) - np.sqrt(2.0 * k - 1.0))
