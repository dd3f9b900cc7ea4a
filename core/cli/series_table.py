"""A series of runs as the command line prints it."""

from __future__ import annotations

from rich.table import Table

from core.cli.answer import write_json
from core.cli.tables import decimals_of, format_decimals, number
from core.cli.terminal import answers, find_wording
from core.payload.series import Scatter, Series


def scatter_tables(series: Series) -> list[Table]:
    """What they found together with its scatter, and how far each run is from it."""
    words = find_wording()
    table = _table(words.say("result-series-title"), words.say("result-series-caption"))
    codes = ("result-series-mean", "result-series-stated", "result-series-repeatability", "result-series-reproducibility", "result-unit")
    _add_columns(table, [words.say(code) for code in codes])
    for row in series.parameters:
        scatter = [number(v, 2) for v in (row.stated_std, row.repeatability_std, row.reproducibility_std)]
        table.add_row(row.name, _mean(row), *scatter, row.unit)
    apart = _table(words.say("result-series-apart-title"), words.say("result-series-apart-caption"))
    _add_columns(apart, _numbers(series))
    for row in series.parameters:
        apart.add_row(row.name, *(_distance(row, value, std) for value, std in zip(row.values, row.stds, strict=True)))
    return [table, apart]


def fusion_tables(series: Series) -> list[Table]:
    """The answer with its 95 % half-width, and who has which share in it."""
    words = find_wording()
    table = _table(words.say("result-fusion-title"), words.say("result-fusion-caption"))
    codes = ("result-series-mean", "result-half-width", "result-series-unstated", "result-unit")
    _add_columns(table, [words.say(code) for code in codes])
    for row in series.parameters:
        half = format_decimals(row.half_width, decimals_of(row.half_width))
        table.add_row(row.name, _mean(row), half, number(row.unstated_std or None, 2), row.unit)
    shares = _table(words.say("result-shares-title"), None)
    _add_columns(shares, [*_numbers(series), *([words.say("result-series-prior")] if series.prior_used else [])])
    for row in series.parameters:
        weights = [*row.weights, *([row.prior_weight] if series.prior_used else [])]
        shares.add_row(row.name, *("" if row.mean is None else f"{100.0 * weight:.0f} %" for weight in weights))
    return [table, shares]


def _table(title: str, caption: str | None) -> Table:
    table = Table(title=title, caption=caption)
    table.add_column("", no_wrap=True)
    return table


def _add_columns(table: Table, headings: list[str]) -> None:
    for heading in headings:
        table.add_column(heading, justify="right", no_wrap=True)


def _numbers(series: Series) -> list[str]:
    return [f"{k + 1}" for k in range(len(series.runs))]


def _mean(row: Scatter) -> str:
    return find_wording().say("result-not-determined") if row.mean is None else format_decimals(row.mean, decimals_of(row.half_width))


def _distance(row: Scatter, value: float | None, std: float | None) -> str:
    return "" if value is None or row.mean is None or not std else find_wording().mark(f"{(value - row.mean) / std:+.1f}")


def print_series(series: Series, tables: list[Table], json: str | None) -> None:
    """The answer for a person, or as JSON."""
    if json is not None:
        write_json(series.model_dump_json(indent=2), json)
    if json == "-":
        return
    words = find_wording()
    for table in tables:
        answers.print(table)
    for k, name in enumerate(series.runs):
        answers.print(f"{k + 1}: {name}", highlight=False, markup=False)
    apart = [f"{pair.first} - {pair.second}" for pair in series.pairs if pair.differ]
    if apart and len(series.runs) > 2:
        answers.print(words.say("result-series-apart", pairs=apart), highlight=False)
    for remark in series.remarks:
        answers.print(words.say("result-note", remark=words.quote(remark)), highlight=False)
    answers.print(words.quote(series.verdict), highlight=False)
