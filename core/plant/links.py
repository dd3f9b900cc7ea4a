"""The moving mechanism: arm, payload, and what faults have added between or behind them."""

from __future__ import annotations

from typing import NamedTuple

import mujoco
import numpy as np

from core.array import Array
from core.plant.arm import Arm
from core.plant.faults.fault import Act, Fault, Machine, Setting
from core.plant.mechanics import PERIOD, SPRING

LOCKED = 1e7
"""kg m2; an arm as heavy as this does not move while the rest comes to rest."""
REST_STEPS = 3000
REST_DAMPING = 0.99
"""Share of its velocity that every step leaves to what comes to rest."""


class LinkSideState(NamedTuple):
    """Joints on the link side (n,), and the wrench (6,), all of one instant."""

    q: Array
    dq: Array
    ddq: Array
    wrench: Array


class Links:
    """The compiled model with the forces that faults apply to it.

    Args:
        arm: its joints come first in the model; some may have a spring behind them.
        spec: as `build_spec` makes it; faults change it here.
    """

    def __init__(self, arm: Arm, spec: mujoco.MjSpec, setting: Setting, faults: tuple[Fault, ...]) -> None:
        for fault in faults:
            fault.alter(spec, setting)
        self._model = model = spec.compile()
        self._data = data = mujoco.MjData(model)
        names = {model.joint(k).name: k for k in range(model.njnt)}
        motors = np.array([names[joint.name] for joint in arm.joints])
        springs = [names[joint.name + SPRING] for joint in arm.joints if joint.name + SPRING in names]
        # a slice costs less than a list of indices in every step
        self._motors = slice(0, arm.n) if np.array_equal(motors, np.arange(arm.n)) else motors
        self._springs = np.array(springs)
        self._sprung = np.array([k for k, joint in enumerate(arm.joints) if joint.name + SPRING in names])
        self.machine = Machine(setting, model, data, self._motors, PERIOD)
        self._faults = faults
        self._acts: list[Act] = []

    def rest(self, home: Array) -> Array:
        """Brings everything to rest with the motors at home (n,), and returns the torques (n,) that hold them there.

        What the faults do begins here.
        """
        model, data = self._model, self._data
        motors = self._motors
        data.qpos[motors] = home
        mujoco.mj_forward(model, data)
        self._acts = [act for fault in self._faults if (act := fault.act(self.machine)) is not None]
        if model.nv > len(home):
            armature = model.dof_armature.copy()
            model.dof_armature[motors] = LOCKED
            for _ in range(REST_STEPS):
                self._apply(0.0, np.zeros(len(home)))
                mujoco.mj_step(model, data)
                data.qpos[motors], data.qvel[motors] = home, 0.0
                data.qvel[:] *= REST_DAMPING
            model.dof_armature[:] = armature
            data.qvel[:], data.qacc_warmstart[:] = 0.0, 0.0
        if model.nv > len(home) or self._acts:
            self._apply(0.0, np.zeros(len(home)))
            mujoco.mj_forward(model, data)
        return np.array(-data.qfrc_smooth[motors])

    def motors(self) -> tuple[Array, Array]:
        """Positions and velocities (n,) of the motors now."""
        data = self._data
        if isinstance(self._motors, slice):
            return data.qpos[self._motors].copy(), data.qvel[self._motors].copy()
        return data.qpos[self._motors], data.qvel[self._motors]

    def step(self, t: float, q: Array, dq: Array, tau: Array) -> LinkSideState:
        """One period under the torques tau (n,); returns what was at its beginning.

        Args:
            q, dq: (n,), what `motors` said.
        """
        data = self._data
        springs = self._springs
        if len(springs):
            q, dq = q.copy(), dq.copy()
            q[self._sprung] += data.qpos[springs]
            dq[self._sprung] += data.qvel[springs]
        self._apply(t, tau)
        # accelerations and sensors after a step still belong to the instant before it, which is that of q, dq and tau
        mujoco.mj_step(self._model, data)
        ddq = np.array(data.qacc[self._motors])
        if len(springs):
            ddq[self._sprung] += data.qacc[springs]
        return LinkSideState(q, dq, ddq, data.sensordata.copy())

    def _apply(self, t: float, tau: Array) -> None:
        data = self._data
        if not self._acts:
            data.qfrc_applied[self._motors] = tau
            return
        data.qfrc_applied[:] = 0.0
        data.xfrc_applied[:] = 0.0
        data.qfrc_applied[self._motors] = tau
        for act in self._acts:
            act(t)
