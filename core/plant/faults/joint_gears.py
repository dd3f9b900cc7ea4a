"""The toothing and the friction of the gears between a motor and its link."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np

from core.array import Array
from core.plant.arm import arm_of_cell
from core.plant.faults.draws import draw_log_uniform, draw_signed_log_uniform, some_joints
from core.plant.faults.fault import Act, Fault, Joints, Machine, Setting
from core.plant.mechanics import arm_joints


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
        """0.25 to 1 arcmin in all joints, gear ratios of 50 to 160 with two waves each, any phase."""
        A = [size * math.radians(draw_log_uniform(rng, 0.25, 1.0) / 60) for _ in range(setting.n)]
        N = [2 * int(rng.choice([50, 80, 100, 120, 160])) for _ in range(setting.n)]
        return cls(tuple(A), tuple(N), tuple(rng.uniform(0, 2 * np.pi, setting.n).tolist()))

    def gear(self, machine: Machine) -> Joints | None:
        """Shows `q + A sin(N q + phase)` and its rate."""
        A, N, phase = np.array(self.amplitude_rad), np.array(self.waves_per_turn), np.array(self.phase_rad)
        return lambda _, q, dq: (q + A * np.sin(N * q + phase), dq * (1 + A * N * np.cos(N * q + phase)))


@dataclass(frozen=True)
class UnevenRipple(Ripple):
    """A ripple that is stronger on one side of the turn, with half as much of the second harmonic."""

    variant = "modulated"

    def gear(self, machine: Machine) -> Joints | None:
        """Shows `q + A (1 + 0.7 sin(q + 2 phase)) (sin(N q + phase) + sin(2 N q) / 2)` and its rate."""
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
    return tuple((size * chosen * [min(draw_log_uniform(rng, 1.0, 15.0), top) for top in most]).tolist())


@dataclass(frozen=True)
class DryFriction(Fault):
    """More dry and viscous friction than the drives are known to have."""

    id = "joint_friction"
    variant = "coulomb_viscous"

    dry_n_m: tuple[float, ...]
    viscous_n_m_s_per_rad: tuple[float, ...]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 15 N m in one to all joints, and 0.3 to 2 N m s/rad per N m of it."""
        dry = draw_friction(rng, size, setting)
        return cls(dry, tuple(value * float(rng.uniform(0.3, 2.0)) for value in dry))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Adds dry and viscous friction to the joints of the model."""
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
        """1 to 15 N m in one to all joints, stiction 20 to 80 % above, Stribeck velocity 0.01 to 0.05 rad/s, 3e3 to 1e4 N m/rad."""
        return cls(
            draw_friction(rng, size, setting),
            float(rng.uniform(0.2, 0.8)),
            draw_log_uniform(rng, 0.01, 0.05),
            draw_log_uniform(rng, 3e3, 1e4),
        )

    def act(self, machine: Machine) -> Act | None:
        """Takes the bristles' torque off the joints; their equation is solved exactly for a velocity that is constant over the period."""
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


@dataclass(frozen=True)
class DamagedTooth(Fault):
    """One bad tooth: once per turn of the wave generator the encoder leads the link by a short pulse `A exp(k (cos(N q + phase) - 1))`,
    in one to three joints."""

    id = "gear_ripple"
    variant = "pulses"

    height_rad: tuple[float, ...]
    turns_per_turn: tuple[int, ...]
    phase_rad: tuple[float, ...]
    sharpness: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.5 to 2 arcmin with either sign in one to three joints, gear ratios of 50 to 160, any phase, sharpness 3 to 10."""
        A = size * some_joints(rng, setting.n, 3) * np.radians(draw_signed_log_uniform(rng, 0.5, 2.0, setting.n) / 60)
        N = [int(rng.choice([50, 80, 100, 120, 160])) for _ in range(setting.n)]
        return cls(tuple(A.tolist()), tuple(N), tuple(rng.uniform(0, 2 * np.pi, setting.n).tolist()), draw_log_uniform(rng, 3.0, 10.0))

    def gear(self, machine: Machine) -> Joints | None:
        """Shows `q + A exp(k (cos(N q + phase) - 1))` and its rate."""
        A, N, phase, k = np.array(self.height_rad), np.array(self.turns_per_turn), np.array(self.phase_rad), self.sharpness

        def ahead(_: float, q: Array, dq: Array) -> tuple[Array, Array]:
            turn = N * q + phase
            pulse = A * np.exp(k * (np.cos(turn) - 1))
            return q + pulse, dq * (1 - k * N * np.sin(turn) * pulse)

        return ahead


@dataclass(frozen=True)
class FrictionByLoad(Fault):
    """Dry friction that grows with the load on the teeth (Hamon et al. 2010): `dry + share |torque|`, where it is always more than the
    drives are known to have."""

    id = "joint_friction"
    variant = "by_load"

    dry_n_m: tuple[float, ...]
    load_share: tuple[float, ...]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.5 to 7.5 N m in one to all joints, and 3 to 12 % of the load there."""
        dry = np.array(draw_friction(rng, size, setting))
        share = size * (dry > 0) * np.abs(draw_signed_log_uniform(rng, 0.03, 0.12, setting.n))
        return cls(tuple((0.5 * dry).tolist()), tuple(share.tolist()))

    def act(self, machine: Machine) -> Act | None:
        """Sets the dry friction of each joint to the drive's own plus `dry + share |torque|`, with the drive's torque of now."""
        model, data = machine.model, machine.data
        dofs = np.arange(model.nv)[machine.motors]
        least, share = model.dof_frictionloss[dofs] + np.array(self.dry_n_m), np.array(self.load_share)

        def rub(_: float) -> None:
            model.dof_frictionloss[dofs] = least + share * np.abs(data.qfrc_applied[dofs])

        return rub


@dataclass(frozen=True)
class LoadedRipple(Ripple):
    """Teeth that bend, more or less stiffly from tooth to tooth: the ripple grows with the weight that the gear carries and lies on the
    other flank when that turns round, `A tanh(load / full_load) sin(N q + phase)`; none where a joint carries nothing."""

    variant = "by_load"

    full_load_n_m: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """A ripple as `Ripple` draws it, full at 1 to 8 N m."""
        free = Ripple.draw(rng, size, setting)
        return cls(free.amplitude_rad, free.waves_per_turn, free.phase_rad, draw_log_uniform(rng, 1.0, 8.0))

    def gear(self, machine: Machine) -> Joints | None:
        """Shows `q + A tanh(load / full_load) sin(N q + phase)` and its rate, the load that of weight and centrifugal forces."""
        A, N, phase = np.array(self.amplitude_rad), np.array(self.waves_per_turn), np.array(self.phase_rad)
        model, data, motors = machine.model, machine.data, machine.motors
        data.qpos[motors] = machine.setting.cell.robot.home_rad
        mujoco.mj_forward(model, data)  # drives ask for the first time before anything has come to rest
        last: Array | None = None

        def ahead(_: float, q: Array, dq: Array) -> tuple[Array, Array]:
            nonlocal last
            strength = A * np.tanh(data.qfrc_bias[motors] / self.full_load_n_m)
            change = np.zeros_like(strength) if last is None else (strength - last) / machine.period
            last = strength
            wave, slope = np.sin(N * q + phase), N * np.cos(N * q + phase)
            return q + strength * wave, dq * (1 + strength * slope) + change * wave

        return ahead


JOINT_GEARS: tuple[type[Fault], ...] = (
    Ripple,
    UnevenRipple,
    DryFriction,
    LuGre,
    DamagedTooth,
    FrictionByLoad,
    LoadedRipple,
)
