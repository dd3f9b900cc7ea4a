"""`heft export`: a result as robot controllers and simulators take it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from core.cell.folder import find_cell, load_cell
from core.cli.answer_file import read_result_file
from core.cli.terminal import answers, find_wording, messages
from core.export.exports import TARGETS, frame_of, payload_of, target_of
from core.export.target import ExportTarget, Lack
from core.export.uncertainty import state_uncertainty, uncertainty_of
from core.payload.uncertain_parameters import UncertainParameters

app = typer.Typer()


@app.command()
def export(
    result: Annotated[Path, typer.Argument(metavar="RESULT", help="The answer of `heft run` or `heft identify`, as --json wrote it.")],
    target: Annotated[str | None, typer.Option(metavar="NAME", help="For whom; the targets are listed where none is named.")] = None,
    cell: Annotated[str | None, typer.Option(metavar="CELL", help="Whose sensor mount counts. [default: the cell of the result]")] = None,
) -> None:
    """Write the payload as a robot's controller or a simulator takes it, on standard output; say what that cannot hold."""
    found = read_result_file(result)
    name = cell or found.cell
    made_in = None if name is None else load_cell(find_cell(name))
    payload = payload_of(found, made_in)
    words = find_wording()
    if target is None:
        for each in TARGETS:
            told = words.say("cli-export-target", title=each.title, says=each.says)
            answers.print(f"{each.name:<13} {told}", highlight=False, soft_wrap=True)
        return
    chosen = target_of(target)
    uncertainty = uncertainty_of(found, made_in)
    answers.print(chosen.render_file(payload, uncertainty), end="", markup=False, highlight=False, soft_wrap=True)
    messages.print(words.say("cli-export-frame", frame=frame_of(made_in), says=chosen.says), highlight=False, soft_wrap=True)
    for sentence in lack_sentences(chosen, payload):
        messages.print(sentence, highlight=False, soft_wrap=True)
    if not chosen.holds_uncertainty:
        messages.print(words.say("export-not-held", target=chosen.title), highlight=False, soft_wrap=True)
        for line in state_uncertainty(uncertainty):
            messages.print(words.quote(line), highlight=False, markup=False, soft_wrap=True)


def lack_sentences(target: ExportTarget, payload: UncertainParameters) -> list[str]:
    """What gets lost, each with its size against its uncertainty."""
    return [_sentence(target, lack) for lack in target.lacks(payload)]


def _sentence(target: ExportTarget, lack: Lack) -> str:
    return find_wording().say(
        "cli-export-lack", target=target.title, name=lack.name, lost=lack.value, unit=lack.unit, times=float(lack.times_std)
    )
