"""How much the motions of a plan tell about a payload: Fisher information with the sensor's stated noise, and what that is worth a second.

The wrench is linear in the ten parameters and the six offsets of the sensor (Eq. (2) of the paper), so the information of a motion is the
sum of `V^T C^-1 V` over its samples, whatever the payload is. A choice is A-optimal where a target says how exactly each quantity is
wanted, otherwise D-optimal (Atkinson, Donev and Tobias 2007, chapter 10): greedily, the one that gains most for each second.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.payload.inertia import InertialParameters, Motion, regressor
from core.payload.uncertain_parameters import UncertainParameters, propagate
from core.planning.plan import Leg
from core.planning.settings import Timing
from core.requirement.motions import JointMotion
from core.requirement.response import find_felt_motion
from core.requirement.target import FROBENIUS, Target
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile, JointTrajectory

SHORTER_HOLDS_S = (1.0, 0.5)
"""Motionless phases that may do; what is still shorter shows neither the sensor's noise nor how its offset wanders."""
EVERY_S = 0.01
"""Between the samples of a trajectory that are looked at; each stands for all up to the next one."""
UNKNOWN_STD = np.concatenate(([30.0], np.full(3, 3.0), np.full(6, 1.0), np.full(6, 1e3)))
"""What is known before anything has moved, of parameters and offsets: next to nothing."""


@dataclass(frozen=True)
class Worth:
    """What information is worth.

    Args:
        target: that says how exactly each quantity is wanted; None, or one that names the requirement alone, for all of them alike.
        payload: about which quantities are counted.
    """

    target: Target | None
    payload: InertialParameters

    def find_size(self, information: Array) -> float:
        """Logarithm of what is left open by an information matrix (16, 16): of squared half-widths over the target, or of a volume."""
        covariance: Array = np.asarray(np.linalg.inv(information + np.diag(UNKNOWN_STD**-2.0))[:10, :10], dtype=np.float64)
        found = UncertainParameters(self.payload.phi, covariance)
        parts, target = [], self.target
        if target is not None and target.mass_share is not None:
            parts.append(covariance[0, 0] / (target.mass_share * self.payload.mass) ** 2)
        if target is not None and target.centre_of_mass_m is not None:
            parts.append(np.trace(found.com_covariance) / target.centre_of_mass_m**2)
        if target is not None and target.inertia_share is not None:
            J = found.inertia_com_jacobian * FROBENIUS[:, None]
            size = float(np.linalg.norm(found.inertia_com * FROBENIUS))
            parts.append(np.trace(propagate(J, covariance)) / (target.inertia_share * size) ** 2)
        return float(np.log(sum(parts)) if parts else np.linalg.slogdet(covariance)[1])

    def find_time_needed(self, information: Array, seconds: float) -> float:
        """Logarithm of the robot time that motions of so many seconds would take, made again and again, to leave as little open as wanted:
        variances fall with one over the time. Of a volume, of its geometric mean."""
        share = 1.0 if self._names_quantities else 10.0
        return self.find_size(information) / share + float(np.log(seconds))

    @property
    def _names_quantities(self) -> bool:
        target = self.target
        return target is not None and any((target.mass_share, target.centre_of_mass_m, target.inertia_share))


def choose_holds(cell: Cell, robot: RobotModel, legs: Sequence[Leg], timing: Timing, worth: Worth) -> Timing:
    """The stated time of standing still, or a shorter one with which these legs need less robot time for what is wanted."""
    shorter = [replace(timing, hold_s=each, settle_s=min(each, timing.settle_s)) for each in SHORTER_HOLDS_S if each < timing.hold_s]

    def find_time_needed(timing: Timing) -> float:
        return worth.find_time_needed(find_information(cell, robot, legs, timing), find_seconds(legs, timing))

    return min((timing, *shorter), key=find_time_needed)


def find_information(cell: Cell, robot: RobotModel, legs: Sequence[Leg], timing: Timing) -> Array:
    """(16, 16), of the parameters and the sensor's offsets: transfers, holds, and one swing of each rotation.

    What all the arm's joints do in a wave is taken for what its trajectory says.
    """
    total = np.zeros((16, 16))
    for leg in legs:
        for trajectory in leg.trajectories:
            total += _sum(cell, find_felt_motion(robot, cell.gravity, _thin(trajectory)), EVERY_S, trajectory.period)
        g = robot.sensor_pose(leg.start.q).rotation.T @ cell.gravity
        still_s = timing.hold_s + (timing.settle_s if leg.moving_s > 0.0 else 0.0)
        total += _sum(cell, Motion.still(g[None]), still_s, leg.transfer.trajectory.period)
        if leg.profile is not None:
            swing = leg.profile.cut(int(leg.profile.rests[0]))
            total += _sum(cell, _turn(swing, "xyz".index(leg.about), g), swing.period, swing.period)
    return total


def find_seconds(legs: Sequence[Leg], timing: Timing) -> float:
    """Robot time of the same, s."""
    seconds = 0.0
    for leg in legs:
        seconds += leg.transfer.trajectory.duration + timing.hold_s
        if leg.profile is not None:
            seconds += leg.profile.period * float(leg.profile.rests[0]) + timing.settle_s
        if leg.wave is not None:
            seconds += leg.wave.duration + timing.settle_s
    return seconds


def _thin(trajectory: JointTrajectory) -> JointMotion:
    """Its samples every `EVERY_S`, with derivatives by central differences."""
    every = max(1, round(EVERY_S / trajectory.period))
    q = trajectory.q[::every] if len(trajectory.q) > 2 * every else trajectory.q[[0, 0, 0]]
    period = every * trajectory.period
    dq = np.gradient(q, period, axis=0)
    return JointMotion(period, q, dq, np.gradient(dq, period, axis=0))


def _turn(profile: AngularProfile, axis: int, g: Array) -> Motion:
    """A rotation about a sensor axis through the sensor's origin, which stays; gravity (3,) at its start, sensor frame."""
    unit = np.eye(3)[axis]
    across = g - (g @ unit) * unit
    c, s = np.cos(profile.angle)[:, None], np.sin(profile.angle)[:, None]
    turned = (g @ unit) * unit + c * across - s * np.cross(unit, across)
    zero = np.zeros_like(turned)
    return Motion(turned, zero, profile.rate[:, None] * unit, np.gradient(profile.rate, profile.period)[:, None] * unit)


def _sum(cell: Cell, motion: Motion, lasts_s: float, period_s: float) -> Array:
    """(16, 16), of samples every `period_s`, where each row of a motion stands for `lasts_s`."""
    V = regressor(motion)
    rows = np.concatenate((V, np.broadcast_to(np.eye(6), (len(V), 6, 6))), axis=2) / np.array(cell.sensor.noise_std)[:, None]
    return np.asarray(np.einsum("kci,kcj->ij", rows, rows) * lasts_s / period_s)
