"""Flexiv: the inertial part of a tool's parameters."""

from __future__ import annotations

import json

from core.export.target import Target
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message

ORDER = [0, 3, 5, 1, 2, 4]
"""Ixx Iyy Izz Ixy Ixz Iyz."""


class Flexiv(Target):
    """JSON with the names of the RDK's `ToolParams`."""

    name = "flexiv"
    title = "Flexiv (ToolParams)"
    file = "tool_params.json"
    says = Message.of("export-flexiv")

    def text(self, payload: UncertainParameters) -> str:
        """JSON of mass (kg), centre of mass (m) and the six entries of the inertia about it (kg m2, in `ORDER`), flange frame."""
        tool = {"mass": float(payload.phi[0]), "CoM": payload.com_m.tolist(), "inertia": payload.inertia_com[ORDER].tolist()}
        return json.dumps(tool, indent=2) + "\n"
