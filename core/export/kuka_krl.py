"""KUKA KRC: load data in KRL."""

from __future__ import annotations

from core.export.principal_axes import principal_axes, zyx_degrees
from core.export.target import MM, ExportTarget
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message


class KukaKrl(ExportTarget):
    """A declaration in KRL, for the first tool."""

    name = "kuka_krl"
    title = "KUKA KRC (KRL load data)"
    file = "load_data.dat"
    says = Message.of("export-kuka-krl")
    remark = "; {}"

    def text(self, payload: UncertainParameters) -> str:
        """A KRL `LOAD_DATA`: mass (kg), centre of mass (mm) with A B C of the principal axes (deg), moments (kg m2), flange frame."""
        axes = principal_axes(payload.inertia_com)
        place = [*zip("XYZ", MM * payload.com_m, strict=True), *zip("ABC", zyx_degrees(axes.rotation), strict=True)]
        com = ",".join(f"{name} {value:.9g}" for name, value in place)
        moments = ",".join(f"{name} {value:.9g}" for name, value in zip("XYZ", axes.moments, strict=True))
        return f"LOAD_DATA[1]={{M {payload.phi[0]:.9g},CM {{{com}}},J {{{moments}}}}}\n"
