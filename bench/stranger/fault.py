"""What a planted cause is: a name, its sizes, and what it does at each place between the motors and the file."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from bench.stranger.array import Array
from bench.stranger.kinematics import Kinematics
from bench.stranger.rig import Rig

Scaled = Callable[[float], Array]
Changed = Callable[[Array, float], Array]


class Change(NamedTuple):
    """Of the payload: kg, kg m and kg m^2 about the sensor's origin, each one value or one for each step of the grid."""

    mass: float | Array
    first_moment: Array
    inertia: Array


class Reference(NamedTuple):
    """What the file says of the payload: kg, (3,) kg m, (3, 3) kg m^2 about the sensor's origin."""

    mass: float
    first_moment: Array
    inertia: Array


@dataclass(frozen=True)
class Fault:
    """A cause, drawn; every place where it acts is a function that takes its scale last. N steps of the grid, M samples, n joints.

    Attributes:
        family: what a diagnosis should call it.
        variant: what it is.
        size: what its sizes are at a scale.
        turn_joints: (N, n), rad, by which the links are turned against the motors.
        turn_gravity: (N, 3), rotation vectors in rad, base axes.
        turn_sensor: (3,), rotation vector in rad, sensor axes.
        shake_base: (N, 3), m/s^2, base axes.
        change_payload: what is added to the payload.
        add_wrench: (N, 6), N and N m, sensor axes: what acts besides the payload.
        distort: the wrench (N, 6) through the sensor's body, before its offset.
        put_out: the wrench (N, 6) through the sensor's electronics, behind its offset.
        shift_times: the times (M,), s, at which the wrench is taken.
        report_joints: (N, n), rad, of what is recorded as q.
        rub_joints: (M, n), N m, from torques and speeds (M, n), instead of the usual friction.
        change_noise: the noise (M, 6).
        convert: the wrench (M, 6) behind the converter.
        temperature: (N,), degrees Celsius.
        reference: what the file says of the payload instead of the truth.
        wanted: between which the unexplained rms is to lie, in noise standard deviations.
        limits: of the scale.
        fixed: whether it stays at its natural size.
        seen_in_reading: whether what it changes is on the reading's side and not in the wrench.
        facts: what else is to be written beside the truth.
    """

    family: str
    variant: str
    size: Callable[[float], Mapping[str, object]]
    turn_joints: Scaled | None = None
    turn_gravity: Scaled | None = None
    turn_sensor: Scaled | None = None
    shake_base: Scaled | None = None
    change_payload: Callable[[float], Change] | None = None
    add_wrench: Callable[[Kinematics, float], Array] | None = None
    distort: Changed | None = None
    put_out: Changed | None = None
    shift_times: Changed | None = None
    report_joints: Scaled | None = None
    rub_joints: Callable[[Array, Array, float], Array] | None = None
    change_noise: Changed | None = None
    convert: Changed | None = None
    temperature: Array | None = None
    reference: Reference | None = None
    wanted: tuple[float, float] = (2.2, 8.0)
    limits: tuple[float, float] = (0.3, 5.0)
    fixed: bool = False
    seen_in_reading: bool = False
    facts: Mapping[str, object] = field(default_factory=dict)


class Planted(NamedTuple):
    """A cause at a scale."""

    fault: Fault
    scale: float


Maker = Callable[[np.random.Generator, Rig], Fault]
"""Draws a cause for a rig."""
