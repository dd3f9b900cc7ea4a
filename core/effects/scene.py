"""The nominal run that effects are applied to: kinematics, payload and joints, one row per sample on a uniform grid."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from core.inertia import Motion, wrench

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Scene:
    """What the twin knows of a run; sensor frame unless said otherwise, SI.

    Args:
        t: (N,), uniform, s.
        phase: (N,), text as in a recording.
        motion: nominal kinematics of the sensor frame, without lag.
        rotation: (N, 3, 3), sensor axes in the base frame.
        position: (N, 3), sensor origin in the base frame; None where unknown.
        gravity: (3,), nominal, base frame.
        phi: (10,), payload as estimated together with the effects.
        q, dq: (N, n), joints; None for a recording of poses.
        jacobian: (N, 6, n), linear over angular velocity of the sensor frame in sensor axes; None likewise.
        torque: (N, n), joint torques (measured, or from the arm's and the payload's masses), N m; None where neither is known.
        temperature: (N,), degC, None where not recorded.
        range, resolution: (6,), of the sensor, None where unknown.
    """

    t: Array
    phase: NDArray[np.str_]
    motion: Motion
    rotation: Array
    position: Array | None
    gravity: Array
    phi: Array
    q: Array | None = None
    dq: Array | None = None
    jacobian: Array | None = None
    torque: Array | None = None
    temperature: Array | None = None
    range: Array | None = None
    resolution: Array | None = None

    def __len__(self) -> int:
        return len(self.t)

    @property
    def period(self) -> float:
        """s."""
        return float(self.t[1] - self.t[0])

    @property
    def nominal(self) -> Array:
        """(N, 6), the wrench that the payload asks of the sensor, Eq. (1)."""
        return wrench(self.motion, self.phi)

    def carrying(self, phi: Array) -> Scene:
        """The same run with another payload."""
        return replace(self, phi=phi)

    def turned(self, error: Array) -> Motion:
        """Kinematics when the true sensor axes are turned by the small rotation vectors `error` (N, 3), sensor axes.

        Gravity and accelerations are the same vectors seen in turned axes; what the change of `error` itself adds to them is left out:
        it is slow against the motion.
        """
        m = self.motion
        return Motion(
            m.g - np.cross(error, m.g),
            m.a - np.cross(error, m.a),
            m.omega - np.cross(error, m.omega),
            m.alpha - np.cross(error, m.alpha),
        )
