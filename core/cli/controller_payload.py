"""`heft export --write`: an accepted payload straight into the controller of the cell's robot."""

from __future__ import annotations

import getpass
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple, Protocol

import numpy as np
import typer
from rich.table import Table

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.cell.session import FrankaRobot, RealRobot, UniversalRobot, XarmRobot
from core.cli.exports import lack_sentences
from core.cli.tables import INTERVAL, number
from core.cli.terminal import answers, find_wording, messages
from core.errors import BadInput, BadPayload, Refused
from core.estimation.result import Result
from core.export.exports import payload_of, require_mount
from core.export.franka import Franka
from core.export.franka import set_payload_of as for_franka
from core.export.target import ExportTarget
from core.export.universal_robots import ORDER, UniversalRobots
from core.export.universal_robots import set_payload_of as for_universal_robots
from core.export.xarm import XArm
from core.export.xarm import set_payload_of as for_xarm
from core.payload.uncertain_parameters import UncertainParameters
from core.sessions import franka_payload, ur_payload, xarm_payload
from core.sessions.set_payload import SET_NAMES, SET_UNITS, SetPayload
from core.words.message import Message, Parameter


class Writer(Protocol):
    """Writes it and gives what is read back; see `core.sessions.ur_payload.write_payload`."""

    def __call__(self, cell: Cell, wanted: SetPayload, *, before: SetPayload) -> SetPayload: ...


class Way(NamedTuple):
    """How one maker's controllers are written to.

    Args:
        link: what a cell with such a robot says of its line.
        convert: what a controller is to be set to.
        says: what writing does beside.
    """

    target: ExportTarget
    link: type[RealRobot]
    driver: str
    convert: Callable[[UncertainParameters], SetPayload]
    read: Callable[[Cell], SetPayload]
    write: Writer
    says: str


WAYS = {
    way.target.name: way
    for way in (
        Way(
            UniversalRobots(),
            UniversalRobot,
            "ur_rtde",
            for_universal_robots,
            ur_payload.read_payload,
            ur_payload.write_payload,
            "cli-export-zeroes",
        ),
        Way(XArm(), XarmRobot, "xarm", for_xarm, xarm_payload.read_payload, xarm_payload.write_payload, "cli-export-until-off"),
        Way(
            Franka(),
            FrankaRobot,
            "franka_fci",
            for_franka,
            franka_payload.read_payload,
            franka_payload.write_payload,
            "cli-export-load-beside",
        ),
    )
}


def write_to_controller(file: Path, found: Result, *, target: str | None, cell_name: str, accepted_by: str | None) -> None:
    """Shows what the controller has beside what it will have, asks, writes, reads back.

    Args:
        accepted_by: who has accepted; where None somebody is asked at the terminal.

    Raises:
        BadInput, BadPayload: this answer cannot be written to that cell's robot, or nobody is there to accept.
        NotConnected, WrongRobot: see `write_payload` of the driver.
        Refused: whoever was asked did not say yes.
        PayloadNotTaken: what is read back is something else.
    """
    way = _find_way(target)
    cell = _find_cell(file, found, way, cell_name)
    payload = payload_of(found, require_mount(cell))
    wanted = way.convert(payload)
    _check_carried(cell, wanted)
    if accepted_by is not None and not accepted_by.strip():
        raise BadInput("--accepted-by", "cli-export-nobody")
    if accepted_by is None and not _can_ask():
        raise BadInput("--accepted-by", "cli-export-nobody-asked")
    before = way.read(cell)
    answers.print(_compare(payload, wanted, before))
    _say_conditions(way, cell, found, payload)
    assert isinstance(cell.session, RealRobot)
    host = cell.session.host
    who = accepted_by or _ask(host)
    way.write(cell, wanted, before=before)
    answers.print(_say("cli-export-written", host=host, who=who.strip()), highlight=False, markup=False, soft_wrap=True)


def _find_way(target: str | None) -> Way:
    if target not in WAYS:
        raise BadInput("--write", "cli-export-not-writable", target=target or "-", known=", ".join(WAYS))
    return WAYS[target]


def _find_cell(file: Path, found: Result, way: Way, name: str) -> Cell:
    cell = load_cell(find_cell(name))
    if not isinstance(cell.session, way.link):
        raise BadInput(cell.locate("session.driver"), "cli-export-no-robot", driver=cell.session.driver, expected=way.driver)
    if found.cell != cell.name:
        raise BadInput(str(file), "cli-export-another-cell", found=found.cell or "-", cell=cell.name)
    return cell


def _check_carried(cell: Cell, wanted: SetPayload) -> None:
    """Raises BadPayload where it is no mass, or more than the cell's arm carries."""
    limit = cell.robot.payload_limit_kg
    if wanted.mass_kg <= 0.0:
        raise BadPayload("m", "cli-export-no-mass", found_kg=wanted.mass_kg)
    if limit is not None and wanted.mass_kg > limit:
        raise BadPayload("m", "cli-export-too-heavy", found_kg=wanted.mass_kg, limit_kg=limit)


def _compare(payload: UncertainParameters, wanted: SetPayload, before: SetPayload) -> Table:
    """The numbers: what the controller has, what it will have, with the half-width of its 95 % interval."""
    halves = INTERVAL * np.array([payload.std[0], *payload.com_std, *payload.inertia_com_std[ORDER]])
    table = Table(caption=_say("cli-export-table"))
    table.add_column("", no_wrap=True)
    for heading in ("cli-export-now", "cli-export-then"):
        table.add_column(_say(heading), justify="right", no_wrap=True)
    table.add_column("±", justify="right", no_wrap=True)
    table.add_column(_say("result-unit"), no_wrap=True)
    count = len(wanted.numbers)
    rows = zip(SET_NAMES[:count], before.numbers, wanted.numbers, halves[:count], SET_UNITS[:count], strict=True)
    for name, now, then, half, unit in rows:
        table.add_row(name, number(now), number(then), number(float(half), 2) if np.isfinite(half) else "", unit)
    return table


def _say_conditions(way: Way, cell: Cell, found: Result, payload: UncertainParameters) -> None:
    """What has to be known before somebody accepts."""
    said: list[Message] = [found.verdict, *found.warnings]
    if way.target.needs.stop > 4 and not np.isfinite(payload.inertia_com).all():
        said.append(Message.of("cli-export-no-inertia"))
    assert isinstance(cell.session, RealRobot)
    if cell.session.sensor is not None:
        said.append(Message.of("cli-export-sensor-itself"))
    said.append(Message.of(way.says))
    for sentence in [*lack_sentences(way.target, payload), *map(find_wording().quote, said)]:
        messages.print(sentence, highlight=False, markup=False, soft_wrap=True)


def _can_ask() -> bool:
    return sys.stdin.isatty() and messages.is_terminal


def _ask(host: str) -> str:
    """Who said yes.

    Raises:
        Refused: nobody did.
    """
    yes = _say("cli-export-yes")
    given = str(typer.prompt(_say("cli-export-question", host=host, yes=yes), default="", show_default=False, err=True))
    if given.strip().casefold() != yes.casefold():
        raise Refused("cli-export-declined")
    return getpass.getuser()


def _say(code: str, **parameters: Parameter) -> str:
    return find_wording().say(code, **parameters)
