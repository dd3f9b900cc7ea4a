"""Identification that knows what the cell's twin has beyond the nominal one."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.estimation.identification import identify_recording
from core.recording.recording import Recording
from core.twin.twin import NOMINAL, Twin
from tests.synthetic import payload, record, run_of
from tests.twin_entries import entry

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
BODY = payload("steel_block")
GAIN = np.array([0.03, 0.03, 0.03, 0.03, 0.03, 0.03])
SAMPLES_LATE = 15


@cache
def clean() -> Recording:
    return record(run_of("lwr4_bench", 0, repetitions=2), BODY, np.random.default_rng(0))


def amplified() -> Recording:
    """Every channel reads 3 % too much; the offset does not matter."""
    assert clean().wrench is not None
    return replace(clean(), wrench=clean().wrench * (1 + GAIN))


def gain(std: float) -> Twin:
    names = ("fx", "fy", "fz", "tx", "ty", "tz")
    return Twin(effects=(entry(CELL, "sensor_gain", std=std, **{f"{name}_gain_error_share": 0.03 for name in names}),))


def test_without_effects_nothing_changes() -> None:
    a, b = identify_recording(clean()), identify_recording(clean(), NOMINAL)
    assert a.estimate is not None and b.estimate is not None
    np.testing.assert_array_equal(a.estimate.phi, b.estimate.phi)
    assert b.accounted == ()


def test_a_gain_error_is_taken_off_and_its_uncertainty_goes_into_the_payload() -> None:
    std = 0.002
    blind, found = identify_recording(amplified()).estimate, identify_recording(amplified(), gain(std))
    assert blind is not None and found.estimate is not None
    assert blind.phi[0] == pytest.approx(1.03 * BODY.mass, rel=1e-3)
    assert found.accounted == ("sensor_gain",)
    assert np.abs((found.estimate.phi - BODY.phi) / found.estimate.std).max() < 4.0
    # six independent gains over six orientations: the force channels share the weight, each in a third of the run
    assert 0.5 * std < found.estimate.budget.parts["twin"][0] / BODY.mass < 1.2 * std
    # what the twin has measured is not assumed on top of it
    assert found.estimate.budget.parts["sensor_gain"][0] == 0.0
    (share,) = found.shares
    assert (share.effect, share.title.code) == ("sensor_gain", "effect-sensor-gain-title")
    np.testing.assert_allclose(share.change[:4], (found.estimate.phi - blind.phi)[:4], atol=1e-3)  # what the twin changed, by itself
    certain = identify_recording(amplified(), gain(0.0)).estimate
    assert certain is not None
    assert "twin" not in certain.budget.parts
    assert found.series is not None and found.series.measured is not None and found.series.reconstructed is not None
    still = np.char.startswith(amplified().phase.astype(str), "hold")  # type: ignore[union-attr]  # recorded with phases
    assert np.abs((found.series.measured - found.series.reconstructed)[still].mean(axis=0)).max() < 0.05


@pytest.mark.thorough
def test_a_delay_that_the_twin_has_is_no_delay_any_more() -> None:
    assert clean().wrench is not None
    late = np.concatenate([np.repeat(clean().wrench[:1], SAMPLES_LATE, axis=0), clean().wrench[:-SAMPLES_LATE]])
    twin = Twin(effects=(entry(CELL, "time_delay", std=1e-5, delay_s=1e-3 * SAMPLES_LATE),))
    blind, found = (identify_recording(replace(clean(), wrench=late), it).estimate for it in (NOMINAL, twin))
    assert blind is not None and found is not None and blind.delay_s is not None and found.delay_s is not None
    assert blind.delay_s == pytest.approx(1e-3 * SAMPLES_LATE, abs=2e-4)
    assert found.delay_s == pytest.approx(0.0, abs=3e-4)
    assert np.abs((found.phi - BODY.phi) / found.std).max() < 4.0


def test_poses_are_accounted_for_one_by_one() -> None:
    rows = np.linspace(0, len(clean()) - 1, 40).astype(int)
    columns = {name: getattr(amplified(), name)[rows] for name in ("wrench", "q", "phase")}
    poses = replace(amplified(), t=np.arange(40.0), dq=None, q_cmd=None, tau=None, **columns)
    twin = gain(0.0).with_entry(entry(CELL, "time_delay", delay_s=0.1))
    found = identify_recording(poses, twin)
    alone = identify_recording(poses, gain(0.0))
    assert found.estimate is not None and alone.estimate is not None
    np.testing.assert_allclose(found.estimate.phi[:4], alone.estimate.phi[:4], rtol=1e-9)  # what stands still is not late


def test_what_cannot_be_evaluated_is_said() -> None:
    run = clean()
    robot_less = replace(
        run, q=None, dq=None, q_cmd=None, tau=None, robot=None, orientation=run_of("lwr4_bench", 0, repetitions=2).rotation, position=None
    )
    found = identify_recording(robot_less, Twin(effects=(entry(CELL, "joint_offset", joint_2_rad=0.01),)))
    assert found.accounted == ()
    assert any("joint_offset: the recording has no joint positions" in warning.text for warning in found.warnings)
