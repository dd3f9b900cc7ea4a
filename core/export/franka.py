"""Franka: the arguments of libfranka's `setLoad`."""

from __future__ import annotations

import json

from core.export.target import Target
from core.payload.inertia import symmetric
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message


class Franka(Target):
    """JSON with the names of the arguments."""

    name = "franka"
    title = "Franka (setLoad)"
    file = "set_load.json"
    says = Message.of("export-franka")

    def text(self, payload: UncertainParameters) -> str:
        """JSON of mass (kg), centre of mass (m) and the inertia about it as nine values by columns (kg m2), flange frame."""
        load = {
            "load_mass": float(payload.phi[0]),
            "F_x_Cload": payload.com_m.tolist(),
            "load_inertia": symmetric(payload.inertia_com).ravel(order="F").tolist(),
        }
        return json.dumps(load, indent=2) + "\n"
