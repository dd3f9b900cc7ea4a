"""What the second opinion says to a plan that it does not confirm."""

from __future__ import annotations

from core.cell.body_name import name_body
from core.cell.cell import Cell
from core.errors import PlanDisputed
from core.second_opinion.opinion import Approach, LostLoad, Opinion
from core.second_opinion.part_name import name_part


def refuse_disputed(cell: Cell, opinion: Opinion) -> None:
    """Nothing where the plan passes.

    Raises:
        PlanDisputed: with the first violation.
    """
    for found in opinion.violations[:1]:
        part, time_s = name_part(found.part), found.time_s
        if isinstance(found, Approach):
            first, second = name_body(cell, found.first), name_body(cell, found.second)
            raise PlanDisputed(
                "planning-disputed-distance",
                first=first,
                second=second,
                distance_m=found.distance_m,
                required_m=found.required_m,
                time_s=time_s,
                part=part,
                in_the_way=found.second,
            )
        if isinstance(found, LostLoad):
            raise PlanDisputed(
                "planning-disputed-throw",
                speed_m_s=found.speed_m_s,
                time_s=time_s,
                part=part,
                depth_m=-found.distance_m,
                zone=found.zone,
                in_the_way=found.zone,
            )
        body, speed_m_s, limit_m_s = name_body(cell, found.body), found.speed_m_s, found.limit_m_s
        raise PlanDisputed("planning-disputed-speed", body=body, speed_m_s=speed_m_s, limit_m_s=limit_m_s, time_s=time_s, part=part)
