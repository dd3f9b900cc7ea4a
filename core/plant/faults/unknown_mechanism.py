"""What goes wrong in the cell's mechanics and has no name in the table of effects."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np

from core.array import Array
from core.plant.arm import arm_of_cell
from core.plant.faults.base import lean_gravity, tilt_of
from core.plant.faults.draws import direction, draw_log_uniform, draw_signed_log_uniform, sign, some_joints, three
from core.plant.faults.fault import Act, Fault, Joints, Machine, Setting, Three, Unknown
from core.plant.faults.grip import Grip, cross_vectors, grip_of
from core.plant.faults.mounting import turn_frame
from core.plant.mechanics import arm_joints


@dataclass(frozen=True)
class WarpingBase(Unknown):
    """The sun on one side of the column: the base leans over with time, `tilt (1 - exp(-t / time_constant))`."""

    variant = "warping_base"

    tilt_rad: tuple[float, float]
    time_constant_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.2 to 2 deg in any direction, time constant of 0.2 to 1 of the run."""
        return cls(tilt_of(rng, size * draw_log_uniform(rng, 0.2, 2.0)), setting.seconds * draw_log_uniform(rng, 0.2, 1.0))

    def act(self, machine: Machine) -> Act | None:
        """Turns gravity in the base frame by `tilt (1 - exp(-t / tau))`."""
        model, R = machine.model, machine.setting.cell.robot.base.rotation
        g0 = R.T @ model.opt.gravity
        x, y = self.tilt_rad

        def lean(t: float) -> None:
            share = -math.expm1(-t / self.time_constant_s)
            model.opt.gravity[:] = R @ lean_gravity(g0, share * x, share * y)

        return lean


@dataclass(frozen=True)
class SlippingEncoders(Unknown):
    """Encoders lose counts when they turn fast: of the way a share of `loss` times the speed."""

    variant = "slipping_encoders"

    loss_per_rad_per_s: tuple[float, ...]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 6 % of the way per rad/s, in one to three joints."""
        loss = size * some_joints(rng, setting.n, 3) * np.abs(draw_signed_log_uniform(rng, 0.01, 0.06, setting.n))
        return cls(tuple(loss.tolist()))

    def gear(self, machine: Machine) -> Joints | None:
        """Shows q less the counts lost so far, which grow by `loss dq |dq|` per second."""
        loss = np.array(self.loss_per_rad_per_s)
        lost = np.zeros(len(loss))

        def slip(_: float, q: Array, dq: Array) -> tuple[Array, Array]:
            nonlocal lost
            rate = loss * dq * np.abs(dq)
            lost = lost + machine.period * rate
            return q - lost, dq - rate

        return slip


@dataclass(frozen=True)
class BentLink(Unknown):
    """A link has been bent in a crash: the axis of the next joint is turned, across itself, by 0.2 to 2 deg."""

    variant = "bent_link"

    joint: int
    bend_rad: Three

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.2 to 2 deg across the axis of one joint, the third or a later one."""
        k = int(rng.integers(2, setting.n))
        axis = arm_of_cell(setting.cell).joints[k].axis
        across = np.cross(axis, direction(rng))
        return cls(k, three(math.radians(size * draw_log_uniform(rng, 0.2, 2.0)) * across / np.linalg.norm(across)))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Turns the joint's body by `bend_rad` about its own axes."""
        body = arm_joints(spec)[self.joint].parent
        body.quat = turn_frame(body.quat, np.array(self.bend_rad))


@dataclass(frozen=True)
class SpinningRotor(Unknown):
    """A spindle in the tool turns at full speed: its angular momentum resists every turn of the wrist by a torque across both, `w x h`."""

    variant = "spinning_rotor"

    momentum_kg_m2_per_s: Three
    """Sensor frame."""

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.03 to 0.3 kg m2/s in any direction."""
        return cls(three(size * draw_log_uniform(rng, 0.03, 0.3) * direction(rng)))

    def act(self, machine: Machine) -> Act | None:
        """Applies the torque `-w x h` to the payload, w its angular velocity in the world."""
        data, body = machine.data, machine.body("payload")
        h = np.array(self.momentum_kg_m2_per_s)

        def resist(_: float) -> None:
            carried = data.xmat[body].reshape(3, 3) @ h
            data.xfrc_applied[body, 3:] -= cross_vectors(data.cvel[body, :3], carried)

        return resist


@dataclass(frozen=True)
class NeighbouringPress(Unknown):
    """A press in the next cell strikes every few seconds, and the floor rings on for a while: horizontal shocks of 0.1 to 1 m/s2, 5 to
    12 Hz, felt as a gravity that swings."""

    variant = "neighbouring_press"

    acceleration_m_per_s2: Three
    every_s: float
    first_s: float
    ring_hz: float
    decay_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Horizontal shocks of 0.1 to 1 m/s2 every 1 to 4 s, 5 to 12 Hz, decaying within 0.1 to 0.5 s."""
        heading = rng.uniform(0, 2 * np.pi)
        shock = size * draw_log_uniform(rng, 0.1, 1.0) * np.array([np.cos(heading), np.sin(heading), 0.0])
        every = draw_log_uniform(rng, 1.0, 4.0)
        return cls(three(shock), every, float(rng.uniform(0.0, every)), draw_log_uniform(rng, 5.0, 12.0), draw_log_uniform(rng, 0.1, 0.5))

    def act(self, machine: Machine) -> Act | None:
        """Takes `shock exp(-t / decay) sin(w t)` off gravity, t the time since the last stroke."""
        model, shock, omega = machine.model, np.array(self.acceleration_m_per_s2), 2 * math.pi * self.ring_hz
        still = model.opt.gravity.copy()

        def ring(t: float) -> None:
            if t >= self.first_s:
                since = (t - self.first_s) % self.every_s
                model.opt.gravity[:] = still - math.exp(-since / self.decay_s) * math.sin(omega * since) * shock

        return ring


