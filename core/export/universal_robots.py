"""Universal Robots: `set_target_payload` of URScript."""

from __future__ import annotations

import numpy as np

from core.errors import BadPayload
from core.export.target import INERTIA_NAMES, ExportTarget, digits, write_remarks
from core.export.uncertainty import ExportUncertainty
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message

LARGEST_KG_M2 = 133.0
ORDER = [0, 3, 5, 1, 2, 4]
"""Ixx Iyy Izz Ixy Ixz Iyz."""


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
            BadPayload: an entry of the inertia is larger than the robot takes.
        """
        inertia = payload.inertia_com
        k = int(np.argmax(np.abs(inertia)))
        if abs(inertia[k]) > LARGEST_KG_M2:
            raise BadPayload(INERTIA_NAMES[k], "export-too-large", inertia_kg_m2=float(inertia[k]), most_kg_m2=LARGEST_KG_M2)
        call = f"set_target_payload({payload.phi[0]:.9g}, [{digits(payload.com_m)}], [{digits(inertia[ORDER])}])"
        return f"# zeroes the force/torque sensor again: nothing may touch the tool meanwhile\n{call}\n"

    def add_uncertainty(self, text: str, uncertainty: ExportUncertainty) -> str:
        """Behind the call: what must be known before it stands first."""
        return text + write_remarks(self.remark, uncertainty)
