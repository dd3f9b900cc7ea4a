"""Whether an effect matters: detected and material are two things where 0.05 deg of tilt is 25 sigma."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from core.array import Array
from core.estimation.determination import find_determined
from core.gap.closure import gap_of
from core.gap.effect_fit import EffectFit
from core.gap.limits import BEYOND_STD, GAP, SHARES, sizes
from core.gap.windows import PHI, Windows
from core.words.message import Message

DOUBT = 2.0
"""A reference is doubted only where the payload's difference from it moves the wrench by more than so many times the gap."""
HIDDEN = 1.01
"""Gap that a seventh of the noise of a sample makes: zeros, gains and offsets of any arm do, beyond those that the fits allow for."""


class Margins(NamedTuple):
    """What is there, each as a multiple of what matters.

    Args:
        gap: what the nominal twin leaves on motions that it has not seen.
        moved: the farthest payload parameter, of what the best explanation does to the estimate and its uncertainty lets be said.
        reference: the same of the estimate away from the reference, as well as the best explanation lets the payload be known; nan where
            nobody knows it, or something else is carried.
    """

    gap: float
    moved: float
    reference: float


def is_material(windows: Windows, nominal: EffectFit, best: EffectFit) -> bool:
    """Whether what is there lifts the gap above 2, or moves the payload: away from the reference, or where that tells nothing by what the
    best explanation does to the estimate."""
    gap, moved, reference = find_margins(windows, nominal, best)
    return max(gap, moved if np.isnan(reference) else reference) > 1.0


def find_margins(windows: Windows, nominal: EffectFit, best: EffectFit) -> Margins:
    """By how much it does; what hides behind the noise moves nothing."""
    reference, nothing = windows.basis.reference, not best.effects or is_hidden(windows, nominal)
    moved = 0.0 if nothing else find_farthest(best.phi - nominal.phi, best.phi, best.phi_std)
    off = np.nan if reference is None else find_farthest(nominal.phi - reference, reference, best.phi_std)
    if off > 1.0:
        off = 0.0 if nothing else off if is_doubtful(windows, nominal) else np.nan
    return Margins(gap_of(windows, nominal) / GAP, moved, off)


def is_hidden(windows: Windows, nominal: EffectFit) -> bool:
    """Whether the gap hides behind the noise: whatever causes it moves nothing then."""
    return gap_of(windows, nominal) < HIDDEN


def is_doubtful(windows: Windows, fit: EffectFit) -> bool:
    """Whether the payload's difference from the reference moves the wrench by so little that the gap that a fit leaves may be why."""
    if windows.basis.reference is None:
        return False
    signature = float(np.square(windows.X[:, :, PHI] @ (fit.phi - windows.basis.reference)).mean())
    return signature < DOUBT**2 * (float(fit.held_out.mean()) - 1.0)


def find_farthest(difference: Array, phi: Array, std: Array) -> float:
    """Of payload parameters (10,), the largest difference in units of what matters and is beyond its uncertainty: above 1 it does."""
    size = np.maximum(SHARES * sizes(phi), BEYOND_STD * std)
    return float((np.abs(difference) / size).max())


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
