"""Principal moments of inertia: what MuJoCo wants to know of a body."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.errors import BadPayload
from core.payload.inertia import InertialParameters
from core.words.message import Message

ROUNDING = 1e-6
"""Relative excess over A + B >= C that is taken for rounding: a flat plate has A + B = C."""


@dataclass(frozen=True)
class PrincipalInertia:
    """Principal moments (3,), kg m2, and axes (3, 3, columns, right-handed) about the centre of mass."""

    moments: Array
    axes: Array


def principal_inertia(parameters: InertialParameters) -> PrincipalInertia:
    """Diagonalises the inertia about the centre of mass.

    Raises:
        BadPayload: no body has it: no mass, a moment that is not positive, or A + B < C, which MuJoCo refuses as well.
    """
    if parameters.mass > 0:
        (A, B, C), axes = np.linalg.eigh(parameters.inertia_com)
        if A > 0 and (1 + ROUNDING) * (A + B) >= C:
            return PrincipalInertia(np.array([A, B, min(C, A + B)]), axes * np.sign(np.linalg.det(axes)))
    raise BadPayload(Message.of("plant-inertial-parameters"), "plant-no-rigid-body", phi=parameters.phi.tolist())
