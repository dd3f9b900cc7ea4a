"""KUKA Sunrise: the load data of a tool's template."""

from __future__ import annotations

from collections.abc import Iterator

from core.export.target import MM, ExportTarget, Lack, inertia_lacks
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message


class KukaSunrise(ExportTarget):
    """Values to be typed in, one a line."""

    name = "kuka_sunrise"
    title = "KUKA Sunrise (tool template)"
    file = "tool_template.txt"
    says = Message.of("export-kuka-sunrise")

    def text(self, payload: UncertainParameters) -> str:
        """Seven lines of name, unit and value: mass (kg), centre of mass (mm), Ixx, Iyy and Izz about it (kg m2), flange frame."""
        rows = [("Mass [kg]", payload.phi[0])]
        rows += [(f"MS {name} [mm]", MM * value) for name, value in zip("XYZ", payload.com_m, strict=True)]
        rows += [(f"J{name} [kg m2]", payload.inertia_com[k]) for name, k in zip("XYZ", (0, 3, 5), strict=True)]
        return "".join(f"{name:<12} {value:.9g}\n" for name, value in rows)

    def lacks(self, payload: UncertainParameters) -> Iterator[Lack]:
        """The products of inertia."""
        yield from inertia_lacks(payload, ("Ixy", "Ixz", "Iyz"))
