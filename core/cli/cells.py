"""`heft cell new` and `heft cell check`: a cell made from a robot as it comes, and what is wrong or doubtful in a cell."""

from __future__ import annotations

import json as json_text
import sys
from pathlib import Path
from typing import Annotated

import typer

from core.cell.folder import find_cell
from core.cli.terminal import answers, find_wording, messages
from core.errors import BadInput
from core.files.whole_file import write_whole
from core.new_cell.findings import CellFinding, findings_of
from core.new_cell.making import PICTURE, make_cell
from core.new_cell.order import Behind, CellOrder
from core.words.catalogue import find_language

app = typer.Typer(help="Make a cell from a robot's description, and look for what is wrong in one.", no_args_is_help=True)

Triple = tuple[float, float, float]


@app.command()
def new(
    name: Annotated[str, typer.Argument(metavar="NAME", help="The cell's name and that of its folder.")],
    urdf: Annotated[Path, typer.Option(metavar="FILE", help="The robot's description, URDF or xacro.")],
    into: Annotated[Path, typer.Option(metavar="DIR", help="Where the cell's folder is made.")] = Path("cells"),
    package_path: Annotated[
        list[Path] | None, typer.Option(metavar="DIR", help="A folder with the ROS packages that the description names; can be repeated.")
    ] = None,
    xacro_arg: Annotated[
        list[str] | None, typer.Option(metavar="NAME:=VALUE", help="An argument of the xacro file; can be repeated.")
    ] = None,
    base_frame: Annotated[str | None, typer.Option(metavar="LINK", help="Where the arm begins. [default: carries its first joint]")] = None,
    sensor_frame: Annotated[
        str | None, typer.Option(metavar="LINK", help="The link that is the sensor's frame. [default: the arm's last]")
    ] = None,
    mount: Annotated[
        str | None, typer.Option(metavar="LINK", help="Fix a new link `ft_sensor` to this one, as the sensor's frame.")
    ] = None,
    mount_xyz: Annotated[Triple, typer.Option(metavar="X Y Z", help="Where it is there, m.")] = (0.0, 0.0, 0.0),
    mount_rpy: Annotated[Triple, typer.Option(metavar="R P Y", help="How it is turned there, rad.")] = (0.0, 0.0, 0.0),
    behind_sensor: Annotated[
        Behind | None, typer.Option(help="What the links behind the sensor frame are. [default: asked at a terminal]")
    ] = None,
) -> None:
    """Make a cell from a robot's URDF or xacro: meshes copied, limits completed, a free home proposed and pictured."""
    order = CellOrder(
        name=name,
        urdf=urdf,
        into=into,
        package_paths=tuple(package_path or ()),
        xacro_arguments=_arguments(xacro_arg or []),
        base_frame=base_frame,
        sensor_frame=sensor_frame,
        mount=mount,
        mount_xyz=mount_xyz,
        mount_rpy=mount_rpy,
        behind=behind_sensor,
    )
    made = make_cell(order, _ask if sys.stdin.isatty() else None)
    words = find_wording()
    for note in made.notes:
        _print(words.quote(note))
    _print(words.say("cli-cell-made", folder=str(made.folder), picture=str(made.folder / PICTURE)))
    _print(words.say("cli-cell-next", cell=name if into == Path("cells") else str(made.folder)))


@app.command()
def check(
    cell: Annotated[str, typer.Argument(metavar="CELL", help="A cell's name (see `heft cells`) or the path of its folder.")],
    json: Annotated[str | None, typer.Option("--json", metavar="FILE", help="Write the findings as JSON; `-` for standard output.")] = None,
) -> None:
    """Say everything that is wrong or doubtful in a cell, and what to do; ends with 2 where something is wrong."""
    folder = find_cell(cell)
    found = findings_of(folder)
    if json is not None:
        _write(_as_json(folder, found), json)
    if json != "-":
        for each in found:
            _print(each.say(find_language()))
        wrong = sum(each.severity == "wrong" for each in found)
        _print(find_wording().say("cli-cell-counts", name=folder.name, wrong=wrong, doubtful=len(found) - wrong))
    if any(each.severity == "wrong" for each in found):
        raise typer.Exit(BadInput.exit_code)


def _as_json(folder: Path, found: list[CellFinding]) -> str:
    return json_text.dumps({"cell": folder.name, "findings": [each._asdict() for each in found]}, indent=2, ensure_ascii=False)


def _write(text: str, target: str) -> None:
    if target == "-":
        sys.stdout.write(text + "\n")
        return
    if not Path(target).absolute().parent.is_dir():
        raise BadInput(target, "cli-folder-missing")
    write_whole(Path(target), text + "\n")


def _ask(question: str, possible: tuple[str, ...]) -> str:
    """Asks until one of the possible answers is given."""
    while True:
        given = str(typer.prompt(f"{question} [{'/'.join(possible)}]", err=True)).strip().lower()
        if given in possible:
            return given
        messages.print(find_wording().say("cli-one-of-please", possible=possible), highlight=False, markup=False)


def _arguments(given: list[str]) -> dict[str, str]:
    """Values by name, as xacro writes them.

    Raises:
        BadInput: one is written otherwise.
    """
    arguments = {}
    for each in given:
        name, separator, value = each.partition(":=")
        if not separator or not name:
            raise BadInput("--xacro-arg", "cli-not-xacro-argument", found=each)
        arguments[name] = value
    return arguments


def _print(sentence: str) -> None:
    answers.print(sentence, highlight=False, markup=False, soft_wrap=True)
