"""Which parameters the data determine, and why the others are not."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.payload.inertia import PHI_NAMES, Motion
from core.words.message import Message

Bools = NDArray[np.bool_]

LARGEST_RELATIVE_STD = 0.1
"""Of the scale that a parameter is measured by; above it a number would only look like one. What is called determined is known to a tenth
of that scale, one standard deviation: the mass and each moment of inertia to a tenth of themselves."""
SIZE_M = 0.05
"""Radius of gyration that a payload has about its own centre, roughly; a first moment is measured by a lever of at least this."""
SLIMMEST_M = 0.02
"""Radius of gyration about an axis below which a moment is measured by this one: nobody needs to know the moment of a rod about itself."""
SLOW_RAD_S2 = 0.3
"""Angular acceleration (rms over the moving part) below which an axis counts as not excited, for the reasons that are given."""


def scales(phi: Array) -> Array:
    """(10,) sizes by which the parameters are measured: the mass, the mass times a lever, each moment, and for a product of inertia the
    geometric mean of the moments about its two axes."""
    m = abs(float(phi[0]))
    lever = float(np.hypot(np.linalg.norm(phi[1:4]) / m, SIZE_M)) if m > 0 else SIZE_M
    x, y, z = np.maximum(phi[[4, 7, 9]], m * SLIMMEST_M**2)
    return np.concatenate(([m], np.full(3, m * lever), [x, np.sqrt(x * y), np.sqrt(x * z), y, np.sqrt(y * z), z]))


def find_determined(phi: Array, std: Array) -> Bools:
    """(10,): the standard deviation by the recording alone is below a tenth of the scale. Without a mass nothing is determined."""
    enough = std < LARGEST_RELATIVE_STD * scales(phi)
    mass_known = bool(enough[0]) and phi[0] > 0
    return np.asarray(enough & mass_known)


def explain_not_excited(turned: str) -> dict[str, Message]:
    """Name of each inertial parameter that no rotation about these sensor axes (`xy` for example) shows -> why."""
    pairs = [(a, b) for a in "xyz" for b in "xyz" if a <= b]
    left_out = [(a, b) for a, b in pairs if a not in turned and b not in turned]
    return {
        f"I{a}{b}": Message.of("estimation-no-rotation", axis=a) if a == b else Message.of("estimation-no-rotation-of-two", axis=a, other=b)
        for a, b in left_out
    }


def reasons(phi: Array, std: Array, known: Bools, *, static: bool, motion: Motion | None, turned: str | None = None) -> dict[str, Message]:
    """Name of each undetermined parameter -> why.

    Args:
        turned: sensor axes that were turned about, `xy` for example; None where nobody has said what was done when.
    """
    missing = {} if static or turned is None else explain_not_excited(turned)
    found = {}
    for k, name in enumerate(PHI_NAMES):
        if not known[k]:
            reason = _reason(k, float(std[k]), float(scales(phi)[k]), static=static, motion=motion)
            found[name] = Message.of("estimation-two-reasons", rotation=missing[name], reason=reason) if name in missing else reason
    return found


def _reason(k: int, std: float, scale: float, *, static: bool, motion: Motion | None) -> Message:
    if k >= 4 and static:
        return Message.of("estimation-standing")
    if k == 0:
        return Message.of("estimation-mass-uncertain", std_kg=std, scale_kg=scale)
    if k < 4:
        return Message.of("estimation-first-moment-uncertain", axis="xyz"[k - 1], std_kg_m=std, scale_kg_m=scale)
    slow = [] if motion is None else ["xyz"[i] for i in range(3) if _rms(motion.alpha[:, i]) < SLOW_RAD_S2]
    if slow:
        return Message.of("estimation-inertia-uncertain-about", axes=slow, std_kg_m2=std, scale_kg_m2=scale)
    return Message.of("estimation-inertia-uncertain", std_kg_m2=std, scale_kg_m2=scale)


def _rms(x: Array) -> float:
    moving = np.abs(x) > 0.05 * np.abs(x).max(initial=0.0)
    return float(np.sqrt(np.mean(x[moving] ** 2))) if moving.any() else 0.0
