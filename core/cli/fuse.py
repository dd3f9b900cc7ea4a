"""`heft fuse`: several runs of one payload as one answer."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from core.cli.options import JsonOption, check_new
from core.cli.series_runs import read_runs
from core.cli.series_table import fusion_tables, print_series
from core.estimation.series import prior_of
from core.payload.series import compare_series

app = typer.Typer()


@app.command("fuse")
def fuse_command(
    runs: Annotated[
        list[Path], typer.Argument(metavar="RUN...", help="Answers that --json wrote, folders of runs, or folders of recordings.")
    ],
    json: JsonOption = None,
    prior_percent: Annotated[
        float | None,
        typer.Option(
            "--prior",
            min=0.01,
            max=100.0,
            metavar="PERCENT",
            help="Count the reference (CAD) that the runs name as known beforehand, to so many percent, one standard deviation.",
        ),
    ] = None,
) -> None:
    """One answer from several runs of one payload, with the share that each of them and a prior has in it."""
    check_new(None, json)
    series = read_runs(runs)
    prior, source = (None, None) if prior_percent is None else prior_of(series.results, prior_percent / 100.0)
    found = compare_series(series.names, series.measured, prior=prior, prior_source=source)
    print_series(found, fusion_tables(found), json)
