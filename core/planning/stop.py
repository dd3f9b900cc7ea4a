"""One stop of a run, as small data: an attitude, and what is done there."""

from __future__ import annotations

from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from core.array import Array
from core.payload.shapes import Model

Axis = Literal["x", "y", "z"]
AXES: tuple[Axis, Axis, Axis] = ("x", "y", "z")
Rad = Annotated[float, Field(ge=-100.0, le=100.0)]
Component = Annotated[float, Field(ge=-1.0, le=1.0)]
Direction = tuple[Component, Component, Component]


class Swings(Model):
    """Rotation about a sensor axis through the sensor origin, out and back, trapezoids of angular velocity.

    Args:
        repetitions: None for as often as the wanted accuracy needs, within the robot time of the plan.
    """

    about: Axis = Field(description="Sensor axis that is turned about.")
    excursion_rad: Annotated[float, Field(gt=0.0, le=3.0)] = Field(default=0.25, description="How far, rad.", examples=[0.25])
    repetitions: Annotated[int, Field(ge=1, le=100)] | None = Field(
        default=10, description="How often out and back; null for as often as the wanted accuracy needs.", examples=[10]
    )


class Wave(Model):
    """All joints at once, sines between two frequencies whose speeds are alike; how large, planning decides.

    Args:
        wrist: None for what tells most of the payload through the joints' torques; planning then also chooses where in the band.
    """

    seconds: Annotated[float, Field(ge=2.0, le=120.0)] = Field(default=10.0, description="How long, s.", examples=[10.0])
    lowest_hz: Annotated[float, Field(gt=0.0, le=50.0)] = Field(default=0.3, description="Lowest frequency, Hz.", examples=[0.3])
    highest_hz: Annotated[float, Field(gt=0.0, le=50.0)] = Field(default=6.0, description="Highest frequency, Hz.", examples=[6.0])
    seed: Annotated[int, Field(ge=0)] = Field(default=0, description="Of the sines' phases.", examples=[0])
    wrist: Annotated[float, Field(ge=1.0, le=100.0)] | None = Field(
        default=1.0,
        description="How many times faster the last joint turns than the first, those between evenly; null for what tells most of the "
        "payload through the joints' torques.",
        examples=[1.0],
    )


class Stop(Model):
    """One attitude: the way there, a hold, and what is done from it before the next hold."""

    down: Direction = Field(description="Direction of gravity in the sensor frame, unit length.", examples=[[1.0, 0.0, 0.0]])
    swings: Swings | None = Field(
        default=None, description="Rotation from there; at most one of `swings` and `wave`, only the hold where both are null."
    )
    wave: Wave | None = Field(default=None, description="Motion of all joints from there.")
    away_from_rad: Annotated[tuple[Rad, ...], Field(max_length=32)] | None = Field(
        default=None,
        description="Joint positions, rad, of another posture of the arm with the same attitude, to keep far from.",
        examples=[[0.1, 0.9, 0.0, -1.4, 0.2, 1.1, 0.0]],
    )

    @property
    def label(self) -> str:
        """As in the phases of a recording: `x+` where that axis points down, `free` where none points up or down."""
        axis = int(np.argmax(np.abs(self.down)))
        if abs(self.down[axis]) < 1.0 - 1e-6:
            return "free"
        return f"{'xyz'[axis]}{'+' if self.down[axis] > 0 else '-'}"

    @property
    def repeats_as_needed(self) -> bool:
        """Whether how often it rotates is for the plan to settle."""
        return self.swings is not None and self.swings.repetitions is None


def wave_shape(wave: Wave, joints: int, period: float) -> Array:
    """(N, joints), joint positions of a wave, rad for a speed of 1 rad/s of the last joint at most, at rest at zero at both ends.

    Each joint has frequencies of its own, evenly spaced in their logarithm, so that no two joints move together.
    """
    rng = np.random.default_rng(wave.seed)
    t = period * np.arange(round(wave.seconds / period) + 1)
    lines = np.geomspace(wave.lowest_hz, wave.highest_hz, 4 * joints).reshape(4, joints)
    phases = rng.uniform(0.0, 2.0 * np.pi, lines.shape)
    edge = np.clip(np.minimum(t, t[-1] - t) / 1.0, 0.0, 1.0)
    rise = edge**3 * (10.0 - 15.0 * edge + 6.0 * edge**2)
    angle = 2.0 * np.pi * lines * t[:, None, None] + phases
    q = rise[:, None] * (np.sin(angle) / (2.0 * np.pi * lines)).sum(axis=1)
    speeds = np.geomspace(1.0 / (wave.wrist or 1.0), 1.0, joints)
    return np.asarray(speeds * q / np.abs(np.gradient(q, period, axis=0)).max(axis=0))