@dataclass(frozen=True)
class Fan(Unknown):
    """A ventilator blows at a payload that is a panel: a force along its normal with the square of the wind across it, seen from the panel
    that moves; much in some poses, none in others."""

    variant = "fan"

    drag_n_s2_per_m2: float
    wind_m_per_s: Three
    """World frame."""
    normal: Three
    """Unit vector, sensor frame, at the nominal centre of mass."""

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Drag of 0.05 to 0.5 N s2/m2, wind of 2 to 4 m/s, wind and panel in any direction."""
        return cls(size * draw_log_uniform(rng, 0.05, 0.5), three(float(rng.uniform(2.0, 4.0)) * direction(rng)), three(direction(rng)))

    def act(self, machine: Machine) -> Act | None:
        """Pushes at the nominal centre of mass by `drag v |v|` along the normal, v the wind along it as the moving panel sees it."""
        data, body = machine.data, machine.body("payload")
        grip, wind, normal = Grip(machine, machine.setting.payload.com), np.array(self.wind_m_per_s), np.array(self.normal)

        def blow(_: float) -> None:
            place = grip.place()
            facing = data.xmat[body].reshape(3, 3) @ normal
            across = float(facing @ (wind - grip.velocity(place)))
            grip.push(place, self.drag_n_s2_per_m2 * across * abs(across) * facing)

        return blow


@dataclass(frozen=True)
class CoupledWrist(Unknown):
    """Shafts one inside the other drive the wrist, and the controller takes the joint before along with the wrong ratio: a joint stands
    farther than its encoder says by a share of the angle of the joint before it."""

    variant = "coupled_wrist"

    joint: int
    share: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.5 to 4 % of the angle of the joint before, with either sign, in one of the last three joints."""
        return cls(int(rng.integers(setting.n - 3, setting.n)), size * sign(rng) * draw_log_uniform(rng, 0.005, 0.04))

    def gear(self, machine: Machine) -> Joints | None:
        """Shows q of the joint less `share` times q of the one before, and their rates alike."""
        mixed = np.eye(machine.setting.n)
        mixed[self.joint, self.joint - 1] = -self.share
        return lambda _, q, dq: (mixed @ q, mixed @ dq)


@dataclass(frozen=True)
class SteelColumn(Unknown):
    """A magnetic gripper near a steel column is drawn to it, with the fourth power of how near it is, as a magnet is by its image behind
    the steel's face; never more than 16 times as much as at home."""

    variant = "steel_column"

    pull_n: float
    """At home."""
    towards: Three
    """Unit vector, world frame, horizontal."""
    distance_m: float
    """At home."""
    at_m: Three

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.1 to 1 N at home, 15 to 40 cm away in any horizontal direction, the magnet 3 to 10 cm from the sensor."""
        heading = rng.uniform(0, 2 * np.pi)
        towards = three(np.array([np.cos(heading), np.sin(heading), 0.0]))
        return cls(size * draw_log_uniform(rng, 0.1, 1.0), towards, draw_log_uniform(rng, 0.15, 0.4), grip_of(rng))

    def act(self, machine: Machine) -> Act | None:
        """Pulls at the magnet by `pull (distance at home / distance)^4`, level with it."""
        grip, towards = Grip(machine, np.array(self.at_m)), np.array(self.towards)
        face = float(towards @ grip.place()) + self.distance_m

        def draw_near(_: float) -> None:
            place = grip.place()
            away = max(face - float(towards @ place), 0.5 * self.distance_m)
            grip.push(place, self.pull_n * (self.distance_m / away) ** 4 * towards)

        return draw_near


UNKNOWN_MECHANISM: tuple[type[Fault], ...] = (
    WarpingBase,
    SlippingEncoders,
    BentLink,
    SpinningRotor,
    NeighbouringPress,
    Fan,
    CoupledWrist,
    SteelColumn,
)
