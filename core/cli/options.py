"""Options that several commands have, and what they choose."""

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from core.cell.cell import Cell, Payload
from core.errors import BadInput, BadPayload
from core.words.catalogue import Language, find_language


class PlannerName(StrEnum):
    """The planners at hand."""

    rrt_connect = "rrt_connect"
    rrt_star = "rrt_star"


CellArgument = Annotated[str, typer.Argument(metavar="CELL", help="A cell's name (see `heft cells`) or the path of its folder.")]
JsonOption = Annotated[str | None, typer.Option("--json", metavar="FILE", help="Write the answer as JSON; `-` for standard output.")]
SeedOption = Annotated[int, typer.Option(min=0, help="Makes planning and the simulated noise repeatable.")]
PlannerOption = Annotated[PlannerName, typer.Option(help="How paths are searched.")]
LanguageOption = Annotated[
    Language, typer.Option("--language", default_factory=find_language, show_default="the terminal's", help="Of the report.")
]
PayloadOption = Annotated[str | None, typer.Option(metavar="NAME", help="A payload that the cell knows. [default: its first]")]
TargetOption = Annotated[
    str | None,
    typer.Option(
        metavar="TARGET",
        help="How exactly, half-widths of 95 % intervals: mass=0.1%,com=0.5mm,inertia=1%, or requirement for what the cell's controller "
        "requires. A run ends as soon as it is reached.",
    ),
]


def choose_payload(cell: Cell, name: str | None) -> tuple[str, Payload]:
    """The payload that the simulated robot is to carry."""
    chosen = name or next(iter(cell.payloads), "none")
    if chosen not in cell.payloads:
        where = f"{cell.folder / 'cell.toml'}: payloads"
        if not cell.payloads:
            raise BadPayload(where, "cli-no-payloads", name=chosen)
        raise BadPayload(where, "cli-no-such-payload", name=chosen, names=list(cell.payloads))
    return chosen, cell.payloads[chosen]


def check_new(target: Path | None, json: str | None) -> None:
    """Before anything long begins: what is to be written can be written, and overwrites nothing but a JSON file."""
    if target is not None and target.exists() and not (target.is_dir() and not any(target.iterdir())):
        raise BadInput(str(target), "cli-exists-already")
    if json is not None and json != "-" and not Path(json).absolute().parent.is_dir():
        raise BadInput(json, "cli-folder-missing")
