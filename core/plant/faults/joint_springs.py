"""Springs between a motor and its link."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.plant.arm import arm_of_cell
from core.plant.faults.draws import draw_log_uniform
from core.plant.faults.fault import Act, Fault, Machine, Setting
from core.plant.mechanics import SPRING, arm_joints

WHEEL = 0.05
"""Inertia of the gear's output side, kg m2: keeps the stiffest springs slow enough for a period of 1 ms."""


DAMPING_RATIO = 0.4
"""Of the gear's output side alone on its spring; with a link on it that is some per cent, as harmonic drives have."""


def add_spring(joint: mujoco.MjsJoint, stiffness: float, damping: float) -> None:
    """Puts a spring between a joint, which becomes the motor's, and its link, in the place of one that is there; N m/rad and N m s/rad."""
    name = joint.name + SPRING
    there = [spring for spring in joint.parent.joints if spring.name == name]
    spring = there[0] if there else joint.parent.add_joint(name=name, type=mujoco.mjtJoint.mjJNT_HINGE, axis=np.array(joint.axis))
    linear = np.eye(np.size(spring.stiffness))[0]
    spring.stiffness, spring.damping, spring.armature = stiffness * linear, damping * linear, WHEEL


def spring_damping(stiffness: float, ratio: float = DAMPING_RATIO) -> float:
    """N m s/rad."""
    return 2 * ratio * math.sqrt(stiffness * WHEEL)


def spring_torques(machine: Machine, joints: NDArray[np.intp], torque: Callable[[Array, Array], Array]) -> Act:
    """Adds `torque(twist, twist rate)` of the springs behind some joints (indices) to the forces on them."""
    dofs = np.array([_spring_dofs(machine)[int(k)] for k in joints])
    data = machine.data

    def pull(_: float) -> None:
        data.qfrc_applied[dofs] += torque(data.qpos[dofs], data.qvel[dofs])

    return pull


def _spring_dofs(machine: Machine) -> dict[int, int]:
    """Where a joint's spring is, in `qpos` and `qvel` alike, by the joint's index."""
    joints = arm_of_cell(machine.setting.cell).joints
    names = {machine.model.joint(k).name for k in range(machine.model.njnt)}
    return {k: machine.dof(joint.name + SPRING) for k, joint in enumerate(joints) if joint.name + SPRING in names}


@dataclass(frozen=True)
class ElasticJoints(Fault):
    """Motor and link are two masses with a spring between them, 2 to 10 kN m/rad; the encoder is on the motor's side."""

    id = "joint_elasticity"
    variant = "two_mass"

    stiffness_n_m_per_rad: tuple[float, ...]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """2 to 10 kN m/rad in each joint; a larger size is a softer arm, down to 0.5 kN m/rad."""
        K = [max(draw_log_uniform(rng, 2e3, 10e3) / size, 500.0) for _ in range(setting.n)]
        return cls(tuple(K))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Puts a spring and a damper between motor and link of each joint."""
        for joint, K in zip(arm_joints(spec), self.stiffness_n_m_per_rad, strict=True):
            add_spring(joint, K, spring_damping(K))


@dataclass(frozen=True)
class HardeningJoints(ElasticJoints):
    """Soft at first and stiffer under load, as harmonic drives are: the torque of the spring is `K x + K (h - 1) (x - w tanh(x / w))`, so
    its stiffness rises from K to h K beyond a wind-up w."""

    variant = "hardening"

    hardening: float
    wind_up_rad: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Springs as `ElasticJoints` draws them, 1.8 to 3 times as stiff beyond a wind-up of 3e-4 to 3e-3 rad."""
        K = ElasticJoints.draw(rng, size, setting).stiffness_n_m_per_rad
        return cls(K, float(rng.uniform(1.8, 3.0)), size * draw_log_uniform(rng, 3e-4, 3e-3))

    def act(self, machine: Machine) -> Act | None:
        """Adds the torque `-K (h - 1) (x - w tanh(x / w))` to the springs."""
        extra = (self.hardening - 1) * np.array(self.stiffness_n_m_per_rad)
        w = self.wind_up_rad
        return spring_torques(machine, np.arange(len(extra)), lambda x, _: -extra * (x - w * np.tanh(x / w)))


@dataclass(frozen=True)
class CreepingJoints(ElasticJoints):
    """Stiff against what changes fast, and giving way farther under what stays, as belts and plastic wheels do: beside the spring K a
    spring of `creep K` in series with a damper (the standard linear solid); it has carried its load for long at the start."""

    variant = "creeping"

    creep_share: float
    time_constant_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Springs as `ElasticJoints` draws them, and beside them 0.4 to 1 of their stiffness that creeps within 0.5 to 5 s."""
        K = ElasticJoints.draw(rng, size, setting).stiffness_n_m_per_rad
        return cls(K, float(rng.uniform(0.4, 1.0)), draw_log_uniform(rng, 0.5, 5.0))

    def act(self, machine: Machine) -> Act | None:
        """Adds the torque `-creep K (x - crept)` to the springs, `crept` following x with the time constant."""
        extra, forget = self.creep_share * np.array(self.stiffness_n_m_per_rad), -math.expm1(-machine.period / self.time_constant_s)
        now, crept = 0.0, np.zeros(len(extra))

        def branch(x: Array, _: Array) -> Array:
            nonlocal crept
            crept = x.copy() if now == 0.0 else crept + forget * (x - crept)
            return np.asarray(-extra * (x - crept))

        pull = spring_torques(machine, np.arange(len(extra)), branch)

        def creep(t: float) -> None:
            nonlocal now
            now = t
            pull(t)

        return creep


@dataclass(frozen=True)
class LossyJoints(ElasticJoints):
    """Wind up on another line than they unwind, however slowly, as the flexible wheels of harmonic drives do (Dahl's model beside
    the spring): after each turn back `reversal` times as stiff, until the wheel has given way by about `bend`; relaxed under its load at
    the start."""

    variant = "lossy"

    reversal: float
    bend_rad: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Springs as `ElasticJoints` draws them, 1.5 to 3 times as stiff over 2e-4 to 2e-3 rad after a turn back."""
        K = ElasticJoints.draw(rng, size, setting).stiffness_n_m_per_rad
        return cls(K, float(rng.uniform(1.5, 3.0)), size * draw_log_uniform(rng, 2e-4, 2e-3))

    def act(self, machine: Machine) -> Act | None:
        """Adds the torque `-K (reversal - 1) bend z` to the springs, `dz = (1 - sign(dx) z) dx / bend`, solved exactly along the way."""
        height, bend = (self.reversal - 1) * self.bend_rad * np.array(self.stiffness_n_m_per_rad), self.bend_rad
        now, last, z = 0.0, np.zeros(len(height)), np.zeros(len(height))

        def branch(x: Array, _: Array) -> Array:
            nonlocal last, z
            way, last = x - last, x.copy()
            if now > 0:
                z = np.sign(way) + (z - np.sign(way)) * np.exp(-np.abs(way) / bend)
            return np.asarray(-height * z)

        pull = spring_torques(machine, np.arange(len(height)), branch)

        def lose(t: float) -> None:
            nonlocal now
            now = t
            pull(t)

        return lose


JOINT_SPRINGS: tuple[type[Fault], ...] = (
    ElasticJoints,
    HardeningJoints,
    CreepingJoints,
    LossyJoints,
)
