"""What the second opinion found, as the rows of a report."""

from __future__ import annotations

from dataclasses import dataclass

from core.second_opinion.left_out import describe_left_out
from core.second_opinion.opinion import Opinion


@dataclass(frozen=True)
class OpinionRow:
    """A kind of pair where it comes closest, or the fastest point, in words."""

    what: str
    value: str
    between: str
    limit: str
    where: str


@dataclass(frozen=True)
class OpinionTable:
    """All of it.

    Args:
        left_out: pairs of which nothing is asked, a line for each reason.
    """

    samples: int
    rows: list[OpinionRow]
    left_out: list[str]


def opinion_table(opinion: Opinion) -> OpinionTable:
    """A row for each kind of pair, one for the fastest point, and one for a load that comes off where there is a protected zone."""
    rows = [
        OpinionRow(
            each.kind,
            f"{each.distance_m:.3f} m",
            f"{each.first} - {each.second}",
            f"{each.required_m:.3f} m",
            f"{each.part}, {each.time_s:.1f} s",
        )
        for each in opinion.approaches
    ]
    fast = opinion.fastest
    limit, where = f"{fast.limit_m_s:.3f} m/s", f"{fast.part}, {fast.time_s:.1f} s"
    rows.append(OpinionRow("fastest point", f"{fast.speed_m_s:.3f} m/s", f"a corner of {fast.body}", limit, where))
    lost = opinion.lost_load
    if lost is not None:
        where = f"{lost.part}, {lost.time_s:.1f} s"
        rows.append(OpinionRow("a load that comes off", f"{lost.distance_m:.3f} m", f"its flight - zone {lost.zone}", "0.000 m", where))
    return OpinionTable(opinion.samples, rows, describe_left_out(opinion.left_out))
