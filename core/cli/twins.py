"""`heft twin add|show|remove`: what has been added to a cell's simulation."""

from __future__ import annotations

import sys
from contextlib import nullcontext
from datetime import UTC, datetime
from pathlib import Path
from typing import Annotated

import typer
from rich.table import Table

from core.cell.folder import find_cell, load_cell
from core.cli.answer_file import read_diagnosis_file
from core.cli.options import CellArgument
from core.cli.terminal import answers, find_wording, messages
from core.errors import BadInput, BadTwin
from core.files.whole_file import write_whole
from core.gap.addition import add_found
from core.gap.twin_addition import find_effects, with_effect
from core.twin.file import close_name, read_twin, write_twin
from core.twin.twin import Entry, Twin
from core.words.message import Message

app = typer.Typer(help="What has been added to a cell's simulation.", no_args_is_help=True)


@app.command()
def add(
    cell: CellArgument,
    recording: Annotated[
        Path, typer.Argument(metavar="RECORDING", help="Folder of a recording, or the file that `heft diagnose --json` wrote of one.")
    ],
    effect: Annotated[str, typer.Argument(metavar="EFFECT", help="An effect's identifier, or several as in `time_delay+base_tilt`.")],
) -> None:
    """Add an effect to the cell's twin as a recording shows it: simulation, identification and diagnosis count with it from then on."""
    chosen = find_effects(effect)
    loaded = load_cell(find_cell(cell))
    before = read_twin(loaded)
    if recording.is_file():
        after = add_found(before, loaded, read_diagnosis_file(recording), effect, datetime.now(UTC))
    else:
        with messages.status(find_wording().say("cli-fitting")) if messages.is_terminal else nullcontext():
            after = with_effect(before, loaded, recording, effect)
    write_twin(loaded, after)
    for identifier in [one.id for one in chosen]:
        if identifier in before.ids:
            answers.print(find_wording().say("cli-twin-replaced", effect=identifier, cell=loaded.name), highlight=False)
        else:
            answers.print(find_wording().say("cli-twin-added", effect=identifier, cell=loaded.name), highlight=False)
    answers.print(twin_table(loaded.name, after))


@app.command()
def show(
    cell: CellArgument,
    json: Annotated[str | None, typer.Option("--json", metavar="FILE", help="Write the twin as JSON; `-` for standard output.")] = None,
) -> None:
    """The effects of a cell's twin, with their parameters and where they come from."""
    loaded = load_cell(find_cell(cell))
    twin = read_twin(loaded)
    if json == "-":
        sys.stdout.write(twin.model_dump_json(indent=2) + "\n")
        return
    if json is not None:
        _write(twin, Path(json))
    if twin.effects:
        answers.print(twin_table(loaded.name, twin))
    else:
        answers.print(find_wording().say("cli-twin-empty", cell=loaded.name), highlight=False)


@app.command()
def remove(
    cell: CellArgument, effect: Annotated[str, typer.Argument(metavar="EFFECT", help="Identifier of an effect that the twin has.")]
) -> None:
    """Take an effect out of the cell's twin."""
    loaded = load_cell(find_cell(cell))
    twin = read_twin(loaded)
    if effect not in twin.ids:
        where = Message.of("cli-effect-of-twin", cell=loaded.name)
        if not twin.ids:
            raise BadTwin(where, "cli-twin-nominal", effect=effect)
        raise BadTwin(where, "twin-unknown-effect", effect=effect, meant=close_name(effect, list(twin.ids)))
    write_twin(loaded, twin.without(effect))
    answers.print(find_wording().say("cli-twin-removed", effect=effect, cell=loaded.name), highlight=False)


def twin_table(name: str, twin: Twin) -> Table:
    """One row per effect."""
    words = find_wording()
    table = Table(title=words.say("cli-twin-title", cell=name), caption=words.say("cli-twin-caption"))
    for heading in (words.say("result-effect"), words.say("result-parameters")):
        table.add_column(heading)
    for heading in (words.say("cli-twin-gap"), words.say("cli-twin-recording"), words.say("cli-twin-entered")):
        table.add_column(heading)
    for entry in twin.effects:
        gap = words.list_numbers([f"{entry.gap_before:.3f}", f"{entry.gap_after:.3f}"])
        source = f"{entry.recording} ({entry.sha256[:12]})"
        table.add_row(entry.effect, _parameters(entry), gap, source, f"{entry.added:%Y-%m-%d %H:%M} UTC")
    return table


def _parameters(entry: Entry) -> str:
    mark = find_wording().mark
    return "\n".join(mark(f"{name} {p.value:.4g} ± {p.std:.2g}") for name, p in entry.parameters.items())


def _write(twin: Twin, file: Path) -> None:
    """A file that appears only when it is whole."""
    if not file.absolute().parent.is_dir():
        raise BadInput(str(file), "cli-folder-missing")
    write_whole(file, twin.model_dump_json(indent=2) + "\n")
