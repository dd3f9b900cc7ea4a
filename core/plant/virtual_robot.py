"""The virtual robot: arm, drives, controller, encoders and wrist sensor, one period at a time."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from core.cell import Cell
from core.inertia import InertialParameters
from core.plant.arm import arm_of_cell
from core.plant.controller import JointController
from core.plant.imperfections import Imperfections
from core.plant.mechanics import PERIOD, Drives, build_model
from core.plant.sensor import Encoders, WhiteNoise, WristSensor

Array = NDArray[np.float64]

TORQUE_NOISE = 1e-3
"""Standard deviation of a measured joint torque, share of the joint's torque limit."""


@dataclass(frozen=True)
class Sample:
    """What the robot reports of one instant, SI; names as in `RobotState`."""

    t: float
    q: Array
    dq: Array
    q_cmd: Array
    wrench: Array
    tau: Array


@dataclass(frozen=True)
class Truth:
    """What really was at the instant of the last sample. For tests only.

    Args:
        q, dq, ddq: (n,), joints.
        tau: (n,), drive torques, N m.
        wrench: (6,), on the payload, sensor axes, about the sensor origin.
        offset: (6,), of the wrist sensor, without drift.
    """

    t: float
    q: Array
    dq: Array
    ddq: Array
    tau: Array
    wrench: Array
    offset: Array


class VirtualRobot:
    """The cell's robot with a payload, standing at home to begin with.

    Args:
        cell: arm, sensor, gravity, base pose.
        payload: what it really carries, sensor frame; all zero for nothing.
        rng: source of all chance: offset first, then the noise of every period.
        imperfections: what is planted.
        drives: mechanical properties of the joints.
    """

    def __init__(
        self,
        cell: Cell,
        payload: InertialParameters,
        rng: np.random.Generator,
        *,
        imperfections: Imperfections | None = None,
        drives: Drives | None = None,
    ) -> None:
        faults, drives = imperfections or Imperfections(), drives or Drives()
        self.arm = arm_of_cell(cell)
        self.home = np.array(cell.robot.home_rad)
        self._model = build_model(self.arm, payload, tilted_gravity(cell, faults.base_tilt_rad), drives)
        self._data = data = mujoco.MjData(self._model)
        data.qpos[:] = self.home
        mujoco.mj_forward(self._model, data)
        frictionless = Drives(drives.armature_s2, drives.damping_s, friction=0.0)
        self._controller = JointController(
            build_model(self.arm, InertialParameters(np.zeros(10)), cell.gravity, frictionless),
            torque_limit=self.arm.effort,
            acceleration_limit=2 * np.array(cell.robot.acceleration_rad_s2),
        )
        self._controller.settle(self.home, np.array(data.qfrc_bias))
        self._sensor = WristSensor(cell.sensor, rng, period=PERIOD, delay=faults.wrench_delay_s, drift=faults.offset_drift)
        self._encoders = Encoders(self.home, period=PERIOD)
        self._noise = WhiteNoise(rng, 6 + 2 * self.arm.n)
        self._torque_noise = TORQUE_NOISE * self.arm.effort
        self._tick = 0
        self._truth: Truth | None = None

    @property
    def truth(self) -> Truth:
        """What really was at the last sample."""
        if self._truth is None:
            raise RuntimeError("the virtual robot has made no step yet")
        return self._truth

    def step(self, q_cmd: Array) -> Sample:
        """Waits for the next control instant, applies the position commanded for it, and samples.

        Args:
            q_cmd: (n,), rad; kept, so it must not change afterwards.
        """
        data, n = self._data, self.arm.n
        t = PERIOD * self._tick
        q, dq = data.qpos.copy(), data.qvel.copy()
        tau = self._controller.torque(q, dq, q_cmd)
        data.qfrc_applied[:] = tau
        # accelerations and sensors after a step still belong to the instant before it, which is that of q, dq and tau
        mujoco.mj_step(self._model, data)
        wrench = data.sensordata.copy()
        self._truth = Truth(t, q, dq, data.qacc.copy(), tau, wrench, self._sensor.offset)
        self._tick += 1
        noise = self._noise.row()
        joints = self._encoders.read(q, noise[6 : 6 + n])
        return Sample(
            t,
            joints.q,
            joints.dq,
            q_cmd,
            self._sensor.read(t, wrench, noise[:6]),
            tau + self._torque_noise * noise[6 + n :],
        )


def tilted_gravity(cell: Cell, tilt_rad: tuple[float, float]) -> Array:
    """(3,), gravity in the world frame of a cell whose base stands tilted; see `Imperfections`."""
    R_base = cell.robot.base.rotation
    tilt = Rotation.from_rotvec([*tilt_rad, 0.0]).as_matrix()
    return np.asarray(R_base @ tilt @ R_base.T @ cell.gravity)
