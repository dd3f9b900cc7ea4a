"""ABB: `loaddata` of RAPID."""

from __future__ import annotations

from core.export.principal_axes import principal_axes, to_quaternion
from core.export.target import MM, ExportTarget, digits
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message


class Abb(ExportTarget):
    """A declaration in RAPID."""

    name = "abb"
    title = "ABB (RAPID loaddata)"
    file = "loaddata.mod"
    says = Message.of("export-abb")
    remark = "! {}"

    def text(self, payload: UncertainParameters) -> str:
        """A RAPID `loaddata`: mass (kg), centre of mass (mm), quaternion of the principal axes and their moments (kg m2), flange frame."""
        axes = principal_axes(payload.inertia_com)
        com, turn, moments = digits(payload.com_m, ",", MM), digits(to_quaternion(axes.rotation), ","), digits(axes.moments, ",")
        return f"PERS loaddata heft_load:=[{payload.phi[0]:.9g},[{com}],[{turn}],{moments}];\n"
