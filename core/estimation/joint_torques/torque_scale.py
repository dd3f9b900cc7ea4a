"""Whether torques are in N m and of the right sign: their common scale against what the arm by its URDF asks for."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.array import Array
from core.estimation.joint_torques.unknowns import Recorded

LEAST, MOST = 0.1, 6.0
"""Of the scale. It is rough: sound recordings came out between 0.22 and 1.9, since friction, arm and payload look alike in it. So only
another sign and another order of magnitude are told."""
TOO_FEW = 20
"""Windows of a joint that tell nothing."""


def find_scale(recorded: Sequence[Recorded], links: Array) -> float | None:
    """The factor by which all torques together differ from what the links (n, 10) ask for; None where the arm asks for next to nothing.

    Least squares over all joints, each weighed by its own spread, with the payload free, and Coulomb and viscous friction, offset and rotor
    of each joint. A payload takes part in the loaded recording only, so it hides no scale where there is another.
    """
    n = len(links)
    rows, right = [], []
    for j in range(n):
        parts = [_columns_of_joint(each, links, j) for each in recorded]
        own, y = _stack([part[1] for part in parts]), np.concatenate([part[2] for part in parts])
        if len(y) < TOO_FEW:
            continue
        shared = np.concatenate([part[0] for part in parts])
        # what friction, rotor and offsets of this joint can explain is nobody else's affair
        basis, _ = np.linalg.qr(own)
        weight = 1.0 / max(float(np.std(y)), 1e-9)
        rows.append(weight * (shared - basis @ (basis.T @ shared)))
        right.append(weight * (y - basis @ (basis.T @ y)))
    if not rows:
        return None
    X = np.concatenate(rows)
    size = np.linalg.norm(X, axis=0)
    if size[0] < 1e-9:
        return None
    kept = size > 1e-9
    return float(np.linalg.lstsq(X[:, kept] / size[kept], np.concatenate(right), rcond=1e-6)[0][0] / size[0])


def _columns_of_joint(each: Recorded, links: Array, j: int) -> tuple[Array, Array, Array]:
    """Of one joint in one recording: arm and payload (K, 5), friction, rotor and offset (K, 4), torque (K,)."""
    windows, n = each.windows, len(links)
    use = windows.usable[:, j]
    Y = windows.Y[use, j]
    arm = Y[:, : 10 * n] @ links.ravel() + Y[:, 10 * n :] @ each.known
    speed = windows.speed[use, j]
    own = np.column_stack((np.sign(speed), speed, windows.acceleration[use, j], np.ones(len(speed))))
    payload = Y[:, 10 * n : 10 * n + 4] if each.carries else np.zeros((len(Y), 4))
    return np.column_stack((arm, payload)), own, windows.torques(0.0)[use, j]


def _stack(own: list[Array]) -> Array:
    """Friction and rotor in common, an offset for each recording."""
    offsets = np.zeros((sum(len(each) for each in own), len(own)))
    first = 0
    for k, each in enumerate(own):
        offsets[first : first + len(each), k] = 1.0
        first += len(each)
    return np.hstack((np.concatenate([each[:, :3] for each in own]), offsets))
