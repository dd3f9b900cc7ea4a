"""Which parameters the data determine, and in words why the others are not."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.payload.inertia import PHI_NAMES, Motion

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]

LARGEST_RELATIVE_STD = 0.1
"""Of the scale that a parameter is measured by; above it a number would only look like one."""
SIZE_M = 0.05
"""Radius of gyration that a payload has about its own centre at least, roughly."""
SLOW_RAD_S2 = 0.3
"""Angular acceleration (rms over the moving part) below which an axis counts as not excited, for the reasons in words."""


def scales(phi: Array) -> Array:
    """(10,) sizes by which the parameters are measured: the mass, the mass times a lever, the mass times a lever squared."""
    m = abs(float(phi[0]))
    lever = float(np.hypot(np.linalg.norm(phi[1:4]) / m, SIZE_M)) if m > 0 else SIZE_M
    return np.concatenate(([m], np.full(3, m * lever), np.full(6, m * lever**2)))


def find_determined(phi: Array, std: Array) -> Bools:
    """(10,): the standard uncertainty is below a tenth of the scale. Without a mass nothing is determined."""
    enough = std < LARGEST_RELATIVE_STD * scales(phi)
    mass_known = bool(enough[0]) and phi[0] > 0
    return np.asarray(enough & mass_known)


def explain_not_excited(turned: str) -> dict[str, str]:
    """Name of each inertial parameter that no rotation about these sensor axes (`xy` for example) shows -> why."""
    pairs = [(a, b) for a in "xyz" for b in "xyz" if a <= b]
    left_out = [(a, b) for a, b in pairs if a not in turned and b not in turned]
    return {f"I{a}{b}": f"no rotation about {a}" if a == b else f"no rotation about {a} or {b}" for a, b in left_out}


def reasons(phi: Array, std: Array, known: Bools, *, static: bool, motion: Motion | None, turned: str | None = None) -> dict[str, str]:
    """Name of each undetermined parameter -> why.

    Args:
        turned: sensor axes that were turned about, `xy` for example; None where nobody has said what was done when.
    """
    missing = {} if static or turned is None else explain_not_excited(turned)
    return {
        name: (f"{missing[name]}; " if name in missing else "")
        + _reason(k, float(std[k]), float(scales(phi)[k]), static=static, motion=motion)
        for k, name in enumerate(PHI_NAMES)
        if not known[k]
    }


def _reason(k: int, std: float, scale: float, *, static: bool, motion: Motion | None) -> str:
    unit = "kg" if k == 0 else "kg m" if k < 4 else "kg m2"
    size = f"its standard uncertainty would be {std:.2g} {unit} against {scale:.2g} {unit}, the size that matters"
    if k >= 4 and static:
        return "static poses only: the inertia is not excited"
    if k == 0:
        return f"too few different poses to tell the weight from the sensor's offset; {size}"
    if k < 4:
        return f"gravity came from too few directions to tell the first moment about {'xyz'[k - 1]} from the offset; {size}"
    slow = [] if motion is None else ["xyz"[i] for i in range(3) if _rms(motion.alpha[:, i]) < SLOW_RAD_S2]
    axes = f"hardly any angular acceleration about {' and '.join(slow)}; " if slow else "too little angular acceleration; "
    return axes + size


def _rms(x: Array) -> float:
    moving = np.abs(x) > 0.05 * np.abs(x).max(initial=0.0)
    return float(np.sqrt(np.mean(x[moving] ** 2))) if moving.any() else 0.0
