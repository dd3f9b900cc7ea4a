"""What a report says of itself can be put in anew, once somebody answers for the result."""

from __future__ import annotations

import re
from datetime import UTC, datetime, timedelta, timezone

import pytest

from core.recording.order_reference import OrderReference
from core.report.record import BEGIN, END, Record, format_time, list_facts, put_record, render_record
from core.words.wording import Wording

ENGLISH, GERMAN = Wording("en"), Wording("de")
AT = datetime(2026, 3, 1, 9, 0, 24, tzinfo=timezone(timedelta(hours=1)))
MADE = Record(at=AT, cell="lwr4_bench", version="0.1.0+3f9c2ab17d", plan_sha256="9f86d081")
KEPT = Record(
    at=AT,
    cell="lwr4_bench",
    version="0.1.0+3f9c2ab17d",
    plan_sha256="9f86d081",
    order=OrderReference(order_id="JO-1", work_order="WO <2>", serial_number="SN-3"),
    run="019ab1c2",
    operator="account:anna",
    accepted_by="account:berta",
    accepted_at=datetime(2026, 3, 1, 8, 3, tzinfo=UTC),
)
PAGE = "<header><h1>Steel block</h1></header><p>2.783 kg</p>"


def test_everything_that_is_known_is_named_and_nothing_else() -> None:
    assert dict(list_facts(KEPT, ENGLISH)) == {
        "Date": "2026-03-01 08:00:24 UTC",
        "Run": "019ab1c2",
        "Order": "JO-1",
        "Work order": "WO <2>",
        "Serial number": "SN-3",
        "Released by": "anna",
        "Accepted by": "berta, 2026-03-01 08:03:00 UTC",
        "Cell": "lwr4_bench",
        "Software": "Heft 0.1.0+3f9c2ab17d",
        "Plan (SHA-256)": "9f86d081",
    }
    assert [name for name, _ in list_facts(MADE, GERMAN)] == ["Datum", "Zelle", "Software", "Plan (SHA-256)"]


def test_a_result_that_nobody_has_accepted_says_so() -> None:
    waiting = Record(at=AT, cell="c", version="1", run="019ab1c2", operator="account:anna")
    assert dict(list_facts(waiting, ENGLISH))["Accepted by"] == "not accepted"
    assert dict(list_facts(waiting, GERMAN))["Angenommen von"] == "nicht angenommen"


@pytest.mark.parametrize("page", [PAGE, PAGE.replace("</header>", f"{render_record(MADE, ENGLISH)}</header>")])
def test_a_page_has_one_record_the_latest_wherever_it_had_one(page: str) -> None:
    once = put_record(page, KEPT, ENGLISH)
    assert put_record(once, KEPT, ENGLISH) == once
    assert (once.count(BEGIN), once.count(END), once.count("<dl")) == (1, 1, 1)
    assert "WO &lt;2&gt;" in once
    assert re.sub(rf"\s*{BEGIN}.*{END}\s*", "", once, flags=re.DOTALL) == PAGE


def test_times_are_the_same_everywhere() -> None:
    assert format_time(AT) == format_time(AT.astimezone(UTC)) == "2026-03-01 08:00:24 UTC"
