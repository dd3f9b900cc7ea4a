"""Whether an effect matters: detected and material are two things where 0.05 deg of tilt is 25 sigma."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.determination import find_determined
from core.gap.effect_fit import EffectFit
from core.gap.limits import BEYOND_STD, GAP, SHARES, sizes
from core.gap.windows import PHI, Windows
from core.words.message import Message

DOUBT = 2.0
"""A reference is doubted only where the payload's difference from it moves the wrench by more than so many times the gap."""


def is_material(windows: Windows, nominal: EffectFit, best: EffectFit) -> bool:
    """Whether what is there lifts the gap above 2, or moves the payload: by what the best explanation does to the estimate, or, explained
    or not, away from the reference."""
    gap = np.sqrt(max(0.0, 1.0 + (float(nominal.held_out.mean()) - 1.0) / windows.samples_per_row))
    return bool(gap > GAP) or bool(find_moved_parameters(nominal, best).any()) or _is_off_reference(windows, nominal, best)


def find_moved_parameters(nominal: EffectFit, best: EffectFit) -> NDArray[np.bool_]:
    """(10,), which payload parameters the effect moves materially."""
    return _apart(best.phi - nominal.phi, best.phi, best.phi_std)


def _is_off_reference(windows: Windows, nominal: EffectFit, best: EffectFit) -> bool:
    """Whether the estimate is materially off the reference by so little that the gap, which is there for certain, may be why."""
    reference = windows.basis.reference
    if reference is None or not best.effects:
        return False
    return bool(_apart(nominal.phi - reference, reference, nominal.phi_std).any()) and is_doubtful(windows, nominal)


def is_doubtful(windows: Windows, fit: EffectFit) -> bool:
    """Whether the payload's difference from the reference moves the wrench by so little that the gap that a fit leaves may be why."""
    if windows.basis.reference is None:
        return False
    signature = float(np.square(windows.X[:, :, PHI] @ (fit.phi - windows.basis.reference)).mean())
    return signature < DOUBT**2 * (float(fit.held_out.mean()) - 1.0)


def _apart(difference: Array, phi: Array, std: Array) -> NDArray[np.bool_]:
    """(10,), which payload parameters differ by more than matters and more than their uncertainty."""
    return np.asarray((np.abs(difference) > SHARES * sizes(phi)) & (np.abs(difference) > BEYOND_STD * std))


def payload_shift(nominal: EffectFit, best: EffectFit) -> Message:
    """What the effect does to the payload that a controller would use."""
    if not best.effects:
        return Message.of("gap-payload-as-it-is")
    shift, size = nominal.phi - best.phi, sizes(best.phi)
    known = find_determined(best.phi, best.phi_std) & find_determined(nominal.phi, nominal.phi_std)
    share = np.abs(shift) / np.where(known, size, np.inf)
    numbers = {
        "mass_kg": shift[0],
        "mass_share": share[0],
        "first_moment_kg_m": float(np.linalg.norm(shift[1:4])),
        "first_moment_share": share[1:4].max(),
    }
    if not known[4:].any():
        return Message.of("gap-payload-changed-but-inertia", **numbers)
    return Message.of("gap-payload-changed", **numbers, inertia_share=share[4:].max())
