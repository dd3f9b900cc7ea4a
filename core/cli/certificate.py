"""`heft certificate`: one page for the record of a finished run."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.certificate.certificate import dump_certificate
from core.certificate.issue import issue_certificate
from core.certificate.page import render_certificate
from core.cli.answer import write_json
from core.cli.options import JsonOption, LanguageOption, check_new
from core.cli.series_runs import read_runs
from core.errors import BadInput
from core.estimation.result import Result
from core.files.whole_file import write_whole
from core.recording.manifest import FILE as MANIFEST
from core.recording.order_reference import NO_ORDER
from core.report.record import Record
from core.version import code_version

app = typer.Typer()


@app.command("certificate")
def certificate_command(
    run: Annotated[
        Path, typer.Argument(metavar="RUN", help="Folder of a run, or of a recording, or an answer of `heft run` or `heft identify`.")
    ],
    json: JsonOption = None,
    pdf: Annotated[Path | None, typer.Option(metavar="FILE", help="Write the page, A4 as PDF.")] = None,
    cell: Annotated[
        str | None, typer.Option(metavar="CELL", help="Whose thresholds the values have to meet. [default: the cell of the run]")
    ] = None,
    *,
    language: LanguageOption,
) -> None:
    """Write the certificate of a finished run: one page for the record, as PDF and as JSON."""
    if json is None and pdf is None:
        raise BadInput("heft certificate", "certificate-nothing-asked")
    check_new(pdf, json)
    if pdf is not None:
        check_new(None, str(pdf))
    result = read_runs([run]).results[0]
    found = issue_certificate(result, record_of(result), find_recording(run, result), _find_judge(result, cell))
    if pdf is not None:
        write_whole(pdf, render_certificate(found, language))
    if json is not None:
        write_json(dump_certificate(found).decode().removesuffix("\n"), json)


def record_of(result: Result) -> Record:
    """What a result says of itself: no service has carried it, so nobody has accepted it."""
    return Record(
        at=result.ended_at,
        cell=result.cell,
        version=result.version or code_version(),
        plan_sha256=result.plan_sha256,
        order=result.order or NO_ORDER,
    )


def find_recording(run: Path, result: Result) -> Path | None:
    """The folder of a run is a recording or has one; an answer says where its recording was."""
    named = [] if result.recording is None else [Path(result.recording)]
    return next((folder for folder in (run, run / "recording", *named) if (folder / MANIFEST).is_file()), None)


def _find_judge(result: Result, cell: str | None) -> Cell | None:
    """None where the run's own cell is not at hand; one that is asked for has to be."""
    if cell is not None:
        return load_cell(find_cell(cell))
    try:
        return None if result.cell is None else load_cell(find_cell(result.cell))
    except BadInput:
        return None
