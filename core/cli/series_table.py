"""A series of runs as the command line prints it."""

from __future__ import annotations

from rich.table import Table

from core.cli.answer import write_json
from core.cli.tables import decimals_of, format_decimals, number
from core.cli.terminal import answers, find_wording
from core.payload.series import Scatter, Series


def scatter_table(series: Series) -> Table:
    """What each run found, and how they scatter."""
    words = find_wording()
    table = Table(title=words.say("result-series-title"), caption=words.say("result-series-caption"))
    table.add_column("")
    for name in series.runs:
        table.add_column(words.quote(name), justify="right")
    for code in ("result-series-mean", "result-series-stated", "result-series-repeatability", "result-series-reproducibility"):
        table.add_column(words.say(code), justify="right", no_wrap=True)
    table.add_column(words.say("result-unit"), no_wrap=True)
    for row in series.parameters:
        places = decimals_of(row.half_width)
        shown = [words.say("result-not-determined") if v is None else format_decimals(v, places) for v in row.values]
        scatter = [number(v, 2) for v in (row.stated_std, row.repeatability_std, row.reproducibility_std)]
        table.add_row(row.name, *shown, format_decimals(row.mean, places), *scatter, row.unit)
    return table


def fusion_table(series: Series) -> Table:
    """The answer with its 95 % half-width, and who has which share in it."""
    words = find_wording()
    table = Table(title=words.say("result-fusion-title"), caption=words.say("result-fusion-caption"))
    table.add_column("")
    for heading in (words.say("result-series-mean"), "±"):
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column(words.say("result-unit"), no_wrap=True)
    table.add_column(words.say("result-series-unstated"), justify="right", no_wrap=True)
    names = [*map(words.quote, series.runs), *([words.say("result-series-prior")] if series.prior_used else [])]
    for name in names:
        table.add_column(name, justify="right")
    for row in series.parameters:
        places = decimals_of(row.half_width)
        shown = words.say("result-not-determined") if row.mean is None else format_decimals(row.mean, places)
        half = format_decimals(row.half_width, places)
        table.add_row(row.name, shown, half, row.unit, number(row.unstated_std or None, 2), *_shares(row, series))
    return table


def _shares(row: Scatter, series: Series) -> list[str]:
    weights = [*row.weights, *([row.prior_weight] if series.prior_used else [])]
    return ["" if row.mean is None else find_wording().mark(f"{100.0 * weight:.0f} %") for weight in weights]


def print_series(series: Series, table: Table, json: str | None) -> None:
    """The answer for a person, or as JSON."""
    if json is not None:
        write_json(series.model_dump_json(indent=2), json)
    if json == "-":
        return
    words = find_wording()
    answers.print(table)
    apart = [f"{pair.first} - {pair.second}" for pair in series.pairs if pair.differ]
    if apart and len(series.runs) > 2:
        answers.print(words.say("result-series-apart", pairs=apart), highlight=False)
    for remark in series.remarks:
        answers.print(words.say("result-note", remark=words.quote(remark)), highlight=False)
    answers.print(words.quote(series.verdict), highlight=False)
