"""Runs in the store: states, events and deliveries are kept together or not at all."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from sqlalchemy import func, select

from server.http.errors import Unprocessable
from server.runs import idempotency
from server.runs import ledger as run_ledger
from server.runs.crashed_runs import close_crashed
from server.runs.event_schemas import EventMessage, StateChanged
from server.runs.packml import COMPLETED, Command, IllegalCommandError, State
from server.runs.reason import Reason, read_reason, set_reason
from server.runs.schemas import RunCreate
from server.runs.tables import Delivery, RunEventRow, RunRow, Webhook
from server.settings import Settings
from tests.server.kept import Kept, kept
from tests.server.made_people import BOTH_STORES, Clock
from tests.server.sentence import sentence

ORDER = RunCreate(cell="lwr4_bench", seed=3, payload="steel_block")
TO = {
    State.RESETTING: [],
    State.IDLE: [None],
    State.EXECUTE: [None, Command.START, None],
    State.HELD: [None, Command.START, None, Command.HOLD, None],
    State.SUSPENDED: [None, Command.START, None, Command.SUSPEND, None],
    State.COMPLETING: [None, Command.START, None, None],
    State.STOPPING: [None, Command.START, None, Command.STOP],
    State.ABORTING: [None, Command.START, None, Command.ABORT],
    State.ABORTED: [None, Command.START, None, Command.ABORT, None],
    State.CLEARING: [None, Command.ABORT, None, Command.CLEAR],
    State.COMPLETE: [None, Command.START, None, None, None],
    State.STOPPED: [None, Command.STOP, None],
}


pytestmark = BOTH_STORES


@pytest.fixture
def service(settings: Settings, clock: Clock) -> Iterator[Kept]:
    with kept(settings, clock) as found:
        yield found


def run_in(service: Kept, state: State) -> str:
    with service.store.write() as db:
        row = run_ledger.add_run(db, ORDER, "account:anna", service.now())
        row.released = Command.START in TO[state]
        run_ledger.keep_steps(db, row, TO[state], service.now())
        assert row.state == state
        return row.id


def events(service: Kept, run: str) -> list[EventMessage]:
    with service.store.read() as db:
        return [EventMessage.model_validate_json(text) for _, text in run_ledger.list_events(db, run, 0)]


def test_every_state_is_an_event_and_sequence_numbers_have_no_gaps(service):
    messages = events(service, run_in(service, State.COMPLETE))
    assert [message.sequence for message in messages] == list(range(1, len(messages) + 1))
    states = [message.event.state for message in messages if isinstance(message.event, StateChanged)]
    assert states == ["Resetting", "Idle", "Starting", "Execute", "Completing", "Complete"]


def test_an_illegal_command_keeps_nothing(service):
    run = run_in(service, State.IDLE)
    before = events(service, run)
    with pytest.raises(IllegalCommandError), service.store.write() as db:
        row = run_ledger.load_run(db, run)
        set_reason(row, Reason("stopped", sentence("not kept")))
        run_ledger.keep_steps(db, row, [Command.START, Command.UNHOLD], service.now())
    assert events(service, run) == before
    with service.store.read() as db:
        assert run_ledger.load_run(db, run).reason is None


@pytest.mark.parametrize("state", list(TO))
def test_a_crash_in_any_state_leaves_a_run_that_waits_is_over_or_is_aborted_with_its_reason(service, state):
    run = run_in(service, state)
    with service.store.write() as db:
        close_crashed(db, service.now())
    with service.store.read() as db:
        row = run_ledger.load_run(db, run)
    untouched = {State.RESETTING, State.COMPLETE, State.STOPPED, State.ABORTED}
    if state in untouched:
        assert row.state == state
    else:
        assert row.state == (State.STOPPED if state is State.CLEARING else State.ABORTED)
        assert str(state) in str(read_reason(row))
        assert run_ledger.build_answer(row).job_state == "Aborted"
    assert State(row.state) not in set(COMPLETED) - {State.RESETTING}


def test_a_run_that_ends_is_delivered_to_each_webhook_once_also_when_it_is_cleared_later(service):
    with service.store.write() as db:
        for name in ("a", "b"):
            db.add(Webhook(id=name, url="http://plant/", secret="s" * 16, made_by="x", made_at=service.now()))
    run = run_in(service, State.ABORTED)
    with service.store.write() as db:
        assert db.scalar(select(func.count()).select_from(Delivery)) == 2
        run_ledger.keep_steps(db, run_ledger.load_run(db, run), [Command.CLEAR, None], service.now())
        assert db.scalar(select(func.count()).select_from(Delivery)) == 2


def test_runs_of_one_cell_wait_for_each_other_and_an_aborted_one_until_it_is_cleared(service):
    first = run_in(service, State.ABORTED)
    service.now.go_on(seconds=1)
    second = run_in(service, State.RESETTING)
    with service.store.write() as db:
        assert [row.id for row in run_ledger.list_first_runs(db)] == [first]
        run_ledger.keep_steps(db, run_ledger.load_run(db, first), [Command.CLEAR, None], service.now())
        assert [row.id for row in run_ledger.list_first_runs(db)] == [second]


def test_what_is_in_the_way_of_a_cell_is_forgotten_with_the_next_run_and_until_then_belongs_to_the_one_that_has_the_cell(service):
    def in_the_way() -> str | None:
        with service.store.read() as db:
            row = run_ledger.find_latest_run(db, ORDER.cell)
            return None if row is None else row.in_the_way

    assert in_the_way() is None
    refused = run_in(service, State.STOPPED)
    with service.store.write() as db:
        run_ledger.load_run(db, refused).in_the_way = "pillar"
    assert in_the_way() == "pillar"
    service.now.go_on(seconds=1)
    having = run_in(service, State.SUSPENDED)
    assert in_the_way() is None
    service.now.go_on(seconds=1)
    run_in(service, State.RESETTING)
    with service.store.write() as db:
        run_ledger.load_run(db, having).in_the_way = "operator"
    assert in_the_way() == "operator"
    with service.store.read() as db:
        assert run_ledger.find_latest_run(db, "another cell") is None


def test_the_same_key_with_another_body_is_refused(service):
    with service.store.write() as db:
        assert idempotency.recall_request(db, "key:mes", "k", b"one") is None
        idempotency.remember_request(db, "key:mes", "k", b"one", "run-1", service.now())
    with service.store.read() as db:
        assert idempotency.recall_request(db, "key:mes", "k", b"one") == "run-1"
        assert idempotency.recall_request(db, "key:other", "k", b"two") is None
        with pytest.raises(Unprocessable):
            idempotency.recall_request(db, "key:mes", "k", b"two")


def test_an_order_comes_back_as_it_was_given(service):
    run = run_in(service, State.IDLE)
    with service.store.read() as db:
        assert run_ledger.build_answer(run_ledger.load_run(db, run)).order.model_dump() == ORDER.model_dump()
        assert db.scalar(select(func.count()).select_from(RunEventRow)) == db.get(RunRow, run).sequence
