"""The PackML machine against the standard's own words, and as a walk of a random user."""

from __future__ import annotations

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, rule

from server.runs import ledger as run_ledger
from server.runs.packml import (
    COMMANDED,
    COMPLETED,
    Command,
    IllegalCommandError,
    JobState,
    State,
    apply_command,
    job_state,
    legal_commands,
)

WAITING = {"Stopped", "Idle", "Complete", "Aborted", "Suspended", "Held"}
"""States of the standard that wait for a command; all others act and end by themselves."""


def test_there_are_the_seventeen_states_of_the_standard():
    assert len(State) == 17


def test_a_state_either_waits_or_completes_by_itself():
    assert {str(state) for state in State if state not in COMPLETED} == WAITING


def test_abort_is_legal_wherever_it_is_not_under_way_already():
    assert {state for state in State if Command.ABORT not in legal_commands(state)} == {State.ABORTING, State.ABORTED}


def test_stop_is_legal_wherever_nothing_stopped_or_aborted_already():
    without = {State.STOPPING, State.STOPPED, State.ABORTING, State.ABORTED, State.CLEARING}
    assert {state for state in State if Command.STOP not in legal_commands(state)} == without


def test_aborted_is_left_only_by_clear():
    assert legal_commands(State.ABORTED) == (Command.CLEAR,)


@pytest.mark.parametrize("state", list(State))
def test_a_refused_command_names_the_legal_ones(state):
    for command in set(Command) - set(legal_commands(state)):
        with pytest.raises(IllegalCommandError) as refused:
            apply_command(state, command)
        for legal in legal_commands(state):
            assert legal in str(refused.value)


def test_every_state_can_be_reached_and_left():
    reached = {State.STOPPED}
    while True:
        further = {COMMANDED[s, c] for (s, c) in COMMANDED if s in reached} | {COMPLETED[s] for s in reached if s in COMPLETED}
        if further <= reached:
            break
        reached |= further
    assert reached == set(State)
    assert {s for s, _ in COMMANDED} | set(COMPLETED) == set(State)


@pytest.mark.parametrize("state", list(State))
def test_what_is_offered_is_legal_and_never_starts_or_resets_a_run(state):
    legal = {run_ledger.OFFERED.get(command) for command in legal_commands(state)}
    over = state in (State.COMPLETE, State.STOPPED)  # the machine could be aborted there; the run would take its cell once more
    assert set(run_ledger.list_offered_commands(state)) == (set() if over else legal - {None})
    assert not {"start", "reset"} & set(run_ledger.list_offered_commands(state))


class Walk(RuleBasedStateMachine):
    """Any order of commands and completions, with the rules of the standard as invariants."""

    def __init__(self):
        super().__init__()
        self.state, self.before = State.STOPPED, State.STOPPED
        self.command: Command | None = None
        self.released = self.aborted = False

    @rule(command=st.sampled_from(Command))
    def ask(self, command):
        self.before, self.command = self.state, command
        try:
            self.state = apply_command(self.state, command)
        except IllegalCommandError:
            assert command not in legal_commands(self.state)
            return
        self.released = self.released or command is Command.START
        self.aborted = self.aborted or command is Command.ABORT

    @rule()
    def complete(self):
        self.before, self.command = self.state, None
        self.state = COMPLETED.get(self.state, self.state)

    @invariant()
    def only_a_release_leads_to_motion(self):
        if self.state is State.STARTING and self.before is not State.STARTING:
            assert (self.before, self.command) == (State.IDLE, Command.START)
        if self.state is State.EXECUTE and self.before is not State.EXECUTE:
            assert self.before in (State.STARTING, State.UNHOLDING, State.UNSUSPENDING)

    @invariant()
    def a_job_that_was_aborted_stays_so(self):
        seen = job_state(self.state, released=self.released, aborted=self.aborted)
        assert (seen is JobState.ABORTED) == (self.aborted or self.state is State.STOPPED)
        if not self.released and not self.aborted:
            assert seen in (JobState.NOT_ALLOWED_TO_START, JobState.ENDED, JobState.INTERRUPTED, JobState.ABORTED)
        if seen is JobState.ENDED:
            assert self.state is State.COMPLETE


TestWalk = Walk.TestCase
TestWalk.settings = settings(max_examples=60, stateful_step_count=40, deadline=None)
