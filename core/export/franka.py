"""Franka: the arguments of libfranka's `setLoad`."""

from __future__ import annotations

from typing import Any

from core.errors import BadPayload
from core.export.json_target import JsonTarget
from core.export.target import INERTIA_NAMES
from core.payload.inertia import symmetric
from core.payload.uncertain_parameters import UncertainParameters
from core.sessions.set_payload import SetPayload
from core.words.message import Message

ORDER = [0, 3, 5, 1, 2, 4]
"""Ixx Iyy Izz Ixy Ixz Iyz."""


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


def set_payload_of(payload: UncertainParameters) -> SetPayload:
    """What a controller is to be set to.

    Args:
        payload: in the flange's frame.

    Raises:
        BadPayload: one of the ten parameters is not determined, or a moment of inertia is negative.
    """
    Franka.require(payload, Franka.needs)
    inertia = payload.inertia_com
    for j in ORDER[:3]:
        if inertia[j] < 0.0:
            raise BadPayload(INERTIA_NAMES[j], "export-negative-moment", inertia_kg_m2=float(inertia[j]))
    return SetPayload(float(payload.phi[0]), tuple(payload.com_m.tolist()), tuple(inertia[ORDER].tolist()))
