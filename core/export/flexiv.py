"""Flexiv: the inertial part of a tool's parameters."""

from __future__ import annotations

from typing import Any

from core.export.json_target import JsonTarget
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message

ORDER = [0, 3, 5, 1, 2, 4]
"""Ixx Iyy Izz Ixy Ixz Iyz."""


class Flexiv(JsonTarget):
    """JSON with the names of the RDK's `ToolParams`."""

    name = "flexiv"
    title = "Flexiv (ToolParams)"
    file = "tool_params.json"
    says = Message.of("export-flexiv")

    def content(self, payload: UncertainParameters) -> dict[str, Any]:
        """Mass (kg), centre of mass (m) and the six entries of the inertia about it (kg m2, in `ORDER`), flange frame."""
        return {"mass": float(payload.phi[0]), "CoM": payload.com_m.tolist(), "inertia": payload.inertia_com[ORDER].tolist()}
