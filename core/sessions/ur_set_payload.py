"""The payload as a Universal Robots controller takes it: `set_target_payload` of URScript."""

from __future__ import annotations

from typing import NamedTuple

SET_NAMES = ("m", "x", "y", "z", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz")
SET_UNITS = ("kg", *["m"] * 3, *["kg m2"] * 6)
RESOLUTION = (1e-4, *[1e-5] * 3, *[1e-6] * 6)
"""How far what is read back may be from what was set, in `SET_UNITS`. No public document states how a controller rounds: these are
above what nine digits lose and below what any identification tells."""


class SetPayload(NamedTuple):
    """What a controller is set to, in the frame of the flange, in the order of `SET_NAMES`.

    Args:
        com_m: (3,), centre of mass.
        inertia_kg_m2: (6,), Ixx Iyy Izz Ixy Ixz Iyz about the centre of mass along the flange's axes.
    """

    mass_kg: float
    com_m: tuple[float, ...]
    inertia_kg_m2: tuple[float, ...]

    @property
    def numbers(self) -> tuple[float, ...]:
        """All ten."""
        return (self.mass_kg, *self.com_m, *self.inertia_kg_m2)

    def call(self) -> str:
        """The call of URScript, with nine digits."""
        com, inertia = (", ".join(f"{value:.9g}" for value in values) for values in (self.com_m, self.inertia_kg_m2))
        return f"set_target_payload({self.mass_kg:.9g}, [{com}], [{inertia}])"

    def differing(self, other: SetPayload) -> list[int]:
        """Which of the ten are farther apart than `RESOLUTION`; one that is no number always is."""
        pairs = zip(self.numbers, other.numbers, RESOLUTION, strict=True)
        return [k for k, (ours, theirs, limit) in enumerate(pairs) if not abs(ours - theirs) <= limit]
