"""`heft export`: a result as robot controllers and simulators take it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from pydantic import ValidationError

from core.cell.folder import find_cell, load_cell
from core.cli.answer_file import read_result_file
from core.cli.terminal import answers, find_wording, messages
from core.errors import BadInput
from core.export.exports import TARGETS, payload_of, require_mount, target_of
from core.export.target import ExportTarget, Lack
from core.export.uncertainty import state_uncertainty, uncertainty_of
from core.files.schema_flaw import schema_flaw
from core.payload.shapes import Pose
from core.payload.uncertain_parameters import UncertainParameters

app = typer.Typer()
Triple = tuple[float, float, float]


@app.command()
def export(
    result: Annotated[Path, typer.Argument(metavar="RESULT", help="The answer of `heft run` or `heft identify`, as --json wrote it.")],
    target: Annotated[str | None, typer.Option(metavar="NAME", help="For whom; the targets are listed where none is named.")] = None,
    cell: Annotated[str | None, typer.Option(metavar="CELL", help="Whose sensor mount counts. [default: the cell of the result]")] = None,
    mount_xyz: Annotated[
        Triple | None, typer.Option(metavar="X Y Z", help="Without a cell: where the sensor's frame is in the flange's, m.")
    ] = None,
    mount_rpy: Annotated[Triple | None, typer.Option(metavar="R P Y", help="And how it is turned there, rad. [default: 0 0 0]")] = None,
    write: Annotated[
        str | None,
        typer.Option(
            metavar="CELL", help="Write it to the controller of this cell's robot, once somebody has accepted. Targets ur, xarm, franka."
        ),
    ] = None,
    accepted_by: Annotated[
        str | None, typer.Option(metavar="NAME", help="With --write: who has accepted. [default: asked at the terminal]")
    ] = None,
) -> None:
    """Write the payload as a robot's controller or a simulator takes it, on standard output; say what that cannot hold."""
    found = read_result_file(result)
    words = find_wording()
    if write is not None:
        if cell is not None or mount_xyz is not None or mount_rpy is not None:
            raise BadInput("--write", "cli-export-mount-of-cell")
        from core.cli.controller_payload import write_to_controller  # noqa: PLC0415 - a file needs no robot's model

        write_to_controller(result, found, target=target, cell_name=write, accepted_by=accepted_by)
        return
    if accepted_by is not None:
        raise BadInput("--accepted-by", "cli-export-nothing-written")
    if target is None:
        for each in TARGETS:
            told = words.say("cli-export-target", title=each.title, says=each.says)
            answers.print(f"{each.name:<13} {told}", highlight=False, soft_wrap=True)
        return
    chosen = target_of(target)
    mount = _find_mount(cell or found.cell, mount_xyz, mount_rpy, cell_given=cell is not None)
    payload, uncertainty = payload_of(found, mount), uncertainty_of(found, mount)
    answers.print(chosen.render_file(payload, uncertainty), end="", markup=False, highlight=False, soft_wrap=True)
    messages.print(words.say("cli-export-frame", says=chosen.says), highlight=False, soft_wrap=True)
    for sentence in lack_sentences(chosen, payload):
        messages.print(sentence, highlight=False, soft_wrap=True)
    if not chosen.holds_uncertainty:
        messages.print(words.say("export-not-held", target=chosen.title), highlight=False, soft_wrap=True)
        for line in state_uncertainty(uncertainty):
            messages.print(words.quote(line), highlight=False, markup=False, soft_wrap=True)


def _find_mount(name: str | None, xyz_m: Triple | None, rpy_rad: Triple | None, *, cell_given: bool) -> Pose:
    """As it was stated, else of the cell."""
    if xyz_m is None and rpy_rad is None:
        return require_mount(None if name is None else load_cell(find_cell(name)))
    if cell_given:
        raise BadInput("--mount-xyz", "export-two-mounts")
    if xyz_m is None:
        raise BadInput("--mount-xyz", "export-mount-incomplete")
    try:
        return Pose(xyz_m=xyz_m, rpy_rad=rpy_rad or (0.0, 0.0, 0.0))
    except ValidationError as error:
        raise schema_flaw(error.errors()[0]).refusal(BadInput, "--mount-xyz, --mount-rpy") from error


def lack_sentences(target: ExportTarget, payload: UncertainParameters) -> list[str]:
    """What gets lost, each with its size against its uncertainty."""
    return [_sentence(target, lack) for lack in target.lacks(payload)]


def _sentence(target: ExportTarget, lack: Lack) -> str:
    return find_wording().say(
        "cli-export-lack", target=target.title, name=lack.name, lost=lack.value, unit=lack.unit, times=float(lack.times_std)
    )
