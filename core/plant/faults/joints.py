"""What lies between a motor and its link: springs, play, toothing, friction."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np
from numpy.typing import NDArray

from core.plant.arm import arm_of_cell
from core.plant.faults.draws import some_joints, spread
from core.plant.faults.fault import Act, Array, Fault, Joints, Machine, Setting
from core.plant.mechanics import SPRING, arm_joints

WHEEL = 0.05
"""Inertia of the gear's output side, kg m2: keeps the stiffest springs slow enough for a period of 1 ms."""
DAMPING_RATIO = 0.4
"""Of the gear's output side alone on its spring; with a link on it that is some per cent, as harmonic drives have."""
END_STOP_RATIO = 0.4
"""The same, where teeth meet."""


def add_spring(joint: mujoco.MjsJoint, stiffness: float, damping: float) -> None:
    """Puts a spring between a joint, which becomes the motor's, and its link, N m/rad and N m s/rad."""
    joint.parent.add_joint(
        name=joint.name + SPRING,
        type=mujoco.mjtJoint.mjJNT_HINGE,
        axis=np.array(joint.axis),
        stiffness=stiffness,
        damping=damping,
        armature=WHEEL,
    )


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
        """See `Fault.draw`. A larger size is a softer arm, down to 0.5 kN m/rad."""
        K = [max(spread(rng, 2e3, 10e3) / size, 500.0) for _ in range(setting.n)]
        return cls(tuple(K))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """See `Fault.alter`."""
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
        """See `Fault.draw`."""
        K = ElasticJoints.draw(rng, size, setting).stiffness_n_m_per_rad
        return cls(K, float(rng.uniform(1.8, 3.0)), size * spread(rng, 3e-4, 3e-3))

    def act(self, machine: Machine) -> Act | None:
        """See `Fault.act`."""
        extra = (self.hardening - 1) * np.array(self.stiffness_n_m_per_rad)
        w = self.wind_up_rad
        return spring_torques(machine, np.arange(len(extra)), lambda x, _: -extra * (x - w * np.tanh(x / w)))


def draw_play(rng: np.random.Generator, size: float, setting: Setting) -> tuple[float, ...]:
    """0.01 to 0.05 deg in one joint or two, rad."""
    play = size * some_joints(rng, setting.n, 2) * [math.radians(spread(rng, 0.01, 0.05)) for _ in range(setting.n)]
    return tuple(play.tolist())


@dataclass(frozen=True)
class DeadZone(Fault):
    """Teeth with play: the link moves freely against the motor within `half_play` to either side, and is held by stiff teeth beyond."""

    id = "joint_backlash"
    variant = "dead_zone"

    half_play_rad: tuple[float, ...]
    stiffness_n_m_per_rad: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(draw_play(rng, size, setting), spread(rng, 1.5e4, 3e4))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """See `Fault.alter`."""
        for joint, play in zip(arm_joints(spec), self.half_play_rad, strict=True):
            if play > 0:
                # grease damps the free flight
                add_spring(joint, 0.0, spring_damping(self.stiffness_n_m_per_rad, DAMPING_RATIO))

    def act(self, machine: Machine) -> Act | None:
        """See `Fault.act`."""
        play = np.array(self.half_play_rad)
        loose = np.flatnonzero(play)
        half, K = play[loose], self.stiffness_n_m_per_rad
        D = spring_damping(K, END_STOP_RATIO)

        def teeth(x: Array, dx: Array) -> Array:
            beyond = x - np.minimum(np.maximum(x, -half), half)
            return np.asarray(-K * beyond - D * dx * (beyond != 0))

        return spring_torques(machine, loose, teeth)


@dataclass(frozen=True)
class PlayByLoad(Fault):
    """The quasi-static shape of it: the encoder is ahead of the link by `half_play tanh(load / full_load)`, with the joint's torque as the
    load; the drives look at the link."""

    id = "joint_backlash"
    variant = "by_load"

    half_play_rad: tuple[float, ...]
    full_load_n_m: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(draw_play(rng, size, setting), spread(rng, 0.3, 2.0))

    def encode(self, machine: Machine) -> Joints | None:
        """See `Fault.encode`."""
        half, data, motors = np.array(self.half_play_rad), machine.data, machine.motors
        gain = -math.expm1(-machine.period / 0.02)
        load: Array | None = None
        last: Array | None = None

        def ahead(_: float, q: Array, dq: Array) -> tuple[Array, Array]:
            nonlocal load, last
            torque = data.qfrc_applied[motors]
            load = torque.copy() if load is None else load + gain * (torque - load)
            lead = half * np.tanh(load / self.full_load_n_m)
            rate = np.zeros_like(lead) if last is None else (lead - last) / machine.period
            last = lead
            return q + lead, dq + rate

        return ahead


