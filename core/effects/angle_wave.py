"""Errors of a joint that repeat with its angle."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.joint_waves import JointWaves
from core.effects.scene import Scene


def angle_wave(scene: Scene, order: Array, c: Array, s: Array) -> tuple[Array, Array]:
    """`c cos(order q) + s sin(order q)` per joint as the scene's windows show it, rad, and its second derivative, rad/s2.

    (N, n) each. Where the run is one that much is fitted to, joints whose waves are as before are not worked out again: a derivative
    changes one at a time.

    Args:
        order: (n,), waves per turn; or (n, m), of waves that add up.
        c, s: likewise, rad.
    """
    if scene.q is None or scene.dq is None:
        raise ValueError("errors of joints need a scene with joints (see Effect.explain_lack)")
    q, dq = scene.past("wave q").before(scene.q, 1), scene.past("wave dq").before(scene.dq, 1)
    known = JointWaves() if scene.joint_waves is None or scene.memory is not None else scene.joint_waves
    waves = np.stack([np.asarray(x).reshape(len(order), -1) for x in (order, c, s)], axis=-1)
    error, acceleration = np.zeros((2, len(scene), len(order)))
    for j in np.flatnonzero(waves[:, :, 1:].any(axis=(1, 2))):
        found = known.find(q, dq, int(j), waves[j], scene.period, max(scene.window, scene.period))
        error[:, j], acceleration[:, j] = found[:, -len(scene) :]
    return error, acceleration
