"""Rigid-body pieces that the effects on motion and payload share."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.scene import Scene
from core.payload.inertia import Motion
from core.payload.rigid_wrench import wrench as rigid_wrench


def wrench_change(scene: Scene, true: Motion) -> Array:
    """(N, 6), what the scene's payload asks more of the sensor under the true motion than under the nominal one."""
    return rigid_wrench(true, scene.phi) - scene.nominal


def centre_of_mass(scene: Scene) -> Array:
    """(3,), of the scene's payload, m; the sensor origin where there is no mass to speak of (a trial step of a fit)."""
    m = scene.phi[0]
    return np.asarray(scene.phi[1:4] / m) if m > 0.01 else np.zeros(3)
