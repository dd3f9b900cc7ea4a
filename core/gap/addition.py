"""From a diagnosis to the cell's twin: all that an entry needs stands in the diagnosis, nothing is fitted and no recording is read."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import datetime
from typing import NamedTuple

from pydantic import ValidationError

from core.cell.cell import Cell
from core.cell.kinematics import Axes, is_same_robot, joint_axes
from core.cell.urdf import check_urdf
from core.errors import BadTwin
from core.files.schema_flaw import schema_flaw
from core.gap.answer import Diagnosis, Explanation, Origin, Pair, Triangle, Value
from core.twin.twin import Entry, Fitted, Twin
from core.words.message import Message

ASKED = Message.of("gap-effect-asked")


class Objection(NamedTuple):
    """What stands against adding effects to a twin, and what would not."""

    against: Message
    wanted: Message

    def at(self, where: str) -> BadTwin:
        """As an error; `where` is what was diagnosed."""
        return BadTwin(where, "gap-not-addable", against=self.against, wanted=self.wanted)


def add_found(twin: Twin, cell: Cell, diagnosis: Diagnosis, identifier: str, added: datetime) -> Twin:
    """The cell's twin with an effect that a diagnosis found.

    Args:
        twin: of the cell, as it is now; an effect that it has already is replaced.
        identifier: of the effect, or of two joined by a plus sign.
        added: when.

    Raises:
        BadTwin: the diagnosis does not name it or says what stands against it, is of another cell, or was made by an earlier version; or
            the twin has changed since.
    """
    found = _find_named(diagnosis, identifier)
    origin, gap = diagnosis.origin, diagnosis.gap
    if origin is None or gap is None:
        raise BadTwin(ASKED, "gap-earlier-version")
    if objection := object_to_cell(origin, cell):
        raise objection.at(origin.recording)
    if found.why_not is not None:
        raise Objection(found.why_not, Message.of("gap-wanted-addable")).at(origin.recording)
    try:
        entries = list(make_entries(found, gap.before, origin, added))
    except ValidationError as error:
        raise schema_flaw(error.errors()[0]).refusal(BadTwin, origin.recording) from error
    return twin.with_found(entries, origin.twin)


def object_to_cell(origin: Origin, cell: Cell) -> Objection | None:
    """What stands against taking something for a cell's twin from what was diagnosed; nothing is taken from another cell's recording."""
    if origin.cell is not None and origin.cell != cell.name:
        against = Message.of("gap-other-cell", found=origin.cell)
        return Objection(against, Message.of("gap-wanted-cell", cell=cell.name))
    expected = len(cell.robot.home_rad)
    if origin.joints not in (0, expected):
        against = Message.of("gap-other-joints", joints=origin.joints)
        return Objection(against, Message.of("gap-wanted-joints", joints=expected, cell=cell.name))
    if origin.robot is not None and not is_same_robot(origin.robot, find_axes(cell)):
        return Objection(Message.of("gap-of-other-robot"), Message.of("gap-wanted-robot", cell=cell.name))
    return None


def find_axes(cell: Cell) -> Axes:
    """The axes of the joints between a cell's base and its sensor."""
    robot, where = cell.robot, cell.locate("robot.urdf")
    joints = check_urdf(cell.urdf, str(where)).chain(robot.base_frame, robot.sensor_frame)
    return joint_axes(cell.urdf, joints, robot.base_frame, str(where))


def make_entries(found: Explanation | Pair, gap_before: float, origin: Origin, added: datetime) -> Iterator[Entry]:
    """One entry for each effect that was found."""
    for effect, values, covariance in _split_effects(found):
        yield Entry(
            effect=effect,
            parameters={name: Fitted(value=it.value, std=it.std or 0.0, unit=it.unit) for name, it in values.items()},
            covariance=_fill(covariance),
            recording=origin.recording,
            sha256=origin.sha256,
            added=added,
            gap_before=gap_before,
            gap_after=found.gap_after,
        )


def _fill(triangle: Triangle) -> tuple[tuple[float, ...], ...]:
    """The whole matrix."""
    return tuple((*row, *(below[k] for below in triangle[k + 1 :] if k < len(below))) for k, row in enumerate(triangle))


def _split_effects(found: Explanation | Pair) -> Iterator[tuple[str, dict[str, Value], Triangle]]:
    """Each effect with its parameters and their covariance."""
    if isinstance(found, Explanation):
        yield found.id, found.parameters, found.covariance
    else:
        for effect in found.ids:
            yield effect, found.parameters.get(effect, {}), found.covariance.get(effect, [])


def _find_named(diagnosis: Diagnosis, identifier: str) -> Explanation | Pair:
    named: dict[frozenset[str], Explanation | Pair] = {frozenset([each.id]): each for each in diagnosis.effects}
    named |= {frozenset(pair.ids): pair for pair in diagnosis.pairs}
    found = named.get(frozenset(identifier.split("+")))
    if found is None and not named:
        raise BadTwin(ASKED, "gap-names-none", name=identifier)
    if found is None:
        raise BadTwin(ASKED, "gap-not-named", name=identifier, names=["+".join(sorted(ids)) for ids in named])
    return found
