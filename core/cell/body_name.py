"""What a message calls the bodies of a cell: obstacles, zones, the floor, the payload, and the robot's links."""

from __future__ import annotations

from core.cell.cell import Cell
from core.words.message import Message

NAMELESS = {"payload": Message.of("body-payload"), "floor": Message.of("body-floor")}
"""Bodies that have no name of their own: as collision models call them."""


def name_body(cell: Cell, name: str) -> Message:
    """A body as a message names it: what it is, and its name."""
    if any(zone.name == name for zone in cell.zones):
        return Message.of("body-zone", name=name)
    if any(obstacle.name == name for obstacle in cell.obstacles):
        return Message.of("body-obstacle", name=name)
    return NAMELESS.get(name) or Message.of("body-link", name=name)
