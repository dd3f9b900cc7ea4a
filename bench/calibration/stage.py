"""What trials are made of: a run whose wrench is Newton's law for point masses, what is planted in it, and a background of small faults."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from types import SimpleNamespace
from typing import Any

import numpy as np
import pinocchio as pin

from bench.diagnosis_elsewhere import Stage, record_over_background
from core.array import Array
from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.plant.faults import Fault, Setting
from core.recording.recording import Recording, SensorDescription
from tests.synthetic import CELLS, NOISE_STD, RESOLUTION, payload, random_payload, run_of, wrench_of

PERIOD_S = 0.0125
AXES = ("xyz", "xyz", "xy", "yz", "xz")
"""About which a run turns; a cell does not have room for each."""
CELL_NAMES = ("lwr4_bench", "ur5e_line")
RUNS = 40
"""Different motions in each cell."""
NOISE = (0.3, 1.5)
"""Times the noise of the paper's sensor: what 1 kHz averages away, and a bad one."""
BACKGROUND = (0.3, 2.0)
"""Times the background of `bench.diagnosis_elsewhere`."""


@dataclass
class Play(Stage):
    """A stage with what mechanical faults need besides."""

    cell: Cell
    size: float

    @cached_property
    def place(self) -> Array:
        """(N, 3), of the sensor's origin, base axes, m."""
        return np.array([self.run.robot.sensor_pose(q).position for q in self.run.q])

    @cached_property
    def dq(self) -> Array:
        """(N, n), rad/s."""
        return np.asarray(np.gradient(self.run.q, PERIOD_S, axis=0))

    @cached_property
    def joint_torque(self) -> Array:
        """(N, n), that the joints give to arm and payload, N m."""
        robot = self.run.robot
        ddq = np.gradient(self.dq, PERIOD_S, axis=0)
        arm = np.array([pin.rnea(robot.model, robot.data, *row) for row in zip(self.run.q, self.dq, ddq, strict=True)])
        return np.asarray(arm + np.einsum("kij,ki->kj", robot.sensor_jacobians(self.run.q), self.wrench))

    @cached_property
    def specific(self) -> Array:
        """(N, 3), specific force at the sensor's origin, sensor axes, m/s2."""
        return np.asarray(np.einsum("nji,nj->ni", self.run.rotation, self.run.a - [0.0, 0.0, -9.81]))

    def to_sensor(self, v: Array) -> Array:
        """(N, 3), vectors from base to sensor axes."""
        return np.asarray(np.einsum("nji,nj->ni", self.run.rotation, np.broadcast_to(v, (len(self.run.t), 3))))

    def plant(self, fault: Fault) -> None:
        """Lets a fault of the virtual robot act, sample by sample, where it acts on signals alone."""
        machine: Any = self._machine()
        t, q, dq = self.run.t - self.run.t[0], self.read.copy(), self.dq.copy()
        for hook in (fault.gear(machine), fault.encode(machine)):
            for k in range(len(t) if hook else 0):
                q[k], dq[k] = hook(float(t[k]), q[k], dq[k])  # type: ignore[misc]  # there is a hook where there are rows
        self.read = q
        for channel in (fault.sense(machine), fault.amplify(machine), fault.digitize(machine)):
            for k in range(len(t) if channel else 0):
                machine.data.qpos, machine.data.qvel = self.run.q[k], self.dq[k]
                machine.data.qfrc_applied, machine.data.xpos = self.joint_torque[k], [self.place[k]]
                self.wrench[k] = channel(float(t[k]), self.wrench[k].copy())  # type: ignore[misc]  # likewise

    def _machine(self) -> SimpleNamespace:
        """What a fault that acts on signals asks of the virtual robot."""
        n = self.run.q.shape[1]
        setting = Setting(self.cell, self.body, float(np.ptp(self.run.t)))
        data = SimpleNamespace(qpos=None, qvel=None, qfrc_applied=None, xpos=None)
        model = SimpleNamespace(nv=n)
        return SimpleNamespace(setting=setting, model=model, data=data, motors=slice(0, n), period=PERIOD_S, body=lambda _: 0)

    @property
    def setting(self) -> Setting:
        """Where faults are planted."""
        return Setting(self.cell, self.body, float(np.ptp(self.run.t)))

    def record(self, clean: Array) -> Recording:
        """As a sensor and encoders see it, over a background of a random size."""
        factor = float(np.exp(self.rng.uniform(*np.log(NOISE))))
        made = record_over_background(self, clean, self.rng, float(np.exp(self.rng.uniform(*np.log(BACKGROUND)))), factor)
        return replace(made, sensor=SensorDescription(noise_std=factor * NOISE_STD, resolution=RESOLUTION))


def set_stage(seed: int) -> Play:
    """A random run with a random payload, nothing planted yet."""
    rng = np.random.default_rng([seed, 77])
    name = CELL_NAMES[int(rng.integers(2))]
    cell = load_cell(CELLS / name)
    run = run_of(name, 1000 + int(rng.integers(RUNS)), repetitions=1, period=PERIOD_S, axes=str(rng.choice(AXES)))
    known = sorted(cell.payloads)
    body = payload(known[int(rng.integers(len(known)))], name) if rng.random() < 0.5 else random_payload(rng)
    size = float(np.exp(rng.uniform(np.log(0.5), np.log(3.0))))
    return Play(run, body, rng, wrench_of(run, body), run.q.copy(), cell, size)
