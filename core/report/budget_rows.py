"""The uncertainty budget as a table of the report: how much each source contributes to each parameter."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.estimation.budget import REPEATABILITY, TITLES
from core.estimation.estimate import Estimate
from core.report.rows import INTERVAL, LABELS, sentence, two_digits
from core.words.wording import Wording

LITTLE = 0.005
"""Share of the variance below which nothing is printed."""


@dataclass(frozen=True)
class BudgetCell:
    """Share of a parameter's variance: in words, and from 0 to 1 for its shade."""

    text: str
    share: float


@dataclass(frozen=True)
class BudgetRow:
    """One source: what it is called, where its size is from, its share in each known parameter."""

    title: str
    origin: str
    cells: list[BudgetCell]


@dataclass(frozen=True)
class BudgetTable:
    """The whole budget.

    Args:
        names: of the known parameters.
        repeats, total: half-widths of their 95 % intervals, by this recording alone and all in.
        remarks: what was assumed.
    """

    names: list[str]
    rows: list[BudgetRow]
    repeats: list[str]
    total: list[str]
    remarks: list[str]


def read_budget(estimate: Estimate, words: Wording) -> BudgetTable | None:
    """None where nothing is determined."""
    known = np.flatnonzero(estimate.determined)
    if not len(known):
        return None
    budget, total = estimate.budget, estimate.std
    stated = {source.name: source.stated for source in budget.sources}
    rows = []
    for name, std in budget.parts.items():
        if name == REPEATABILITY:
            origin = words.say("report-budget-measured")
        else:
            origin = words.say("report-budget-stated") if stated[name] else words.say("report-budget-assumed")
        rows.append(BudgetRow(words.quote(TITLES[name]), origin, [_cell(float((std[k] / total[k]) ** 2), words) for k in known]))
    return BudgetTable(
        names=[LABELS[k] for k in known],
        rows=rows,
        repeats=[words.mark(two_digits(INTERVAL * float(budget.parts[REPEATABILITY][k]))) for k in known],
        total=[words.mark(two_digits(INTERVAL * float(total[k]))) for k in known],
        remarks=[sentence(each, words) for each in budget.assumptions(estimate.determined)],
    )


def _cell(share: float, words: Wording) -> BudgetCell:
    return BudgetCell(words.mark(f"{100 * share:.0f} %") if share >= LITTLE else "", min(share, 1.0))
