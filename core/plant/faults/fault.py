"""What a fault is: parameters, and the places where it gets hold of the virtual robot."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any, ClassVar, Self, TypeAlias

import mujoco
import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.cell.cell import Cell
from core.payload.inertia import InertialParameters

Three = tuple[float, float, float]
Six = tuple[float, float, float, float, float, float]

Act: TypeAlias = Callable[[float], None]
"""Called before each step with the time, s: applies forces or changes the model."""
Joints: TypeAlias = Callable[[float, Array, Array], tuple[Array, Array]]
"""Time, positions and velocities (n,) to positions and velocities; returns new arrays."""
Channel: TypeAlias = Callable[[float, Array], Array]
"""Time and wrench (6,) to a wrench; returns a new array."""


@dataclass(frozen=True)
class Setting:
    """Where a fault is planted.

    Args:
        cell: robot, sensor.
        payload: the nominal one, sensor frame.
        seconds: how long the run is going to last, about; what happens once happens within it.
    """

    cell: Cell
    payload: InertialParameters
    seconds: float = 80.0

    @cached_property
    def full_scale(self) -> Array:
        """(6,), the sensor's range, N and N m."""
        return np.array(self.cell.sensor.range)

    @cached_property
    def noise_std(self) -> Array:
        """(6,), N and N m."""
        return np.array(self.cell.sensor.noise_std)

    @cached_property
    def load(self) -> Array:
        """(6,), the largest static wrench of the nominal payload, N and N m."""
        g = float(np.linalg.norm(self.cell.gravity))
        return np.repeat([g * self.payload.mass, g * float(np.linalg.norm(self.payload.first_moment))], 3)

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.cell.robot.home_rad)


@dataclass(frozen=True)
class Machine:
    """The virtual robot as a fault sees it while it runs.

    After a step, and so in `Channel`, positions in `data` other than `qpos` are those of the instant of the wrench; in
    `Act` they are one period old, but `qpos` and `qvel` are of now.

    Args:
        model, data: MuJoCo's; what a fault changes in them stays changed, but for `data.qfrc_applied` and
            `data.xfrc_applied`, which are set anew before every step: add to them.
        motors: of the arm's joints, in `qpos`, `qvel` and the like.
        period: s.
    """

    setting: Setting
    model: mujoco.MjModel
    data: mujoco.MjData
    motors: slice | NDArray[np.int64]
    period: float

    def body(self, name: str) -> int:
        """Index of a body."""
        return int(self.model.body(name).id)

    def dof(self, joint: str) -> int:
        """Index of a joint of one degree of freedom in `qvel` and the like."""
        return int(self.model.joint(joint).dofadr[0])

    def place(self, joint: str) -> int:
        """Index of a joint in `qpos`."""
        return int(self.model.joint(joint).qposadr[0])


class Fault(ABC):
    """One thing that is wrong with the virtual robot; a frozen dataclass of its parameters.

    A parameter's name ends in its unit; `..._wrench` are six values in N and N m, `..._share` and `factor` are ratios.
    `seed` fixes what is random within the run. The hooks are asked once, before the run, and return what acts in it, or
    None; state lives there, so one fault can be planted in any number of robots. Where several faults are planted, each
    hook's results are applied in the order of the faults.
    """

    id: ClassVar[str]
    """The effect's identifier, or "unknown"."""
    variant: ClassVar[str]
    """Which of its shapes."""

    @classmethod
    @abstractmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Random parameters. At size 1 they are the plausible ones, mostly log-uniform over a decade; the deviation from the nominal
        robot grows in proportion to `size`."""

    @property
    def truth(self) -> dict[str, Any]:
        """The parameters by name, tuples as lists; fit for JSON."""
        values = asdict(self)  # type: ignore[call-overload]  # every fault is a dataclass, this base of theirs is not
        return {name: list(value) if isinstance(value, tuple) else value for name, value in values.items()}

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:  # noqa: B027 - most faults leave the model alone
        """Changes the model before it is compiled."""

    def act(self, machine: Machine) -> Act | None:
        """Forces on the bodies, and changes of the model while it runs."""
        return None

    def gear(self, machine: Machine) -> Joints | None:
        """From the joints' true position to what encoders and drives see: the arm follows its command on this side."""
        return None

    def encode(self, machine: Machine) -> Joints | None:
        """From what the encoders read to what the robot reports; the drives do not notice."""
        return None

    def sense(self, machine: Machine) -> Channel | None:
        """From the true wrench to what the sensor feels, before offset and noise."""
        return None

    def amplify(self, machine: Machine) -> Channel | None:
        """On the sensor's signal with offset and noise, before it is clipped to the range and rounded."""
        return None

    def digitize(self, machine: Machine) -> Channel | None:
        """From the rounded reading to the reported one."""
        return None


class Unknown(Fault):
    """Nothing that the library of effects describes."""

    id = "unknown"
