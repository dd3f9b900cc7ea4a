"""An alarm is open while what it tells of lasts, and where it stays until somebody has acknowledged it; the next service knows it too."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from sqlalchemy import select

from core.words.message import Message
from server.alarms.book import AlarmBook
from server.alarms.kinds import KINDS, Condition
from server.alarms.tables import AlarmRow
from server.http.errors import Conflict, NotFound
from server.settings import Settings
from tests.server.kept import Kept, kept
from tests.server.made_people import Clock

CAUSE = Message.of("runs-ended")
HELD = Condition("run_held", "r1", Message.of("alarms-run-held", cause=CAUSE), "line", "r1")
ABORTED = Condition("run_aborted", "r1", Message.of("alarms-run-aborted", cause=CAUSE), "line", "r1")
STOPPED = Condition("run_stopped", "r1", Message.of("alarms-run-stopped", cause=CAUSE), "line", "r1")


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def book() -> AlarmBook:
    return AlarmBook()


@pytest.fixture
def service(settings: Settings, clock: Clock) -> Iterator[Kept]:
    with kept(settings, clock) as found:
        yield found


def write(book: AlarmBook, service: Kept) -> None:
    with service.store.write() as db:
        for row in book.take_unwritten():
            db.merge(row)


def read_again(service: Kept) -> AlarmBook:
    """What the next service knows."""
    book = AlarmBook()
    with service.store.read() as db:
        book.load(db)
    return book


def test_what_does_not_stay_goes_with_what_it_tells_of_and_comes_back_as_another(book, clock):
    book.update([HELD], clock())
    (first,) = book.open
    clock.go_on(seconds=5)
    book.update([HELD], clock())
    assert [row.id for row in book.open] == [first.id]
    book.update([], clock())
    assert book.open == []
    clock.go_on(seconds=5)
    book.update([HELD], clock())
    assert book.open[0].id != first.id


def test_what_stays_is_open_until_it_is_both_over_and_acknowledged(book, clock):
    book.update([ABORTED], clock())
    alarm = book.open[0].id
    book.update([], clock())
    assert book.open[0].cleared_at == clock()
    book.acknowledge(alarm, "account:anna", clock())
    assert book.open == []
    clock.go_on(seconds=1)
    book.update([ABORTED], clock())
    other = book.open[0].id
    book.acknowledge(other, "account:anna", clock())
    assert [(row.id, row.acknowledged_by) for row in book.open] == [(other, "account:anna")]
    book.update([], clock())
    assert book.open == []


def test_what_happened_once_is_not_told_again_once_it_is_acknowledged_also_not_by_the_next_service(book, clock, service):
    book.update([STOPPED], clock())
    book.acknowledge(book.open[0].id, "account:anna", clock())
    book.update([STOPPED], clock())
    assert book.open == []
    write(book, service)
    book = read_again(service)
    book.update([STOPPED], clock())
    assert book.open == []


def test_an_alarm_is_acknowledged_once_and_only_while_it_is_open(book, clock):
    book.update([ABORTED], clock())
    alarm = book.open[0].id
    book.acknowledge(alarm, "account:anna", clock())
    with pytest.raises(Conflict, match="by anna"):
        book.acknowledge(alarm, "account:ben", clock())
    book.update([], clock())
    with pytest.raises(NotFound):
        book.acknowledge(alarm, "account:ben", clock())


def test_the_next_service_knows_what_is_open_and_the_history_keeps_who_and_when(book, clock, service):
    book.update([ABORTED, HELD], clock())
    write(book, service)
    again = read_again(service)
    assert sorted(row.kind for row in again.open) == ["run_aborted", "run_held"]
    clock.go_on(minutes=3)
    again.update([], clock())
    again.acknowledge(again.open[0].id, "account:ben", clock())
    write(again, service)
    assert read_again(service).open == []
    with service.store.read() as db:
        rows = list(db.scalars(select(AlarmRow)))
    assert {(row.kind, row.acknowledged_by) for row in rows} == {("run_aborted", "account:ben"), ("run_held", None)}
    assert all(row.cleared_at == clock() for row in rows)


def test_what_could_not_be_written_is_written_as_it_is_by_then(book, clock, service):
    book.update([ABORTED], clock())
    lost = book.take_unwritten()
    book.acknowledge(book.open[0].id, "account:anna", clock())
    book.give_back(lost)
    write(book, service)
    assert read_again(service).open[0].acknowledged_by == "account:anna"


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_says_what_to_do(kind: str):
    advice = Message.of(KINDS[kind].advice)
    assert advice.say("en") != advice.code
    assert advice.say("de") not in (advice.code, advice.say("en"))
