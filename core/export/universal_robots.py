"""Universal Robots: `set_target_payload` of URScript."""

from __future__ import annotations

import numpy as np

from core.errors import BadPayload
from core.export.target import INERTIA_NAMES, ExportTarget, write_remarks
from core.export.uncertainty import ExportUncertainty
from core.payload.uncertain_parameters import UncertainParameters
from core.sessions.set_payload import SetPayload, write_urscript
from core.words.message import Message

LARGEST_KG_M2 = 133.0
ORDER = [0, 3, 5, 1, 2, 4]
"""Ixx Iyy Izz Ixy Ixz Iyz."""
MOMENTS = ORDER[:3]


class UniversalRobots(ExportTarget):
    """A line of URScript."""

    name = "ur"
    title = "Universal Robots (URScript)"
    file = "payload.script"
    says = Message.of("export-ur")
    remark = "# {}"

    def text(self, payload: UncertainParameters) -> str:
        """A URScript call with mass (kg), centre of mass (m) and the inertia about it (kg m2, in `ORDER`), flange frame.

        Raises:
            BadPayload: an entry of the inertia is one that the robot does not take.
        """
        call = write_urscript(set_payload_of(payload))
        return f"# zeroes the force/torque sensor again: nothing may touch the tool meanwhile\n{call}\n"

    def add_uncertainty(self, text: str, uncertainty: ExportUncertainty) -> str:
        """Behind the call: what must be known before it stands first."""
        return text + write_remarks(self.remark, uncertainty)


def set_payload_of(payload: UncertainParameters) -> SetPayload:
    """What a controller is to be set to. An inertia that is not determined throughout is zero, as it is where URScript is given none.

    Args:
        payload: in the flange's frame.

    Raises:
        BadPayload: mass or centre of mass is not determined, or an entry of the inertia is one that the robot does not take.
    """
    UniversalRobots.require(payload, slice(0, 4))
    inertia = payload.inertia_com
    if not np.isfinite(inertia).all():
        inertia = np.zeros(6)
    k = int(np.argmax(np.abs(inertia)))
    if abs(inertia[k]) > LARGEST_KG_M2:
        raise BadPayload(INERTIA_NAMES[k], "export-too-large", inertia_kg_m2=float(inertia[k]), most_kg_m2=LARGEST_KG_M2)
    for j in MOMENTS:
        if inertia[j] < 0.0:
            raise BadPayload(INERTIA_NAMES[j], "export-negative-moment", inertia_kg_m2=float(inertia[j]))
    return SetPayload(float(payload.phi[0]), tuple(payload.com_m.tolist()), tuple(inertia[ORDER].tolist()))
