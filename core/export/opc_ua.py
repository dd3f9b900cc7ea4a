"""OPC UA for Robotics (OPC 40010-1): the components of a `LoadType`."""

from __future__ import annotations

from typing import Any

from core.export.json_target import JsonTarget
from core.export.principal_axes import principal_axes, zyx_degrees
from core.export.target import MM
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message

UNITS = {"kg": "KGM", "mm": "MMT", "deg": "DD", "kg m2": "B32"}
"""UNECE common codes."""


class OpcUa(JsonTarget):
    """JSON with the browse names of the type."""

    name = "opc_ua"
    title = "OPC UA for Robotics (LoadType)"
    file = "load_type.json"
    says = Message.of("export-opc-ua")

    def content(self, payload: UncertainParameters) -> dict[str, Any]:
        """Mass (kg), centre of mass (mm), A B C (deg), principal moments about the mounting point (kg m2), each with its unit."""
        axes = principal_axes(payload.phi[4:])
        return {
            "Mass": {"Value": float(payload.phi[0]), "EngineeringUnits": unit("kg")},
            "CenterOfMass": {
                "CartesianCoordinates": {**label_values("XYZ", (MM * payload.com_m).tolist()), "LengthUnit": unit("mm")},
                "Orientation": {**label_values("ABC", zyx_degrees(axes.rotation).tolist()), "AngleUnit": unit("deg")},
            },
            "Inertia": {**label_values("XYZ", axes.moments.tolist()), "EngineeringUnits": unit("kg m2")},
        }


def label_values(names: str, values: list[float]) -> dict[str, Any]:
    """One letter for each value."""
    return dict(zip(names, values, strict=True))


def unit(name: str) -> dict[str, Any]:
    """As `EUInformation`; the identifier is the common code's bytes as one number (OPC 10000-8)."""
    return {"DisplayName": name, "UnitId": int.from_bytes(UNITS[name].encode(), "big")}
