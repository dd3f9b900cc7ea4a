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
                f"a second look at the finished plan finds {found.first!r} {found.distance_m:.4f} m from {found.second!r} "
                f"(limit {found.required_m:.3f} m), {found.time_s:.3f} s after the beginning of {found.part}. "
                "Plan again with another seed, or give the robot more room.",
                found.second,
            )
        if isinstance(found, LostLoad):
            raise PlanDisputed(
                f"a second look at the finished plan finds that a load that comes off at {found.speed_m_s:.3f} m/s, {found.time_s:.3f} s "
                f"after the beginning of {found.part}, would fly {-found.distance_m:.4f} m into zone {found.zone!r}. "
                "Plan again with another seed, or give the robot more room.",
                found.zone,
            )
        raise PlanDisputed(
            f"a second look at the finished plan finds a corner of {found.body!r} at {found.speed_m_s:.4f} m/s "
            f"(limit {found.limit_m_s:.3f} m/s), {found.time_s:.3f} s after the beginning of {found.part}. "
            "Plan again with another seed."
        )
