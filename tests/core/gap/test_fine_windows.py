"""A tool that rings faster than the windows show, of a generator that shares no code with the engine."""

from __future__ import annotations

import numpy as np
import pytest

from bench.third_stranger.making import make_case
from bench.third_stranger.plan import list_cases
from core.effects.library import library
from core.gap.basis import basis_of
from core.gap.closure import gap_of
from core.gap.diagnosis import examine
from core.gap.effect_fit import fit_nominal
from core.gap.fine_windows import FINE_S, find_what_rings, refine
from core.gap.fit_all import one_by_one
from core.gap.limits import GAP
from core.gap.windows import Windows
from core.recording.folder import read_recording
from core.recording.recording import Recording
from tests.synthetic import Imperfections, payload, record, run_of

EFFECTS = [effect for effect in library() if effect.id in ("tool_flexibility", "time_delay", "sensor_gain", "joint_offset")]


@pytest.fixture(scope="module")
def ringing(tmp_path_factory: pytest.TempPathFactory) -> Recording:
    """A nozzle that twists at 11.3 Hz and nods at 23 Hz."""
    folder = tmp_path_factory.mktemp("ringing")
    make_case(next(case for case in list_cases() if case.order.name == "flex_torsion"), folder)
    return read_recording(folder)


@pytest.fixture(scope="module")
def sound() -> Recording:
    return record(run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0), Imperfections())


def test_a_tool_that_rings_at_11_hz_is_named_though_the_usual_windows_say_that_it_does_not_matter(ringing: Recording) -> None:
    usual = Windows(basis_of(ringing))
    assert usual.step > FINE_S
    assert gap_of(usual, fit_nominal(usual)) < GAP
    diagnosis, evidence = examine(ringing, EFFECTS, fit_all=one_by_one)
    assert evidence is not None and evidence.windows.step == pytest.approx(FINE_S)
    assert (diagnosis.verdict, diagnosis.effects[0].id) == ("explained", "tool_flexibility")
    assert diagnosis.gap is not None and diagnosis.gap.before > GAP


@pytest.mark.thorough
def test_where_no_effect_explains_what_rings_the_windows_stay(ringing: Recording) -> None:
    few = [effect for effect in EFFECTS if effect.id != "tool_flexibility"]
    _, evidence = examine(ringing, few, fit_all=one_by_one)
    assert evidence is not None and evidence.windows.step > FINE_S


def test_what_is_sound_stays_in_the_windows_that_it_has(sound: Recording) -> None:
    _, evidence = examine(sound, EFFECTS, fit_all=one_by_one)
    assert evidence is not None and evidence.windows.step > FINE_S
    assert find_what_rings(evidence.windows, evidence.nominal, evidence.nominal) is None


def test_in_finer_windows_noise_alone_still_has_unit_variance(sound: Recording) -> None:
    fine = refine(Windows(basis_of(sound)))
    assert fine.step == pytest.approx(FINE_S)
    assert float(np.square(fit_nominal(fine).residual).mean()) == pytest.approx(1.0, abs=0.1)
