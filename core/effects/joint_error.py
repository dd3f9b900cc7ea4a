"""What the sensor's motion becomes when the true joint angles are `q + error`.

With `J_j` the column of joint j (twist in sensor axes) and `V_<j` the part of the sensor's twist that the joints before j cause, the
twist changes by `-sum_j error_j ad(J_j) V_<j`: only what comes from before the joint is seen from turned axes. Gravity comes
from before all joints.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from core.array import Array
from core.effects.joint_twists import find_joint_twists
from core.effects.scene import Scene
from core.payload.inertia import Motion
from core.words.message import Message


@njit(cache=True)
def _true_motion(
    J: Array,
    E: Array,
    velocity: Array,
    error: Array,
    first: Array,
    second: Array,
    g0: Array,
    a0: Array,
    omega0: Array,
    alpha0: Array,
    period: float,
) -> Array:
    """(4, N, 3): gravity, acceleration, angular velocity and acceleration. J, E and the velocity (`JointTwists`) may begin one row before
    all others; `first` and `second`, the derivatives of the error, may be empty."""
    N, n = error.shape
    shift = len(E) - N
    out = np.empty((4, N, 3))
    twist, rate = np.empty(6), np.empty(6)
    for k in range(N):
        i = k + shift
        gx, gy, gz = g0[k, 0], g0[k, 1], g0[k, 2]
        vx, vy, vz = velocity[i, 0], velocity[i, 1], velocity[i, 2]
        twist[:] = 0.0
        rate[:] = 0.0
        for j in range(n):
            e = error[k, j]
            if e != 0.0:  # R(-e J_j) to second order, joint after joint
                rx, ry, rz = e * J[i, 3, j], e * J[i, 4, j], e * J[i, 5, j]
                dx, dy, dz = ry * gz - rz * gy, rz * gx - rx * gz, rx * gy - ry * gx
                gx += 0.5 * (ry * dz - rz * dy) - dx
                gy += 0.5 * (rz * dx - rx * dz) - dy
                gz += 0.5 * (rx * dy - ry * dx) - dz
                for c in range(6):
                    twist[c] += e * E[i, j, c]
                    if i > 0:
                        rate[c] += e * (E[i, j, c] - E[i - 1, j, c])
        for j in range(n if len(first) else 0):
            for c in range(6):
                twist[c] += J[i, c, j] * first[k, j]
                rate[c] += E[i, j, c] * first[k, j] * period
                if i > 0:
                    rate[c] += (J[i, c, j] - J[i - 1, c, j]) * first[k, j]
        for c in range(6):
            rate[c] /= period
        for j in range(n if len(second) else 0):
            for c in range(6):
                rate[c] += J[i, c, j] * second[k, j]
        px, py, pz = omega0[k, 0], omega0[k, 1], omega0[k, 2]
        out[0, k, 0], out[0, k, 1], out[0, k, 2] = gx, gy, gz
        # a = dv/dt + omega x v in sensor axes
        out[1, k, 0] = a0[k, 0] + rate[0] + twist[4] * vz - twist[5] * vy + py * twist[2] - pz * twist[1]
        out[1, k, 1] = a0[k, 1] + rate[1] + twist[5] * vx - twist[3] * vz + pz * twist[0] - px * twist[2]
        out[1, k, 2] = a0[k, 2] + rate[2] + twist[3] * vy - twist[4] * vx + px * twist[1] - py * twist[0]
        for c in range(3):
            out[2, k, c] = omega0[k, c] + twist[3 + c]
            out[3, k, c] = alpha0[k, c] + rate[3 + c]
    return out


def true_motion(scene: Scene, error: Array, acceleration: Array | None = None, velocity: Array | None = None) -> Motion:
    """The sensor's motion with joints at `q + error`.

    Args:
        scene: with joints.
        error: (N, n), rad.
        acceleration, velocity: (N, n), second derivative of the error, rad/s2, and the first, rad/s, where they are not slow against the
            motion: else what the error's own change adds to accelerations, to velocities, is left out.
    """
    if scene.jacobian is None or scene.dq is None:
        raise ValueError("an error of the joints needs a scene with joints (see Effect.explain_lack)")
    m = scene.motion
    J, dq = scene.past("jacobian").before(scene.jacobian, 1), scene.past("dq").before(scene.dq, 1)
    known = scene.joint_twists if scene.memory is None else None
    twists = find_joint_twists(J, dq) if known is None else known
    first, second = (np.zeros((0, 0)) if x is None else np.ascontiguousarray(x) for x in (velocity, acceleration))
    out = _true_motion(J, *twists, np.ascontiguousarray(error), first, second, m.g, m.a, m.omega, m.alpha, scene.period)
    return Motion(out[0], out[1], out[2], out[3])


def without_joints(scene: Scene) -> Message | None:
    """Why errors of the joints cannot show in this recording."""
    if scene.q is None or scene.dq is None or scene.jacobian is None:
        return Message.of("effect-no-joints")
    return None


def joint_count(scene: Scene) -> int:
    """n, 0 without joints."""
    return 0 if scene.q is None else int(scene.q.shape[1])


def joint_torque(scene: Scene) -> Array:
    """(N, n), N m, that the joints exert, as measured, or as `rigid_load` without a measurement."""
    return rigid_load(scene) if scene.torque is None else scene.torque


def rigid_load(scene: Scene) -> Array:
    """(N, n), N m, that arm and payload ask of the joints, as if rigid.

    Where the masses of the links are not known: what was measured, or what the payload alone asks, `J^T w`.
    """
    if scene.links is None and scene.torque is not None:
        return scene.torque
    return scene.joint_load


def find_largest_joint(theta: Array) -> int:
    """Index of the joint with the largest value."""
    return int(np.argmax(np.abs(theta)))