@dataclass(frozen=True)
class Ripple(Fault):
    """Toothing of the gears: the encoder is ahead of the link by `A sin(N q + phase)`, A about 0.5 arcmin, two waves per turn of the wave
    generator."""

    id = "gear_ripple"
    variant = "sine"

    amplitude_rad: tuple[float, ...]
    waves_per_turn: tuple[int, ...]
    phase_rad: tuple[float, ...]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        A = [size * math.radians(spread(rng, 0.25, 1.0) / 60) for _ in range(setting.n)]
        N = [2 * int(rng.choice([50, 80, 100, 120, 160])) for _ in range(setting.n)]
        return cls(tuple(A), tuple(N), tuple(rng.uniform(0, 2 * np.pi, setting.n).tolist()))

    def gear(self, machine: Machine) -> Joints | None:
        """See `Fault.gear`."""
        A, N, phase = np.array(self.amplitude_rad), np.array(self.waves_per_turn), np.array(self.phase_rad)
        return lambda _, q, dq: (q + A * np.sin(N * q + phase), dq * (1 + A * N * np.cos(N * q + phase)))


@dataclass(frozen=True)
class UnevenRipple(Ripple):
    """A ripple that is stronger on one side of the turn, with half as much of the second harmonic."""

    variant = "modulated"

    def gear(self, machine: Machine) -> Joints | None:
        """See `Fault.gear`."""
        A, N, phase = np.array(self.amplitude_rad), np.array(self.waves_per_turn), np.array(self.phase_rad)

        def ahead(_: float, q: Array, dq: Array) -> tuple[Array, Array]:
            strength, change = A * (1 + 0.7 * np.sin(q + 2 * phase)), 0.7 * A * np.cos(q + 2 * phase)
            wave = np.sin(N * q + phase) + 0.5 * np.sin(2 * N * q)
            slope = N * (np.cos(N * q + phase) + np.cos(2 * N * q))
            return q + strength * wave, dq * (1 + strength * slope + change * wave)

        return ahead


def draw_friction(rng: np.random.Generator, size: float, setting: Setting) -> tuple[float, ...]:
    """1 to 15 N m in one to all joints, at most 0.2 of a joint's torque; N m."""
    chosen = some_joints(rng, setting.n, setting.n)
    most = 0.2 * arm_of_cell(setting.cell).effort
    return tuple((size * chosen * [min(spread(rng, 1.0, 15.0), top) for top in most]).tolist())


@dataclass(frozen=True)
class DryFriction(Fault):
    """More dry and viscous friction than the drives are known to have."""

    id = "joint_friction"
    variant = "coulomb_viscous"

    dry_n_m: tuple[float, ...]
    viscous_n_m_s_per_rad: tuple[float, ...]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        dry = draw_friction(rng, size, setting)
        return cls(dry, tuple(value * float(rng.uniform(0.3, 2.0)) for value in dry))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """See `Fault.alter`."""
        for joint, dry, viscous in zip(arm_joints(spec), self.dry_n_m, self.viscous_n_m_s_per_rad, strict=True):
            joint.frictionloss += dry
            joint.damping = np.asarray(joint.damping) + np.eye(np.size(joint.damping))[0] * viscous


@dataclass(frozen=True)
class LuGre(Fault):
    """Friction of bristles (Canudas de Wit et al. 1995): `dz = v - s |v| z / g(v)`, torque `s z + d dz`, `g = dry + (stiction - dry)
    exp(-(v / stribeck)^2)`, which stiffens before it slips and is larger at rest than in motion."""

    id = "joint_friction"
    variant = "lugre"

    dry_n_m: tuple[float, ...]
    stiction_share: float
    stribeck_rad_per_s: float
    bristle_n_m_per_rad: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(draw_friction(rng, size, setting), float(rng.uniform(0.2, 0.8)), spread(rng, 0.01, 0.05), spread(rng, 3e3, 1e4))

    def act(self, machine: Machine) -> Act | None:
        """See `Fault.act`. The bristles' equation is solved exactly for a velocity that is constant over the period."""
        dry, s = np.array(self.dry_n_m), self.bristle_n_m_per_rad
        rubbing = np.flatnonzero(dry)
        dry = dry[rubbing]
        dofs = np.arange(machine.model.nv)[machine.motors][rubbing]
        data, period = machine.data, machine.period
        d = 2 * 0.3 * math.sqrt(s * 0.2)
        z = np.zeros(len(dry))

        def rub(_: float) -> None:
            nonlocal z
            v = data.qvel[dofs]
            g = dry * (1 + self.stiction_share * np.exp(-((v / self.stribeck_rad_per_s) ** 2)))
            rate = s * np.abs(v) / g
            slipping = -np.expm1(-rate * period)
            before = z
            z = z + np.where(rate * period > 1e-9, (np.sign(v) * g / s - z) * slipping, period * v)
            # bristles damp while they bend, not while they slide
            data.qfrc_applied[dofs] -= s * z + d * (z - before) / period

        return rub


JOINTS: tuple[type[Fault], ...] = (
    ElasticJoints,
    HardeningJoints,
    DeadZone,
    PlayByLoad,
    Ripple,
    UnevenRipple,
    DryFriction,
    LuGre,
)
