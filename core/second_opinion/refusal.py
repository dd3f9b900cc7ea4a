"""What the second opinion says to a plan that it does not confirm."""

from __future__ import annotations

from core.errors import PlanDisputed
from core.second_opinion.opinion import Approach, LostLoad, Opinion


def refuse_disputed(opinion: Opinion) -> None:
    """Nothing where the plan passes.

    Raises:
        PlanDisputed: with the first violation.
    """
    for found in opinion.violations[:1]:
        if isinstance(found, Approach):
            raise PlanDisputed(
                "opinion-too-close",
                in_the_way=found.second,
                first=found.first,
                second=found.second,
                distance_m=found.distance_m,
                required_m=found.required_m,
                time_s=found.time_s,
                part=found.part,
            )
        if isinstance(found, LostLoad):
            raise PlanDisputed(
                "opinion-load-into-zone",
                in_the_way=found.zone,
                zone=found.zone,
                depth_m=-found.distance_m,
                speed_m_s=found.speed_m_s,
                time_s=found.time_s,
                part=found.part,
            )
        raise PlanDisputed(
            "opinion-too-fast",
            body=found.body,
            speed_m_s=found.speed_m_s,
            limit_m_s=found.limit_m_s,
            time_s=found.time_s,
            part=found.part,
        )
