"""`core.gap.answering`: the verdict is about the wrench; what is seen elsewhere stands beside it, with a measure of its own."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.library import library
from core.gap.answer import Also, Diagnosis
from core.gap.diagnosis import diagnose
from core.payload.inertia import InertialParameters
from core.plant.mechanics import Drives
from core.recording.recording import COLUMNS, Recording
from tests.core.gap.recorded_run import plan_of, recorded

FEW = tuple(effect for effect in library() if effect.id in ("base_tilt", "time_delay", "sensor_gain", "sensor_lowpass"))
PAYLOAD = "cylinder"


def noisy(run: Recording) -> Recording:
    """Twice the noise that is stated."""
    noise = np.sqrt(3.0) * run.sensor.noise_std * np.random.default_rng(1).standard_normal(run.wrench.shape)
    return replace(run, wrench=run.wrench + noise)


def with_rows_dropped(run: Recording) -> Recording:
    """Three of a hundred rows lost."""
    kept = np.random.default_rng(2).random(len(run)) > 0.03
    columns = {name: column[kept] for name in COLUMNS if (column := getattr(run, name)) is not None}
    return replace(run, t=run.t[kept], **columns)


def with_reference_off(run: Recording) -> Recording:
    """The payload is 4 % heavier than the reference says."""
    return replace(run, reference=InertialParameters(plan_of("lwr4_bench", PAYLOAD)[0].payloads[PAYLOAD].parameters.phi / 1.04))


SPOILT = {"sensor_noise": noisy, "sample_dropout": with_rows_dropped, "payload_mismatch": with_reference_off}

MOST_THOROUGH = ("sample_dropout", *(pytest.param(name, marks=pytest.mark.thorough) for name in SPOILT if name != "sample_dropout"))


def beside(diagnosis: Diagnosis) -> dict[str, Also]:
    return {each.id: each for each in diagnosis.also}


@pytest.mark.parametrize("name", ["lwr4_bench", pytest.param("ur5e_line", marks=pytest.mark.thorough)])
def test_a_run_of_the_default_robot_has_no_gap_and_its_friction_is_no_news(name: str) -> None:
    diagnosis = diagnose(recorded(name))  # against the whole library
    assert diagnosis.verdict == "no_gap"
    assert (diagnosis.effects, diagnosis.pairs) == ([], [])
    assert [each.id for each in diagnosis.also if each.material] == []
    friction = beside(diagnosis)["joint_friction"]
    assert friction.times_expected == pytest.approx(1.0, abs=0.1)
    assert friction.message.code == "symptom-friction-as-stated"
    assert str(diagnosis.summary) == "Simulation and recording agree as far as it matters."


@pytest.mark.thorough
def test_twice_the_stated_friction_is_told_beside_a_verdict_about_the_wrench() -> None:
    usual = Drives()
    diagnosis = diagnose(recorded(drives=Drives(damping_s=2.0 * usual.damping_s, friction=2.0 * usual.friction)), FEW)
    friction = beside(diagnosis)["joint_friction"]
    assert diagnosis.verdict == "no_gap"
    assert friction.material
    assert friction.side == "joints"
    assert friction.times_expected == pytest.approx(2.0, rel=0.1)
    assert friction.parameters["joint_1_coulomb_nm"].value == pytest.approx(7.04, rel=0.1)
    assert "rubs" not in diagnosis.summary.text


@pytest.mark.thorough
def test_friction_that_nobody_states_is_told_with_its_size_and_does_not_matter() -> None:
    friction = beside(diagnose(replace(recorded(), friction=None), FEW))["joint_friction"]
    assert not friction.material
    assert friction.times_expected is None
    assert "the cell states no friction" in friction.message.text


@pytest.mark.parametrize(("spoilt", "times"), [("sensor_noise", 2.0), ("sample_dropout", 3.0), ("payload_mismatch", 4.0)])
def test_what_is_wrong_with_readings_or_reference_stands_beside_no_gap_and_leads_the_summary(spoilt: str, times: float) -> None:
    diagnosis = diagnose(SPOILT[spoilt](recorded()), FEW)
    seen = beside(diagnosis)
    assert (diagnosis.verdict, diagnosis.effects, diagnosis.pairs) == ("no_gap", [], [])
    assert {name for name, each in seen.items() if each.material} == {spoilt}
    assert seen[spoilt].times_expected == pytest.approx(times, rel=0.1)
    assert diagnosis.summary.text == f"Simulation and recording agree as far as it matters. {seen[spoilt].message.text}"


@pytest.mark.parametrize("spoilt", MOST_THOROUGH)
def test_it_stands_beside_an_effect_in_the_wrench_and_takes_no_part_in_its_probability(spoilt: str) -> None:
    diagnosis = diagnose(SPOILT[spoilt](recorded(delay_s=0.02)), FEW)
    assert (diagnosis.verdict, diagnosis.effects[0].id) == ("explained", "time_delay")
    assert diagnosis.effects[0].addable
    assert beside(diagnosis)[spoilt].material
    names = {each.id for each in diagnosis.effects} | {name for pair in diagnosis.pairs for name in pair.ids}
    assert names <= {effect.id for effect in FEW}
    shares = [each.probability for each in (*diagnosis.effects, *diagnosis.pairs)]
    assert sum(shares) + diagnosis.none_probability + diagnosis.unknown_probability == pytest.approx(1.0)


@pytest.mark.thorough
@pytest.mark.parametrize("spoilt", MOST_THOROUGH)
def test_it_does_not_take_the_place_of_unknown(spoilt: str) -> None:
    run = SPOILT[spoilt](recorded(magnet=4.0))
    diagnosis = diagnose(run, FEW)
    assert diagnosis.verdict == "unknown"
    assert spoilt == "payload_mismatch" or beside(diagnosis)[spoilt].material  # a gap of unknown cause may be why the payload is off
    assert diagnosis.summary.text.startswith("There is a gap that no effect of the library explains.")


@pytest.mark.thorough
@pytest.mark.parametrize("off", [1.0, 1.01])
def test_a_reference_is_not_doubted_where_a_gap_of_unknown_cause_may_be_why(off: float) -> None:
    true = plan_of("lwr4_bench", PAYLOAD)[0].payloads[PAYLOAD].parameters
    diagnosis = diagnose(replace(recorded(magnet=4.0), reference=InertialParameters(off * true.phi)), FEW)
    mismatch = beside(diagnosis).get("payload_mismatch")
    assert diagnosis.verdict == "unknown"
    assert mismatch is None or not mismatch.material
