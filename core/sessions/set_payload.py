"""The payload that a controller is set to."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.errors import NotConnected, PayloadNotTaken
from core.words.message import Message

SET_NAMES = ("m", "x", "y", "z", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz")
SET_UNITS = ("kg", *["m"] * 3, *["kg m2"] * 6)
RESOLUTION = (1e-4, *[1e-5] * 3, *[1e-6] * 6)
"""How far what is read back may be from what was set, in `SET_UNITS`. No public document states how a controller rounds: these are
above what single precision and nine digits lose and below what any identification tells."""


STANDING_S, STANDING_RAD = 0.25, 0.0005
"""A robot stands when no joint goes farther than this within that time, and none is to."""
TAKEN_S = 3.0
"""How long a controller may take to report what was set."""


class SetPayload(NamedTuple):
    """What a controller is set to, in the frame of the flange, in the order of `SET_NAMES`.

    Args:
        com_m: (3,), centre of mass.
        inertia_kg_m2: (6,), Ixx Iyy Izz Ixy Ixz Iyz about the centre of mass along the flange's axes; empty where it takes none.
    """

    mass_kg: float
    com_m: tuple[float, ...]
    inertia_kg_m2: tuple[float, ...] = ()

    @property
    def numbers(self) -> tuple[float, ...]:
        """All that the controller takes: ten, or four."""
        return (self.mass_kg, *self.com_m, *self.inertia_kg_m2)

    def differing(self, other: SetPayload) -> list[int]:
        """Which of the numbers are farther apart than `RESOLUTION`; one that is no number always is."""
        pairs = enumerate(zip(self.numbers, other.numbers, strict=True))
        return [k for k, (ours, theirs) in pairs if not abs(ours - theirs) <= RESOLUTION[k]]

    def describe_differences(self, other: SetPayload) -> list[Message]:
        """What was sent beside what was read where they differ."""
        return [
            Message.of("session-payload-difference", name=SET_NAMES[k], sent=self.numbers[k], read=other.numbers[k], unit=SET_UNITS[k])
            for k in self.differing(other)
        ]


def check_standing(q: Array, wanted_rad_s: Array, slow_rad_s: float, host: str) -> None:
    """Nothing where a robot stood during `STANDING_S`.

    Args:
        q: (N, n), joint positions, rad. wanted_rad_s: (N, n), speeds that it is to have; below `slow_rad_s` they are none.

    Raises:
        NotConnected: it moves.
    """
    if float(np.ptp(q, axis=0).max()) > STANDING_RAD or float(np.abs(wanted_rad_s).max()) > slow_rad_s:
        raise NotConnected("session-payload-moves", host=host)


def await_taken(read: Callable[[], SetPayload], wanted: SetPayload, host: str) -> SetPayload:
    """Waits until the controller reports it.

    Args:
        read: what the controller reports next; raises OSError where it reports no more.

    Raises:
        PayloadNotTaken: it reports something else.
    """
    until = time.monotonic() + TAKEN_S
    while True:
        found = read()
        if not wanted.differing(found):
            return found
        if time.monotonic() > until:
            raise PayloadNotTaken("session-payload-differs", host=host, differences=wanted.describe_differences(found))


def write_urscript(payload: SetPayload) -> str:
    """The call of URScript that sets it on a controller of Universal Robots, with nine digits."""
    com, inertia = (", ".join(f"{value:.9g}" for value in values) for values in (payload.com_m, payload.inertia_kg_m2))
    return f"set_target_payload({payload.mass_kg:.9g}, [{com}], [{inertia}])"
