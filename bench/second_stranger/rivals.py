"""What other effects, constant and linearised, would leave of a difference: how far each could be taken for the cause that is planted."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.interpolate import CubicSpline

from bench.second_stranger.array import Array
from bench.second_stranger.kinematics import JointMotion, move_arm
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import find_body_wrench
from bench.second_stranger.rotations import tilt_vectors
from bench.second_stranger.sensing import Samples
from bench.second_stranger.signals import STEP_S
from bench.second_stranger.sizing import Remainder, find_length

SMALL = 1e-4
"""Of the differences that stand for derivatives, rad, m or s."""
MOST_ROWS = 5000
DELAYS_S = np.linspace(-0.12, 0.12, 97)


class Rivals:
    """The effects' wrenches over a recording's samples, thinned out."""

    def __init__(self, rig: Rig, samples: Samples) -> None:
        self._rig = rig
        self._every = max(1, len(rig.times) // MOST_ROWS)
        self._path = CubicSpline(rig.times, samples.joints.q)
        everywhere = move_arm(rig.arm, self._follow(0.0), rig.spread_gravity(len(rig.times)))
        self._wrench_path = CubicSpline(rig.times, find_body_wrench(everywhere, rig.body))
        self._joints = self._thin(self._follow(0.0))
        self._plain = self._predict(self._joints)
        thinned = move_arm(rig.arm, self._thin(samples.joints), self._spread_gravity())
        self._remainder = Remainder(rig.noise_std, thinned)

    def measure(self, difference: Array) -> dict[str, float]:
        """What of a difference (M, 6), N and N m, each leaves at best, in noise standard deviations over the whole recording; beside that
        of a delay the delay itself, ms."""
        left = self._remainder.find(difference[:: self._every])
        found = {name: self._leave(left, wrenches) for name, wrenches in self._list_effects().items()}
        delayed = [(self._scale_up(find_length(left - self._remainder.find(self._delay(by)))), by) for by in DELAYS_S]
        least, by = min(delayed, key=lambda each: each[0])
        return {**found, "time_delay": _round(least), "time_delay_at_ms": _round(by * 1e3)}

    def _list_effects(self) -> dict[str, list[Array]]:
        """By name: the wrenches (N, 6) of each of its parameters."""
        n, nothing = self._rig.joint_count, 0 * self._joints.q[:, 0]
        q, dq, ddq = self._joints
        plain, gravity, channels = self._plain, self._spread_gravity(), np.eye(6)

        def differ(joints: JointMotion) -> Array:
            return np.asarray((self._predict(joints) - plain) / SMALL)

        tilted = [tilt_vectors(gravity, x * SMALL + nothing, y * SMALL + nothing) for x, y in ((1, 0), (0, 1))]
        steps, ahead = SMALL * np.eye(n), self._thin(self._follow(SMALL))
        instants = np.clip((self._rig.times[:: self._every] / STEP_S).astype(int), 0, len(self._rig.t) - 1)
        torques, limits = self._rig.torques[instants], self._rig.arm.torque_limits
        return {
            "base_tilt": [(self._predict(self._joints, g) - plain) / SMALL for g in tilted],
            "joint_offset": [differ(JointMotion(q + step, dq, ddq)) for step in steps],
            "sensor_rotation": [(self._predict(self._joints, turned=by) - plain) / SMALL for by in SMALL * np.eye(3)],
            "sensor_translation": [(self._predict(self._joints, moved=by) - plain) / SMALL for by in SMALL * np.eye(3)],
            "sensor_gain": [plain * channel for channel in channels],
            "sensor_crosstalk": [np.outer(plain[:, b], channels[a]) for a in range(6) for b in range(6) if a != b],
            "joint_elasticity": [differ(JointMotion(q - steps[j] * torques[:, j : j + 1] / limits[j], dq, ddq)) for j in range(n)],
            "kinematic_lag": [differ(_replace(self._joints, ahead, j)) for j in range(n)],
        }

    def _leave(self, left: Array, wrenches: Sequence[Array]) -> float:
        """Of what is left (6 N,), the length behind least squares with the wrenches."""
        A = np.stack([self._remainder.find(wrench) for wrench in wrenches], 1)
        size = np.linalg.norm(A, axis=0)
        A = A[:, size > 1e-9] / size[size > 1e-9]
        return _round(self._scale_up(find_length(left - A @ np.linalg.lstsq(A, left, rcond=1e-9)[0])))

    def _delay(self, by_s: float) -> Array:
        """(N, 6), N and N m, by which the wrench differs that comes later."""
        times = self._rig.times
        return np.asarray(self._wrench_path(np.clip(times[:: self._every] - by_s, 0, times[-1])) - self._plain)

    def _predict(self, joints: JointMotion, gravity: Array | None = None, turned: Array | None = None, moved: Array | None = None) -> Array:
        g = self._spread_gravity() if gravity is None else gravity
        return find_body_wrench(move_arm(self._rig.arm, joints, g, turned=turned, moved=moved), self._rig.body)

    def _follow(self, ahead_s: float) -> JointMotion:
        t = self._rig.times + ahead_s
        return JointMotion(self._path(t), self._path(t, 1), self._path(t, 2))

    def _thin(self, joints: JointMotion) -> JointMotion:
        return JointMotion(*(x[:: self._every] for x in joints))

    def _spread_gravity(self) -> Array:
        return self._rig.spread_gravity(len(self._rig.times[:: self._every]))

    def _scale_up(self, length: float) -> float:
        """To the whole recording."""
        return length * float(np.sqrt(self._every))


def _replace(joints: JointMotion, others: JointMotion, place: int) -> JointMotion:
    """One joint's motion by another."""
    is_it = np.arange(joints.q.shape[1]) == place
    return JointMotion(*(np.where(is_it, other, own) for own, other in zip(joints, others, strict=True)))


def _round(value: float) -> float:
    return float(np.round(value, 1))
