"""Play between a motor and its link."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np

from core.array import Array
from core.plant.faults.draws import draw_log_uniform, some_joints
from core.plant.faults.fault import Act, Fault, Joints, Machine, Setting
from core.plant.faults.joint_springs import DAMPING_RATIO, add_spring, spring_damping, spring_torques
from core.plant.mechanics import arm_joints

END_STOP_RATIO = 0.4
"""The same, where teeth meet."""


def draw_play(rng: np.random.Generator, size: float, setting: Setting) -> tuple[float, ...]:
    """0.01 to 0.05 deg in one joint or two, rad."""
    play = size * some_joints(rng, setting.n, 2) * [math.radians(draw_log_uniform(rng, 0.01, 0.05)) for _ in range(setting.n)]
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
        """0.01 to 0.05 deg to either side in one joint or two, teeth of 1.5e4 to 3e4 N m/rad."""
        return cls(draw_play(rng, size, setting), draw_log_uniform(rng, 1.5e4, 3e4))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Puts a damper without a spring between motor and link of each joint with play."""
        for joint, play in zip(arm_joints(spec), self.half_play_rad, strict=True):
            if play > 0:
                # grease damps the free flight
                add_spring(joint, 0.0, spring_damping(self.stiffness_n_m_per_rad, DAMPING_RATIO))

    def act(self, machine: Machine) -> Act | None:
        """Holds the link by stiff and damped teeth where it is beyond `half_play_rad`."""
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
        """0.01 to 0.05 deg to either side in one joint or two, full load of 0.3 to 2 N m."""
        return cls(draw_play(rng, size, setting), draw_log_uniform(rng, 0.3, 2.0))

    def encode(self, machine: Machine) -> Joints | None:
        """Reports `q + half_play tanh(load / full_load)` and its rate, the load behind a low-pass of 20 ms."""
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
class PlayByMotion(Fault):
    """Where friction, not weight, holds the link: it stays behind when the motor turns back, until the play is used up (the play
    operator on the motor's way). The encoder is ahead of the link in the direction of motion; the drives look at the link."""

    id = "joint_backlash"
    variant = "by_motion"

    half_play_rad: tuple[float, ...]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.01 to 0.05 deg to either side in one joint or two."""
        return cls(draw_play(rng, size, setting))

    def encode(self, machine: Machine) -> Joints | None:
        """Reports `q + (q - behind)` and its rate, `behind` what the play operator makes of q."""
        half = np.array(self.half_play_rad)
        behind: Array | None = None
        lead = np.zeros(len(half))

        def ahead(_: float, q: Array, dq: Array) -> tuple[Array, Array]:
            nonlocal behind, lead
            behind = q if behind is None else np.minimum(np.maximum(behind, q - half), q + half)
            before, lead = lead, q - behind
            return q + lead, dq + (lead - before) / machine.period

        return ahead


@dataclass(frozen=True)
class SplitGear(DeadZone):
    """A wheel in two halves that springs hold against both flanks, as is done against play, and the springs have become weak: no play below
    their preload; beyond it they give way, nearly free, over `half_play`, and then the teeth themselves meet."""

    variant = "split_gear"

    preload_n_m: float
    soft_share: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Play and teeth as `DeadZone` draws them, preload of 0.5 to 5 N m, springs of 2 to 8 % of the teeth's stiffness."""
        free = DeadZone.draw(rng, size, setting)
        return cls(free.half_play_rad, free.stiffness_n_m_per_rad, draw_log_uniform(rng, 0.5, 5.0), float(rng.uniform(0.02, 0.08)))

    def act(self, machine: Machine) -> Act | None:
        """Holds the link by stiff teeth up to the preload, by soft springs over the play and by stiff teeth beyond."""
        play = np.array(self.half_play_rad)
        loose = np.flatnonzero(play)
        half, K, tight = play[loose], self.stiffness_n_m_per_rad, self.preload_n_m / self.stiffness_n_m_per_rad

        def teeth(x: Array, _: Array) -> Array:
            away = np.abs(x)
            opened = np.minimum(np.maximum(away - tight, 0.0), half)
            return np.asarray(-K * np.sign(x) * (away - (1 - self.soft_share) * opened))

        return spring_torques(machine, loose, teeth)


JOINT_PLAY: tuple[type[Fault], ...] = (
    DeadZone,
    PlayByLoad,
    PlayByMotion,
    SplitGear,
)
