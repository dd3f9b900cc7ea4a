"""What a planted cause is: its size, and what it does at each place between the motors and the file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bench.second_stranger.array import Array
from bench.second_stranger.kinematics import BaseTurn, Kinematics
from bench.second_stranger.rig import Rig

Scaled = Callable[[float], Array]
Changed = Callable[[Array, float], Array]
ChangedByMotion = Callable[[Array, Kinematics, float], Array]


class Size(NamedTuple):
    """What is told of a cause: what its value is of, and the value's unit."""

    what: str
    value: float
    unit: str


@dataclass(frozen=True)
class Fault:
    """A cause, drawn; every place where it acts is a function that takes its scale last. N steps of the grid, M samples, n joints.

    Attributes:
        size: at a scale.
        turn_joints: what becomes of the links' joints (N, n), rad.
        turn_gravity: what becomes of gravity (N, 3), m/s^2, base axes.
        turn_base: how the base turns.
        turn_sensor: (3,), rotation vector in rad, sensor axes.
        move_sensor: (3,), m, sensor axes.
        change_payload: what becomes of the wrench (N, 6), N and N m, that the payload asks for.
        touch: what becomes of it by what acts on the payload besides; after all that changes the payload.
        distort: what becomes of the wrench (N, 6) in the sensor.
        delay: (M,), s, of the wrench at times (M,), s.
        report_joints: what is recorded of the motors' joints (N, n), rad.
        temperature: (N,), degrees Celsius.
        at_s: when it begins, where another begins with it.
    """

    size: Callable[[float], Size]
    turn_joints: Changed | None = None
    turn_gravity: Changed | None = None
    turn_base: Callable[[float], BaseTurn] | None = None
    turn_sensor: Scaled | None = None
    move_sensor: Scaled | None = None
    change_payload: ChangedByMotion | None = None
    touch: ChangedByMotion | None = None
    distort: Changed | None = None
    delay: Changed | None = None
    report_joints: Changed | None = None
    temperature: Array | None = None
    at_s: float | None = None

    @property
    def moves_sensor(self) -> bool:
        """Whether the sensor moves or feels gravity otherwise than it does without the cause."""
        acts = (self.turn_joints, self.turn_gravity, self.turn_base, self.turn_sensor, self.move_sensor)
        return any(act is not None for act in acts)


class Planted(NamedTuple):
    """A cause at a scale."""

    fault: Fault
    scale: float


Maker = Callable[[np.random.Generator, Rig], Fault]
"""Draws a cause for a rig."""
Consequence = Callable[[np.random.Generator, Rig, float], Fault]
"""Draws a cause that another one brings about, which begins at a time, s."""
