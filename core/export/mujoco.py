"""MuJoCo: the inertial element of a body."""

from __future__ import annotations

from core.export.target import ExportTarget, digits
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message

ORDER = [0, 3, 5, 1, 2, 4]
"""11 22 33 12 13 23."""


class MuJoCo(ExportTarget):
    """An element of MJCF, for a body whose frame is the flange's."""

    name = "mujoco"
    title = "MuJoCo (MJCF)"
    file = "inertial.xml"
    says = Message.of("export-mujoco")
    remark = "<!-- {} -->"

    def text(self, payload: UncertainParameters) -> str:
        """An `inertial` element of MJCF: centre of mass (m), mass (kg), inertia about the centre of mass (kg m2, `ORDER`), body frame."""
        inertia = digits(payload.inertia_com[ORDER], " ")
        return f'<inertial pos="{digits(payload.com_m, " ")}" mass="{payload.phi[0]:.9g}" fullinertia="{inertia}"/>\n'
