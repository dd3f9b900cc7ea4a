"""A cell's twin in memory."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pydantic import ValidationError

from core.cell.folder import load_cell
from core.effects.library import library
from core.twin.twin import NOMINAL, Fitted, Twin, effect_of, make_home_scene
from tests.twin_entries import entry

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
DELAY = entry(CELL, "time_delay", delay_s=0.012)
TILT = entry(CELL, "base_tilt", about_x_rad=0.01)


def test_a_newer_entry_takes_the_place_of_the_older_one() -> None:
    twin = NOMINAL.with_entry(DELAY).with_entry(TILT).with_entry(entry(CELL, "time_delay", delay_s=0.02))
    assert sorted(twin.ids) == ["base_tilt", "time_delay"]
    assert twin.effects[-1].parameters["delay_s"].value == 0.02
    assert twin.without("time_delay").ids == ("base_tilt",)
    assert twin.without("sensor_gain") == twin


@pytest.mark.parametrize("effect", library(), ids=lambda effect: effect.id)
def test_every_effect_can_be_an_entry_and_its_values_come_back_in_order(effect) -> None:
    scene = make_home_scene(CELL)
    parameters = effect.parameters(scene)
    made = entry(CELL, effect.id)
    np.testing.assert_array_equal(made.theta(scene), [p.absent for p in parameters])
    assert effect_of(effect.id).id == effect.id


def test_a_parameter_that_the_fit_did_not_have_is_absent() -> None:
    scene = make_home_scene(CELL)
    drift = entry(CELL, "sensor_drift", fx_first_minute_n=2.0)
    cold = drift.model_copy(update={"parameters": {k: v for k, v in drift.parameters.items() if not k.endswith("_per_k")}})
    np.testing.assert_array_equal(cold.theta(scene), drift.theta(scene))
    assert len(drift.theta(replace(scene, temperature=None))) == 7


def test_what_a_scene_lacks_is_said_and_left_out() -> None:
    poses = replace(make_home_scene(CELL), q=None, dq=None, jacobian=None)
    twin = Twin(effects=(TILT, entry(CELL, "joint_offset", joint_2_rad=0.01)))
    assert [one.effect for one in twin.in_scene(poses)] == ["base_tilt"]
    [lacking] = twin.lacking(poses)
    assert (lacking.code, lacking.parameters["effect"]) == ("twin-lacking", "joint_offset")
    assert str(lacking) == "joint_offset: the recording has no joint positions"
    assert twin.lacking(make_home_scene(CELL)) == ()


def test_directions_carry_the_whole_covariance() -> None:
    covariance = np.array([[4.0, 1.0], [1.0, 2.0]]) * 1e-8
    made = TILT.model_copy(update={"covariance": tuple(map(tuple, covariance.tolist()))})
    axes = np.array([list(direction.values()) for direction in made.directions])
    np.testing.assert_allclose(axes.T @ axes, covariance, rtol=1e-12)
    moved = made.move_parameters(made.directions[0])
    assert moved.parameters["about_x_rad"].value == pytest.approx(0.01 + axes[0, 0])


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_numbers_that_are_none_are_refused(value: float) -> None:
    with pytest.raises(ValidationError):
        Fitted(value=value, std=0.1, unit="s")


def test_effects_act_from_the_robot_to_the_reading_whatever_their_order() -> None:
    gain = entry(CELL, "sensor_gain", fx_gain_error_share=0.1)
    clip = entry(CELL, "cable_drag", pull_x_n=2.0, stiffness_n_per_m=0.0)
    scene = make_home_scene(CELL).with_phi(np.array([2.0, 0, 0, 0.1, 0.02, 0, 0, 0.02, 0, 0.01]))
    first = Twin(effects=(gain, clip)).compose_effects(scene).change(scene)
    np.testing.assert_array_equal(first, Twin(effects=(clip, gain)).compose_effects(scene).change(scene))
    np.testing.assert_allclose(first[:, 0], scene.nominal[:, 0] * 0.1 - 2.0 * 1.1, atol=1e-12)
