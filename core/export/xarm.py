"""UFACTORY xArm: `set_tcp_load`."""

from __future__ import annotations

from collections.abc import Iterator

from core.export.target import INERTIA_NAMES, MM, ExportTarget, Lack, digits, inertia_lacks
from core.payload.uncertain_parameters import UncertainParameters
from core.sessions.set_payload import SetPayload
from core.words.message import Message


class XArm(ExportTarget):
    """A line of Python for the xArm SDK; it knows no inertia."""

    name = "xarm"
    title = "UFACTORY xArm (set_tcp_load)"
    file = "set_tcp_load.py"
    says = Message.of("export-xarm")
    remark = "# {}"
    needs = slice(0, 4)

    def text(self, payload: UncertainParameters) -> str:
        """A call of `set_tcp_load` in Python: mass (kg) and centre of mass (mm), flange frame."""
        return f"arm.set_tcp_load({payload.phi[0]:.9g}, [{digits(payload.com_m, factor=MM)}])\n"

    def lacks(self, payload: UncertainParameters) -> Iterator[Lack]:
        """The whole inertia."""
        yield from inertia_lacks(payload, INERTIA_NAMES)


def set_payload_of(payload: UncertainParameters) -> SetPayload:
    """What a controller is to be set to.

    Args:
        payload: in the flange's frame.

    Raises:
        BadPayload: mass or centre of mass is not determined.
    """
    XArm.require(payload, XArm.needs)
    return SetPayload(float(payload.phi[0]), tuple(payload.com_m.tolist()))
