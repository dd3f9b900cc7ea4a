"""The workpiece alone as the command line prints it."""

from __future__ import annotations

from rich.table import Table

from core.cli.tables import decimals_of, format_decimals, format_error, number
from core.cli.terminal import find_wording
from core.estimation.result import WorkpiecePart
from core.payload.inertia import PHI_NAMES, PHI_UNITS


def workpiece_table(workpiece: WorkpiecePart) -> Table:
    """Its ten parameters: reference, value with its 95 % half-width, and the error against the reference."""
    words = find_wording()
    caption = words.say("result-workpiece-caption", tools=[tool.name for tool in workpiece.tools])
    table = Table(title=words.say("result-workpiece-title"), caption=caption)
    table.add_column("")
    for heading in (words.say("result-reference"), "Heft", "±", words.say("result-error")):
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column(words.say("result-unit"), no_wrap=True)
    reference = workpiece.reference
    for k, (name, unit) in enumerate(zip(PHI_NAMES, PHI_UNITS, strict=True)):
        truth = reference.phi[k] if reference else None
        value, std = workpiece.phi[k], workpiece.std[k]
        half = None if std is None else 1.96 * std
        places = decimals_of(half)
        shown = words.say("result-not-determined") if value is None else format_decimals(value, places)
        table.add_row(name, number(truth), shown, format_decimals(half, places), format_error(value, truth), unit)
    return table


def workpiece_lines(workpiece: WorkpiecePart) -> list[str]:
    """What has to be known of the numbers."""
    words = find_wording()
    return [words.say("result-note", remark=words.quote(remark)) for remark in workpiece.remarks]
