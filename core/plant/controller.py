"""The joint controller of the virtual robot: computed torque with an integrator, at 1 kHz."""

from __future__ import annotations

import mujoco
import numpy as np

from core.array import Array
from core.plant.mechanics import PERIOD

SKIP_SENSORS = 1


class JointController:
    """Follows commanded joint positions as the drives of a collaborative arm do.

    `tau = M u + h` with `u = ddq_d + 3 w (dq_d - dq) + 3 w^2 (q_d - q) + w^3 integral(q_d - q)`: three equal poles at
    `-w`. `M` and `h` are those of the bare arm without dry friction: payload, friction and a tilted base are left to
    the feedback, as on a robot that does not know them. Positions and velocities come from the motor side, where the
    gear makes the resolution better than the outside encoders'.

    Args:
        arm: MuJoCo model of the bare arm, without dry friction.
        torque_limit: (n,), N m.
        acceleration_limit: (n,), rad/s2; the feed-forward never asks for more.
        bandwidth: w, rad/s.
    """

    def __init__(self, arm: mujoco.MjModel, *, torque_limit: Array, acceleration_limit: Array, bandwidth: float = 90.0) -> None:
        self._model = arm
        self._data = mujoco.MjData(arm)
        self._torque_limit = torque_limit
        self._acceleration_limit = acceleration_limit
        self._k_p = 3 * bandwidth**2
        self._k_d = 3 * bandwidth
        self._k_i = bandwidth**3
        n = arm.nv
        self._integral = np.zeros(n)
        self._q_last = np.zeros(n)
        self._dq_last = np.zeros(n)

    def settle(self, q: Array, tau: Array) -> None:
        """Starts as if the arm had been standing at q (n,) for long, held by the torques tau (n,)."""
        data = self._data
        data.qpos[:], data.qvel[:], data.qacc[:] = q, 0.0, 0.0
        mujoco.mj_forward(self._model, data)
        u = np.zeros((1, self._model.nv))
        mujoco.mj_solveM(self._model, data, u, (tau - data.qfrc_bias).reshape(1, -1))
        self._integral = u[0] / self._k_i
        self._q_last = np.array(q)
        self._dq_last = np.zeros_like(self._q_last)

    def torque(self, q: Array, dq: Array, q_cmd: Array) -> Array:
        """Torques (n,), N m, for the coming period.

        Args:
            q, dq: (n,), true joint positions and velocities now.
            q_cmd: (n,), position commanded for now; its differences give the feed-forward.
        """
        dq_cmd = (q_cmd - self._q_last) / PERIOD
        top = self._acceleration_limit
        # minimum of maximum: half the time of np.clip for so few numbers
        ddq_cmd = np.minimum(np.maximum((dq_cmd - self._dq_last) / PERIOD, -top), top)
        error = q_cmd - q
        integral = self._integral + PERIOD * error
        data = self._data
        data.qpos[:] = q
        data.qvel[:] = dq
        data.qacc[:] = ddq_cmd + self._k_d * (dq_cmd - dq) + self._k_p * error + self._k_i * integral
        mujoco.mj_inverseSkip(self._model, data, mujoco.mjtStage.mjSTAGE_NONE, SKIP_SENSORS)
        wanted = data.qfrc_inverse
        tau: Array = np.minimum(np.maximum(wanted, -self._torque_limit), self._torque_limit)
        # no wind-up: the integrator of a saturated joint stands still
        self._integral = np.where(tau == wanted, integral, self._integral)
        self._q_last, self._dq_last = q_cmd, dq_cmd
        return tau
