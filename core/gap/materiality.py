"""Whether an effect matters: detected and material are two things where 0.05 deg of tilt is 25 sigma."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.gap.effect_fit import EffectFit
from core.gap.limits import GAP, SHARES
from core.gap.windows import Windows

Array = NDArray[np.float64]


def is_material(windows: Windows, nominal: EffectFit, best: EffectFit) -> bool:
    """Whether the best explanation lifts the gap above 2 or moves the payload beyond its uncertainty and these shares."""
    gap = np.sqrt(max(0.0, 1.0 + (float(nominal.held_out.mean()) - 1.0) / windows.samples_per_row))
    return bool(gap > GAP) or bool(moved(nominal, best).any())


def moved(nominal: EffectFit, best: EffectFit) -> NDArray[np.bool_]:
    """(10,), which payload parameters the effect moves materially."""
    shift = np.abs(best.phi - nominal.phi)
    beyond = shift > 2.0 * best.phi_std
    return np.asarray((shift > SHARES * sizes(best.phi)) & beyond)


def sizes(phi: Array) -> Array:
    """(10,), what the shares refer to."""
    return np.concatenate(([abs(phi[0])], np.full(3, np.linalg.norm(phi[1:4])), np.full(6, np.abs(phi[[4, 7, 9]]).max())))


def payload_shift(nominal: EffectFit, best: EffectFit) -> str:
    """What the effect does to the payload that a controller would use, in words."""
    if not best.effects:
        return "The payload parameters can be used as they are."
    shift = nominal.phi - best.phi
    share = np.abs(shift) / sizes(best.phi)
    parts = [
        f"the mass by {1e3 * shift[0]:+.1f} g ({100 * share[0]:.2f} %)",
        f"the first moment by {1e3 * np.linalg.norm(shift[1:4]):.2f} g m ({100 * share[1:4].max():.2f} %)",
        f"the inertia by up to {100 * share[4:].max():.1f} % of its largest moment",
    ]
    return "Left out, it changes " + ", ".join(parts) + "."
