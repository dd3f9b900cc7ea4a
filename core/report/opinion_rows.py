"""What the second opinion found, as the rows of a report."""

from __future__ import annotations

from dataclasses import dataclass

from core.report.motions import name_motion
from core.second_opinion.arm import PAYLOAD
from core.second_opinion.left_out import describe_left_out
from core.second_opinion.opinion import Opinion
from core.second_opinion.pairs import FLOOR, PairKind
from core.words.wording import ENGLISH, Wording

KINDS = {
    PairKind.ENVIRONMENT: "report-pair-environment",
    PairKind.FIRST_LINK: "report-pair-first-link",
    PairKind.MOUNT: "report-pair-mount",
    PairKind.PAYLOAD: "report-pair-payload",
    PairKind.LINKS: "report-pair-links",
    PairKind.NEAR: "report-pair-near",
    PairKind.JOINED: "report-pair-joined",
}
BODIES = {PAYLOAD: "report-body-payload", FLOOR: "report-body-floor"}


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


def opinion_table(opinion: Opinion, words: Wording = ENGLISH) -> OpinionTable:
    """A row for each kind of pair, one for the fastest point, and one for a load that comes off where there is a protected zone."""
    rows = [
        OpinionRow(
            words.say(KINDS[each.kind]),
            words.mark(f"{each.distance_m:.3f} m"),
            f"{_name_body(each.first, words)} - {_name_body(each.second, words)}",
            words.mark(f"{each.required_m:.3f} m"),
            _say_when(each.part, each.time_s, words),
        )
        for each in opinion.approaches
    ]
    fast = opinion.fastest
    rows.append(
        OpinionRow(
            words.say("report-opinion-fastest"),
            words.mark(f"{fast.speed_m_s:.3f} m/s"),
            words.say("report-opinion-corner", body=_name_body(fast.body, words)),
            words.mark(f"{fast.limit_m_s:.3f} m/s"),
            _say_when(fast.part, fast.time_s, words),
        )
    )
    lost = opinion.lost_load
    if lost is not None:
        rows.append(
            OpinionRow(
                words.say("report-opinion-lost-load"),
                words.mark(f"{lost.distance_m:.3f} m"),
                words.say("report-opinion-flight", zone=lost.zone),
                words.mark("0.000 m"),
                _say_when(lost.part, lost.time_s, words),
            )
        )
    return OpinionTable(opinion.samples, rows, [each.say(words.language) for each in describe_left_out(opinion.left_out)])


def _name_body(name: str, words: Wording) -> str:
    """A body's name; what Heft itself calls one is said in words."""
    return words.say(BODIES[name]) if name in BODIES else words.quote(name)


def _say_when(part: object, time_s: float, words: Wording) -> str:
    return words.say("report-opinion-when", part=name_motion(part, words), time_s=time_s)
