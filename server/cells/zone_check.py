"""What a protected zone would contradict before it is there, and what is asked of one that somebody draws."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from core.cell.body_name import NAMELESS
from core.cell.cell import Cell
from core.cell.folder import contradictions_of
from core.cell.urdf import check_urdf
from core.errors import BadCell, BadInput, BadZone
from core.payload.shapes import Box, Shape, Sphere
from core.words.message import Message
from server.http.errors import Unprocessable
from server.http.flaws import load_flaws
from server.runner.messages import Answered, Failed
from server.runner.work import run_work

SMALLEST_M = 0.02
"""A smaller zone is a slip of the finger."""
LARGEST_M = 20.0
FARTHEST_M = 20.0
"""From the robot's base to the zone's centre: no robot cell is larger, a length in millimetres is."""


def drawing_flaws(cell: Cell, zone: str, shape: Shape, *, is_new: bool, saved: Iterable[str]) -> list[BadInput]:
    """What speaks against a zone that somebody draws: its name where it is a new one, its size, its place, the robot at home in it.

    Args:
        cell: with its zones as they are now; `zone` is among them unless it is new.
        saved: names of the payloads in the cell's tool library.

    Raises:
        Unprocessable: the process that looks at the arm failed.
    """
    own = [*(_name_flaws(cell, zone, saved) if is_new else ()), *_size_flaws(cell, zone, shape)]
    return own or place_flaws(cell.with_zone(zone, shape))


def place_flaws(cell: Cell) -> list[BadInput]:
    """What stands where the robot's base is, or else in the way of its arm at home with the payload box of the cell.

    The arm takes some tenths of a second.

    Raises:
        Unprocessable: the process that looks at the arm failed.
    """
    return list(contradictions_of(cell)) or _flaws_of_bodies(cell)


def _name_flaws(cell: Cell, zone: str, saved: Iterable[str]) -> Iterator[BadZone]:
    """Bodies and payloads are told apart by their names, whatever the case of their letters."""
    owners = {
        **dict.fromkeys(saved, "zone-owner-saved"),
        **dict.fromkeys(cell.payloads, "zone-owner-payload"),
        **dict.fromkeys(check_urdf(cell.urdf, cell.robot.urdf).links, "zone-owner-link"),
        **dict.fromkeys(cell.tools, "zone-owner-tool"),
        **{obstacle.name: "zone-owner-obstacle" for obstacle in cell.obstacles},
        **{each.name: "zone-owner-zone" for each in cell.zones},
        **dict.fromkeys(NAMELESS, "zone-owner-nameless"),
    }
    taken = {name.lower(): name for name in owners}.get(zone.lower())
    if taken is not None:
        yield BadZone(f"zones.{zone}", "zone-name-taken", name=taken, owner=Message.of(owners[taken]))


def _size_flaws(cell: Cell, zone: str, shape: Shape) -> Iterator[BadZone]:
    lengths = lengths_of(shape)
    if min(lengths) < SMALLEST_M:
        yield BadZone(f"zones.{zone}.shape", "zone-too-small", length_m=min(lengths), least_m=SMALLEST_M)
    if max(lengths) > LARGEST_M:
        yield BadZone(f"zones.{zone}.shape", "zone-too-large", length_m=max(lengths), most_m=LARGEST_M)
    distance = float(np.linalg.norm(shape.pose.translation - cell.robot.base.translation))
    if distance > FARTHEST_M:
        yield BadZone(f"zones.{zone}.shape.pose", "zone-too-far", distance_m=distance, most_m=FARTHEST_M)


def lengths_of(shape: Shape) -> tuple[float, ...]:
    """How long a shape is along its own axes, m; round ones by their diameter."""
    match shape:
        case Box():
            return shape.size_m
        case Sphere():
            return (2 * shape.radius_m,)
        case _:
            return 2 * shape.radius_m, shape.length_m


def _flaws_of_bodies(cell: Cell) -> list[BadInput]:
    for word in run_work("server.runner.zone_checking", cell):
        match word:
            case Answered(text=text):
                return load_flaws(BadCell, text)
            case Failed(message=message):
                raise Unprocessable(message.code, **message.parameters)
    raise Unprocessable("zone-not-looked-at", cell=cell.name)
