"""URDF: the inertial element of a link."""

from __future__ import annotations

from core.export.target import INERTIA_NAMES, ExportTarget, digits
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message


class Urdf(ExportTarget):
    """An element of a URDF, for a link whose frame is the flange's."""

    name = "urdf"
    title = "URDF"
    file = "inertial.urdf.xml"
    says = Message.of("export-urdf")
    remark = "<!-- {} -->"

    def text(self, payload: UncertainParameters) -> str:
        """An `inertial` element of URDF: centre of mass (m), mass (kg), inertia about the centre of mass (kg m2), link frame."""
        inertia = " ".join(f'{name.lower()}="{value:.9g}"' for name, value in zip(INERTIA_NAMES, payload.inertia_com, strict=True))
        lines = (
            f'  <origin xyz="{digits(payload.com_m, " ")}" rpy="0 0 0"/>',
            f'  <mass value="{payload.phi[0]:.9g}"/>',
            f"  <inertia {inertia}/>",
        )
        return "\n".join(("<inertial>", *lines, "</inertial>")) + "\n"
