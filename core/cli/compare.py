"""`heft compare`: several runs of what may be one payload side by side."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from core.cli.options import JsonOption, check_new
from core.cli.series_runs import read_runs
from core.cli.series_table import print_series, scatter_tables
from core.payload.series import compare_series

app = typer.Typer()

ConditionsOption = Annotated[
    str | None,
    typer.Option(metavar="NAME,NAME...", help="Condition of each run (day, plan, robot), in their order, for the reproducibility."),
]


@app.command("compare")
def compare_command(
    runs: Annotated[
        list[Path], typer.Argument(metavar="RUN...", help="Answers that --json wrote, folders of runs, or folders of recordings.")
    ],
    json: JsonOption = None,
    conditions: ConditionsOption = None,
) -> None:
    """Whether several runs found the same payload, and how they scatter: repeatability and reproducibility."""
    check_new(None, json)
    series = read_runs(runs)
    under = None if conditions is None else [name.strip() for name in conditions.split(",")]
    found = compare_series(series.names, series.measured, conditions=under)
    print_series(found, scatter_tables(found), json)
