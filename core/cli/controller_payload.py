"""`heft export --write`: an accepted payload straight into the controller of the cell's robot."""

from __future__ import annotations

import getpass
import sys
from pathlib import Path

import numpy as np
import typer
from rich.table import Table

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.cell.session import UniversalRobot
from core.cli.tables import INTERVAL, number
from core.cli.terminal import answers, find_wording, messages
from core.errors import BadInput, BadPayload, Refused
from core.estimation.result import Result
from core.export.exports import payload_of, require_mount
from core.export.universal_robots import ORDER, UniversalRobots, set_payload_of
from core.payload.uncertain_parameters import UncertainParameters
from core.sessions.ur_payload import read_payload, write_payload
from core.sessions.ur_set_payload import SET_NAMES, SET_UNITS, SetPayload
from core.words.message import Message, Parameter


def write_to_controller(file: Path, found: Result, *, target: str | None, cell_name: str, accepted_by: str | None) -> None:
    """Shows what the controller has beside what it will have, asks, writes, reads back.

    Args:
        accepted_by: who has accepted; where None somebody is asked at the terminal.

    Raises:
        BadInput, BadPayload: this answer cannot be written to that cell's robot, or nobody is there to accept.
        NotConnected, WrongRobot: see `core.sessions.ur_payload.write_payload`.
        Refused: whoever was asked did not say yes.
        PayloadNotTaken: what is read back is something else.
    """
    cell = _find_cell(file, found, target, cell_name)
    payload = payload_of(found, require_mount(cell))
    wanted = set_payload_of(payload)
    _check_carried(cell, wanted)
    if accepted_by is not None and not accepted_by.strip():
        raise BadInput("--accepted-by", "cli-export-nobody")
    if accepted_by is None and not _can_ask():
        raise BadInput("--accepted-by", "cli-export-nobody-asked")
    before = read_payload(cell)
    answers.print(_compare(payload, wanted, before))
    _say_conditions(cell, found, payload)
    assert isinstance(cell.session, UniversalRobot)
    host = cell.session.host
    who = accepted_by or _ask(host)
    write_payload(cell, wanted, before=before)
    answers.print(_say("cli-export-written", host=host, who=who.strip()), highlight=False, markup=False, soft_wrap=True)


def _find_cell(file: Path, found: Result, target: str | None, name: str) -> Cell:
    if target != UniversalRobots.name:
        raise BadInput("--write", "cli-export-not-writable", target=target or "-", known=UniversalRobots.name)
    cell = load_cell(find_cell(name))
    if not isinstance(cell.session, UniversalRobot):
        raise BadInput(cell.locate("session.driver"), "cli-export-no-robot", driver=cell.session.driver)
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
    """The ten numbers: what the controller has, what it will have, with the half-width of its 95 % interval."""
    halves = INTERVAL * np.array([payload.std[0], *payload.com_std, *payload.inertia_com_std[ORDER]])
    table = Table(caption=_say("cli-export-table"))
    table.add_column("", no_wrap=True)
    for heading in ("cli-export-now", "cli-export-then"):
        table.add_column(_say(heading), justify="right", no_wrap=True)
    table.add_column("±", justify="right", no_wrap=True)
    table.add_column(_say("result-unit"), no_wrap=True)
    for name, now, then, half, unit in zip(SET_NAMES, before.numbers, wanted.numbers, halves, SET_UNITS, strict=True):
        table.add_row(name, number(now), number(then), number(float(half), 2) if np.isfinite(half) else "", unit)
    return table


def _say_conditions(cell: Cell, found: Result, payload: UncertainParameters) -> None:
    """What has to be known before somebody accepts."""
    said: list[Message] = [found.verdict, *found.warnings]
    if not np.isfinite(payload.inertia_com).all():
        said.append(Message.of("cli-export-no-inertia"))
    assert isinstance(cell.session, UniversalRobot)
    if cell.session.sensor is not None:
        said.append(Message.of("cli-export-sensor-itself"))
    said.append(Message.of("cli-export-zeroes"))
    for each in said:
        messages.print(find_wording().quote(each), highlight=False, markup=False, soft_wrap=True)


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
