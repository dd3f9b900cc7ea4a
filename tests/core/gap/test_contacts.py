"""Contacts against pushes added to the wrench by the lever rule in base axes, with forces drawn as splines through random knots."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator
from scipy.ndimage import gaussian_filter1d

from core.effects.drift_in_any_attitude import DriftInAnyAttitude
from core.effects.drift_that_wanders import DriftThatWanders
from core.effects.library import library
from core.gap.answer import Diagnosis
from core.gap.basis import basis_of
from core.gap.contact_answer import answer_touched, find_touched
from core.gap.contacts import MARGIN_S, find_contacts, find_stretches, split_pushes
from core.gap.diagnosis import diagnose
from core.gap.effect_fit import fit_nominal
from core.gap.evidence import Evidence, gather, join
from core.gap.fit_all import FitAll, on_all_cores, one_by_one
from core.gap.singles import Singles
from core.gap.windows import Windows
from core.recording.recording import Recording
from tests.synthetic import Imperfections, Run, payload, record, run_of

SPANS = ((0.12, 0.17), (0.4, 0.52), (0.7, 0.73))
"""Shares of the run."""


def spans_of(run: Run) -> list[tuple[float, float]]:
    lasts = run.t[-1] - run.t[0]
    return [(run.t[0] + a * lasts, run.t[0] + b * lasts) for a, b in SPANS]


def push(recording: Recording, run: Run, force: np.ndarray, point: tuple[float, float, float], *, lever: bool = True) -> Recording:
    """Forces (N, 3) on the payload, base axes, at a point, sensor axes: what the sensor exerts on the payload is less by as much."""
    f = np.einsum("nji,nj->ni", run.rotation, force)
    torque = np.cross(np.array(point), f) if lever else np.zeros_like(f)
    return replace(recording, wrench=recording.wrench - np.hstack([f, torque]))


def hand(run: Run, seed: int, most_n: float = 20.0) -> np.ndarray:
    """(N, 3): within each span a force that wanders about a direction of its own, and is nothing at both ends."""
    rng = np.random.default_rng(seed)
    force = np.zeros((len(run.t), 3))
    for begin, end in spans_of(run):
        knots = np.linspace(begin, end, 7)
        direction = rng.normal(size=3)
        values = most_n * (direction / np.linalg.norm(direction) + 0.3 * rng.normal(size=(7, 3)))
        values[[0, -1]] = 0.0
        inside = (run.t > begin) & (run.t < end)
        force[inside] = PchipInterpolator(knots, values)(run.t[inside])
    return force


def shaken(run: Run) -> np.ndarray:
    """(N, 3): in the same spans a force that goes to and fro."""
    force = np.zeros((len(run.t), 3))
    for begin, end in spans_of(run):
        inside = (run.t > begin) & (run.t < end)
        force[inside] = 20.0 * np.sin(2.0 * np.pi * 5.0 * (run.t[inside] - begin))[:, None] * [0.6, 0.0, 0.8]
    return force


@pytest.fixture(scope="module")
def run() -> Run:
    return run_of(repetitions=1)


def found_in(recording: Recording):
    windows = Windows(basis_of(recording))
    return find_contacts(windows, fit_nominal(windows))


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_each_push_of_a_hand_is_found_with_its_time_its_force_and_its_point(run: Run, seed: int) -> None:
    force, point = hand(run, seed), (0.02, -0.01, 0.09)
    contacts = found_in(push(record(run, payload("steel_block"), np.random.default_rng(seed)), run, force, point))
    assert contacts is not None
    assert [(c.begin_s, c.end_s) for c in contacts.found] == [pytest.approx(span, abs=0.1) for span in spans_of(run)]
    for contact in contacts.found:
        inside = (run.t >= contact.begin_s) & (run.t <= contact.end_s)
        assert contact.most_n == pytest.approx(np.linalg.norm(force[inside], axis=1).max(), rel=0.05)
        assert contact.force == pytest.approx(force[inside].mean(axis=0), abs=1.0)
        assert contact.point == pytest.approx(point, abs=0.005)
    free = np.interp(
        Windows(basis_of(record(run, payload("steel_block"), np.random.default_rng(seed)))).centres, run.t, np.abs(force).max(1)
    )
    assert free[contacts.free].max() < 0.05 * np.abs(force).max()


def test_nothing_is_found_where_nothing_touched(run: Run) -> None:
    assert found_in(record(run, payload("steel_block"), np.random.default_rng(4))) is None


def test_a_force_that_is_there_from_the_beginning_on_is_no_contact(run: Run) -> None:
    still, force = record(run, payload("steel_block"), np.random.default_rng(9)), hand(run, 9)
    force[run.t < run.t[0] + 0.3 * (run.t[-1] - run.t[0])] += [3.0, 1.0, 0.0]
    assert found_in(push(still, run, force, (0.02, -0.01, 0.09))) is None
    late = hand(run, 9)
    late[(run.t > run.t[0] + 1.0) & (run.t < run.t[0] + 0.1 * (run.t[-1] - run.t[0]))] += [3.0, 1.0, 0.0]
    assert found_in(push(still, run, late, (0.02, -0.01, 0.09))) is not None


def test_what_shakes_the_payload_to_and_fro_is_no_contact(run: Run) -> None:
    assert found_in(push(record(run, payload("steel_block"), np.random.default_rng(5)), run, shaken(run), (0.0, 0.0, 0.1))) is None


@pytest.mark.parametrize("with_motion", [True, False])
def test_pushes_that_come_with_motion_alone_are_what_the_motion_makes(run: Run, with_motion: bool) -> None:
    rng, lasts_s = np.random.default_rng(10), 0.4
    moves = ~np.char.startswith(run.phase, "hold")
    begins = [
        begin
        for begin in np.arange(run.t[0] + 1.0, run.t[-1] - 1.0, 0.8)
        if not with_motion or moves[(run.t > begin - 0.1) & (run.t < begin + lasts_s + 0.1)].all()
    ]
    force = np.zeros((len(run.t), 3))
    for begin in begins:
        bump = np.sin(np.pi * np.clip((run.t - begin) / lasts_s, 0.0, 1.0)) ** 2
        force += bump[:, None] * rng.normal((10.0, 0.0, 0.0), 3.0)
    contacts = found_in(push(record(run, payload("steel_block"), rng), run, force, (0.02, -0.01, 0.09)))
    assert len(begins) > 20
    assert (contacts is None) == with_motion


def test_a_base_that_is_moved_and_stands_again_is_no_contact(run: Run) -> None:
    still, point = record(run, payload("steel_block"), np.random.default_rng(11)), (0.02, -0.01, 0.09)
    for back, expected in ((-1.0, None), (1.0, 6)):
        force = np.zeros((len(run.t), 3))
        for k, begin in enumerate(run.t[0] + np.linspace(0.1, 0.85, 6) * np.ptp(run.t)):
            bump = np.sin(np.pi * np.clip((run.t - begin) / 0.6, 0.0, 1.0)) ** 2
            force += 15.0 * (back if k % 2 else 1.0) * bump[:, None] * [0.8, 0.6, 0.0]
        contacts = found_in(push(still, run, force, point))
        assert (None if contacts is None else len(contacts.found)) == expected


def test_a_force_without_the_torque_of_any_point_is_no_contact(run: Run) -> None:
    still = record(run, payload("steel_block"), np.random.default_rng(6))
    apart = push(still, run, hand(run, 6), (0.0, 0.0, 0.0), lever=False)
    torque = 2.0 * np.einsum("nji,nj->ni", run.rotation, hand(run, 7))
    assert found_in(replace(apart, wrench=apart.wrench - np.hstack([np.zeros_like(torque), 0.1 * torque]))) is None


def test_stretches_close_together_are_one_and_what_rings_on_is_none_of_them() -> None:
    t = 0.05 * np.arange(400)
    size = np.ones(400)
    size[100:110], size[112:120], size[120:140], size[200:202], size[300:320] = 900.0, 900.0, 9.0, 12.0, 400.0
    assert find_stretches(t, size) == [slice(100, 120), slice(300, 320)]


EFFECTS = [effect for effect in library() if effect.id in ("base_tilt", "time_delay", "sensor_gain", "external_contact")]


@pytest.fixture(scope="module")
def pushed_and_tilted(run: Run) -> Recording:
    tilt = Imperfections(tilt_rad=(0.02, 0.0))
    return push(record(run, payload("steel_block"), np.random.default_rng(8), tilt), run, hand(run, 8), (0.02, -0.01, 0.09))


@pytest.fixture(scope="module")
def diagnosis(pushed_and_tilted: Recording) -> Diagnosis:
    return diagnose(pushed_and_tilted, EFFECTS)


def test_pushes_and_a_base_that_is_not_level_are_both_named_and_the_payload_is_that_of_the_rest(diagnosis: Diagnosis) -> None:
    assert diagnosis.verdict == "explained"
    assert diagnosis.pairs[0].ids == ("external_contact", "base_tilt")
    tilt = diagnosis.pairs[0].parameters["base_tilt"]
    assert np.hypot(tilt["about_x_rad"].value, tilt["about_y_rad"].value) == pytest.approx(0.02, rel=0.05)
    after = diagnosis.payload.after
    truth = payload("steel_block").phi
    assert abs(after.phi[0] - truth[0]) < 4.0 * after.std[0] + 0.001 * truth[0]
    assert diagnosis.gap.after < 0.05 * diagnosis.gap.before
    assert len({each.id for each in diagnosis.effects}) == len(diagnosis.effects)
    total = sum(each.probability for each in (*diagnosis.effects, *diagnosis.pairs))
    assert total + diagnosis.none_probability + diagnosis.unknown_probability == pytest.approx(1.0)


@pytest.mark.thorough
def test_a_push_through_which_the_zero_jumps_is_named_with_the_jump(run: Run) -> None:
    (begin, end), force = spans_of(run)[2], hand(run, 12, most_n=8.0)
    force[run.t < begin] = 0.0
    force[run.t > end] = 0.0
    pushed = push(record(run, payload("steel_block"), np.random.default_rng(12)), run, force, (0.02, -0.01, 0.09))
    jump = (run.t > 0.5 * (begin + end))[:, None] * [-2.0, 0.5, -1.0, -0.05, 0.02, -0.03]
    names = ("external_contact", "sensor_offset_step", "payload_shift", "sensor_drift")
    told = diagnose(replace(pushed, wrench=pushed.wrench + jump), [effect for effect in library() if effect.id in names])
    assert told.verdict == "explained"
    assert told.pairs[0].ids == ("external_contact", "sensor_offset_step")
    at_s = told.pairs[0].parameters["sensor_offset_step"]["step_time_s"].value + run.t[0]
    assert begin - MARGIN_S <= at_s <= end + MARGIN_S  # nobody sees when: what is beside a push is left out with it
    (part,) = told.where.contacts
    assert (part.begin_s, part.end_s) == pytest.approx((begin, end), abs=0.2)


def test_the_stretches_are_told_in_the_answer_and_to_the_person_at_the_robot(diagnosis: Diagnosis, run: Run) -> None:
    told = [(part.begin_s, part.end_s) for part in diagnosis.where.contacts]
    assert told == [pytest.approx(span, abs=0.1) for span in spans_of(run)]
    strongest = max(diagnosis.where.contacts, key=lambda part: part.most_n)
    assert diagnosis.instruction.at_s == pytest.approx(strongest.begin_s)
    assert diagnosis.where.stage == "environment"


@pytest.mark.thorough
@pytest.mark.parametrize("doubt", [0.2, 0.45])
def test_what_contacts_and_an_effect_explain_is_no_surer_than_that_effect_is_of_the_rest(
    pushed_and_tilted: Recording, monkeypatch: pytest.MonkeyPatch, doubt: float
) -> None:
    def join_in_doubt(singles: Singles, fit_all: FitAll) -> Evidence:
        rest = join(singles, fit_all)
        told = tuple((fit, (1.0 - doubt) * probability) for fit, probability in rest.attribution.explained)
        return replace(rest, attribution=replace(rest.attribution, unknown=doubt, explained=told))

    monkeypatch.setattr("core.gap.contact_answer.join", join_in_doubt)
    touched = find_touched(gather(Windows(basis_of(pushed_and_tilted)), EFFECTS), EFFECTS, on_all_cores)
    if touched is None:
        assert doubt == 0.45
    else:
        assert touched.probability < 1.0 - doubt
        assert touched.unknown >= doubt


@pytest.mark.thorough
def test_what_may_explain_the_rest_is_told_with_each_of_its_names(pushed_and_tilted: Recording, monkeypatch: pytest.MonkeyPatch) -> None:
    def join_in_two_minds(singles: Singles, fit_all: FitAll) -> Evidence:
        rest = join(singles, fit_all)
        fits = {fit.name: fit for fit in rest.singles}
        told = ((fits["base_tilt"], 0.48), (fits["sensor_gain"], 0.44))
        return replace(rest, attribution=replace(rest.attribution, none=0.0, unknown=0.08, explained=told))

    monkeypatch.setattr("core.gap.contact_answer.join", join_in_two_minds)
    evidence = gather(Windows(basis_of(pushed_and_tilted)), EFFECTS)
    touched = find_touched(evidence, EFFECTS, on_all_cores)
    assert touched is not None
    told = answer_touched(pushed_and_tilted, evidence, touched)
    assert [pair.ids for pair in told.pairs[:2]] == [("external_contact", "base_tilt"), ("external_contact", "sensor_gain")]
    assert told.pairs[0].probability / told.pairs[1].probability == pytest.approx(0.48 / 0.44)
    assert told.verdict == "ambiguous"
    assert " or " in told.summary.text
    assert told.instruction.level == "ask"  # no motion makes somebody push again
    masses = [fit.phi[0] for fit, _ in touched.beside]
    assert min(masses) < told.payload.after.phi[0] < max(masses), "between what the two make of it"
    assert told.payload.after.std[0] > 1.2 * min(fit.phi_std[0] for fit, _ in touched.beside)


@pytest.mark.thorough
def test_pushes_beside_a_drift_in_a_shape_that_is_sought_last_are_named_with_it(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(DriftThatWanders, "starts", lambda *_: [])  # as where no hold is long enough
    sound = record(run, payload("steel_block"), np.random.default_rng(0), Imperfections())
    noise = np.std(np.diff(sound.wrench[:100], axis=0), axis=0)
    walked = gaussian_filter1d(np.cumsum(np.random.default_rng(1).normal(size=sound.wrench.shape), axis=0), 1000, axis=0)
    drifted = replace(sound, wrench=sound.wrench + 30.0 * noise * walked / walked.std(axis=0))
    pushed = push(drifted, run, hand(run, 3, most_n=4.0), (0.02, -0.01, 0.09))
    few = [effect for effect in library() if effect.id in ("sensor_drift", "external_contact", "sensor_offset_step")]
    evidence = gather(Windows(basis_of(pushed)), few, one_by_one)
    touched = find_touched(evidence, few, one_by_one)
    assert touched is not None
    assert [type(effect) for effect in touched.best.effects] == [DriftInAnyAttitude]
    for found, (begin, end) in zip(touched.contacts.found, spans_of(run), strict=True):
        assert found.begin_s < begin + 0.2
        assert found.end_s == pytest.approx(end, abs=1.0)


def test_a_sensor_that_does_not_come_back_to_nothing_between_two_pushes_does_not_join_them() -> None:
    t = 0.05 * np.arange(200)
    size = np.where((t > 2.0) & (t < 8.0), 6.0, 1.0) + 100.0 * (np.exp(-(((t - 3.0) / 0.2) ** 2)) + np.exp(-(((t - 6.0) / 0.2) ** 2)))
    (stretch,) = find_stretches(t, size)
    pushes = [(float(t[rows.start]), float(t[rows.stop - 1])) for rows in split_pushes(t, size, stretch)]
    assert pushes == [pytest.approx((2.6, 3.4), abs=0.11), pytest.approx((5.6, 6.4), abs=0.11)]


def test_a_push_that_lets_go_for_a_moment_is_one() -> None:
    t = 0.05 * np.arange(200)
    size = np.where((t > 2.0) & (t < 4.0) & ~((t > 2.9) & (t < 3.1)), 100.0, 1.0)
    (stretch,) = find_stretches(t, size)
    assert split_pushes(t, size, stretch) == [stretch]


@pytest.mark.parametrize("apart_s", [0.05, 0.8])
def test_rows_of_one_push_are_one_stretch_however_far_apart_they_are(apart_s: float) -> None:
    size = np.ones(120)
    size[40:57] = 30.0
    assert find_stretches(apart_s * np.arange(120), size) == [slice(40, 57)]


@pytest.mark.thorough
def test_where_no_single_effect_explains_what_contacts_leave_no_several_are_sought(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def join_never(singles: Singles, fit_all: FitAll) -> Evidence:
        pytest.fail(f"{len(singles.fits)} effects were joined")

    leaning = record(run, payload("steel_block"), np.random.default_rng(8), Imperfections(tilt_rad=(0.2, 0.0)))
    pushed = push(leaning, run, hand(run, 8, most_n=30.0), (0.02, -0.01, 0.09))
    others = [effect for effect in library() if effect.id in ("time_delay", "external_contact")]
    evidence = gather(Windows(basis_of(pushed)), others, one_by_one)
    assert find_contacts(evidence.windows, evidence.nominal) is not None
    monkeypatch.setattr("core.gap.contact_answer.join", join_never)
    assert find_touched(evidence, others, one_by_one) is None
