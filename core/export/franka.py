"""Franka: the arguments of libfranka's `setLoad`."""

from __future__ import annotations

from typing import Any

from core.export.json_target import JsonTarget
from core.payload.inertia import symmetric
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message


class Franka(JsonTarget):
    """JSON with the names of the arguments."""

    name = "franka"
    title = "Franka (setLoad)"
    file = "set_load.json"
    says = Message.of("export-franka")

    def content(self, payload: UncertainParameters) -> dict[str, Any]:
        """Mass (kg), centre of mass (m) and the inertia about it as nine values by columns (kg m2), flange frame."""
        return {
            "load_mass": float(payload.phi[0]),
            "F_x_Cload": payload.com_m.tolist(),
            "load_inertia": symmetric(payload.inertia_com).ravel(order="F").tolist(),
        }
