"""A tie that the procedure leaves open, the motion that is proposed for it, and both recordings together."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.effects.library import library
from core.errors import BadInput
from core.estimation.identification import identify_recording
from core.events import drive
from core.gap.answer import Diagnosis
from core.gap.choice import Choice, choose_experiment
from core.gap.diagnosis import examine
from core.gap.evidence import Evidence
from core.gap.fit_all import one_by_one
from core.gap.tie import INSEPARABLE_SIGMA, distance_sigma
from core.planning.stop import Stop
from core.planning.stops import Stops
from core.procedure.identify import identify
from core.procedure.outcome import Outcome
from core.recording.folder import read_recording
from core.recording.recording import Recording
from core.sessions.simulated import SimulatedSession
from tests.late_readings import CARRIED, LATE, NOISIER, first_run, noisy_cell, session

FEW = tuple(effect for effect in library() if effect.id in ("time_delay", "sensor_lowpass", "kinematic_lag", "base_tilt"))


@dataclass(frozen=True)
class Story:
    """Everything from the first run to the second diagnosis."""

    cell: Cell
    before: Recording
    first: tuple[Diagnosis, Evidence]
    choice: Choice
    outcome: Outcome
    second: tuple[Diagnosis, Evidence]
    out: Path


@pytest.fixture(scope="module")
def story(tmp_path_factory: pytest.TempPathFactory) -> Story:
    """A short procedure leaves a tie; the motion that is proposed is made."""
    cell, before = noisy_cell(), first_run()
    box = cell.payloads[CARRIED].box
    first = examine(before, FEW, fit_all=one_by_one)
    choice = drive(choose_experiment(cell, before, first[1], box))
    out = tmp_path_factory.mktemp("experiment") / "both"
    outcome = drive(identify(cell, session(5), box, stops=Stops(choice.proposal.motion.stops), before=before, out=out))
    return Story(cell, before, first, choice, outcome, examine(outcome.recording, FEW, fit_all=one_by_one), out)


@pytest.mark.thorough
def test_the_procedure_alone_leaves_a_tie_and_a_motion_is_proposed_for_it(story):
    """There is a gap that matters and two names for it that the recording cannot tell apart, so none is given, whichever comes first."""
    diagnosis, _ = story.first
    assert diagnosis.verdict == "ambiguous"
    assert {"time_delay", "sensor_lowpass"} == set(diagnosis.indistinguishable[0].ids)
    proposed = diagnosis.next_experiment
    assert set(proposed.splits[0]) == {"time_delay", "sensor_lowpass"}
    assert proposed.sigma_before < INSEPARABLE_SIGMA < proposed.sigma_after


@pytest.mark.thorough
def test_both_recordings_together_give_the_right_name(story):
    """One name, the right one, with the delay that was planted; no tie is left."""
    diagnosis, _ = story.second
    assert diagnosis.verdict == "explained"
    assert diagnosis.effects[0].id == "time_delay"
    assert diagnosis.effects[0].probability > 0.9
    assert diagnosis.effects[0].parameters["delay_s"].value == pytest.approx(LATE.delay_s, abs=5e-4)
    assert diagnosis.indistinguishable == []


@pytest.mark.thorough
def test_the_distance_reached_is_the_one_that_was_predicted_along_the_plan(story):
    _, evidence = story.second
    fits = {fit.name: fit for fit in evidence.singles}
    reached = distance_sigma(evidence.windows, fits["time_delay"], fits["sensor_lowpass"])
    assert story.choice.proposal.after == pytest.approx(reached, abs=1.5 + 0.15 * reached)  # a distance has a standard deviation of 1


@pytest.mark.thorough
def test_the_old_recording_is_kept_whole_and_the_new_one_follows_after_a_gap(story):
    both, n = story.outcome.recording, len(story.before)
    np.testing.assert_array_equal(both.t[:n], story.before.t)
    np.testing.assert_array_equal(both.wrench[:n], story.before.wrench)
    assert both.t[n] - both.t[n - 1] > 10.0
    assert (np.diff(both.t) > 0).all()
    np.testing.assert_array_equal(read_recording(story.out).wrench, both.wrench)


@pytest.mark.thorough
def test_no_limit_was_exceeded_by_the_proposed_motion(story):
    assert story.outcome.restarts == 0
    assert story.outcome.safety.max_speed_m_s <= story.cell.limits.cartesian_speed_m_s
    assert story.outcome.safety.min_distance_m >= story.cell.limits.clearance_m


@pytest.mark.thorough
def test_no_window_reaches_across_the_gap_and_offsets_may_differ(story):
    windows, gap = story.second[1].windows, (story.before.t[-1], story.outcome.recording.t[len(story.before)])
    reach = 2.0 * windows.step
    assert not ((windows.centres > gap[0] - reach) & (windows.centres < gap[1] + reach)).any()
    assert windows.X.shape[2] == 26 + story.before.q.shape[1] + 6
    change = story.second[1].best.beta[-6:]
    recording, n = story.outcome.recording, len(story.before)
    at_home = recording.wrench[n : n + 20].mean(axis=0) - recording.wrench[:20].mean(axis=0)  # both set out from home
    noise = NOISIER * np.array(load_cell(find_cell("lwr4_bench")).sensor.noise_std)
    assert (np.abs(change - at_home) < 5.0 * noise * np.sqrt(2 / 20)).all()


@pytest.mark.thorough
def test_the_payload_of_both_together_is_identified(story):
    estimate = identify_recording(story.outcome.recording).estimate
    truth = story.cell.payloads[CARRIED].parameters.phi
    assert np.all(np.abs(estimate.phi - truth) < 4.5 * estimate.std)


@pytest.mark.thorough
def test_what_is_no_motion_or_no_recording_of_this_robot_is_refused_before_anything_moves(story):
    other = load_cell(find_cell("ur5e_line"))
    carried = other.payloads["cylinder"]
    stops = Stops((Stop(down=(0.0, 0.0, 1.0)),))
    run = identify(other, SimulatedSession(other, carried.parameters), carried.box, stops=stops, before=story.before)
    with pytest.raises(BadInput, match="another robot"):
        drive(run)
    with pytest.raises(BadInput, match="no stops"):
        Stops(())
