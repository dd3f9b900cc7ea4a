from __future__ import annotations

from core.report.opinion_rows import opinion_table
from core.second_opinion.opinion import Approach, LostLoad, Opinion, PeakSpeed
from core.second_opinion.pairs import AccountedPair, PairKind
from core.words.message import Message


def test_each_kind_and_the_fastest_point_have_a_row_and_each_reason_a_line() -> None:
    near = Approach(PairKind.FIRST_LINK, "link1", "bench", 0.0391, 0.03, "transfer x+", 1.25)
    wrist = Approach(PairKind.NEAR, "link7", "link5", 0.002, -0.001, "home", 0.0)
    why = Message.of("opinion-pair-neighbours")
    pairs = tuple(AccountedPair(first, second, PairKind.JOINED, 0.0, why, (0, 1), 1) for first, second in (("a", "b"), ("b", "c")))
    table = opinion_table(Opinion((near, wrist), PeakSpeed(0.24, 0.25, "payload", "home", 2.0), pairs, 900))
    first, second, fastest = table.rows
    assert (first.value, first.between, first.limit, first.where) == ("0.039 m", "link1 - bench", "0.030 m", "transfer x+, 1.2 s")
    assert (second.value, second.limit) == ("0.002 m", "-0.001 m")
    assert (fastest.value, fastest.limit) == ("0.240 m/s", "0.250 m/s")
    assert table.left_out == ["a - b, b - c: neighbours: one joint joins them"]
    assert table.samples == 900


def test_a_load_that_comes_off_has_a_row_where_there_is_a_protected_zone() -> None:
    lost = LostLoad(zone="gate", distance_m=0.2123, speed_m_s=0.2, part="transfer y-", time_s=3.04)
    table = opinion_table(Opinion((), PeakSpeed(0.24, 0.25, "payload", "home", 2.0), (), 900, lost))
    row = table.rows[-1]
    assert (row.what, row.value, row.between) == ("a load that comes off", "0.212 m", "its flight - zone gate")
    assert (row.limit, row.where) == ("0.000 m", "transfer y-, 3.0 s")
