"""A twin's effects in a scene."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.effects.library import find_effect, library
from core.twin.model import compose_effects, explain_lacks, find_terms, find_theta, make_home_scene
from core.twin.twin import Twin
from tests.twin_entries import entry

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
TILT = entry(CELL, "base_tilt", about_x_rad=0.01)


@pytest.mark.parametrize("effect", library(), ids=lambda effect: effect.id)
def test_every_effect_can_be_an_entry_and_its_values_come_back_in_order(effect) -> None:
    scene = make_home_scene(CELL)
    parameters = effect.parameters(scene)
    made = entry(CELL, effect.id)
    np.testing.assert_array_equal(find_theta(made, scene), [p.absent for p in parameters])
    assert find_effect(effect.id).id == effect.id


def test_a_parameter_that_the_fit_did_not_have_is_absent() -> None:
    scene = make_home_scene(CELL)
    drift = entry(CELL, "sensor_drift", fx_first_minute_n=2.0)
    cold = drift.model_copy(update={"parameters": {k: v for k, v in drift.parameters.items() if not k.endswith("_per_k")}})
    np.testing.assert_array_equal(find_theta(cold, scene), find_theta(drift, scene))
    assert len(find_theta(drift, replace(scene, temperature=None))) == 7


def test_what_a_scene_lacks_is_said_and_left_out() -> None:
    poses = replace(make_home_scene(CELL), q=None, dq=None, jacobian=None)
    twin = Twin(effects=(TILT, entry(CELL, "joint_offset", joint_2_rad=0.01)))
    assert [term.effect.id for term in find_terms(twin, poses)] == ["base_tilt"]
    assert {name: str(reason) for name, reason in explain_lacks(twin, poses).items()} == {
        "joint_offset": "the recording has no joint positions"
    }
    assert explain_lacks(twin, make_home_scene(CELL)) == {}


def test_effects_act_from_the_robot_to_the_reading_whatever_their_order() -> None:
    gain = entry(CELL, "sensor_gain", fx_gain_error_share=0.1)
    clip = entry(CELL, "cable_drag", pull_x_n=2.0, stiffness_n_per_m=0.0)
    scene = make_home_scene(CELL).with_phi(np.array([2.0, 0, 0, 0.1, 0.02, 0, 0, 0.02, 0, 0.01]))
    first = compose_effects(Twin(effects=(gain, clip)), scene).change(scene)
    np.testing.assert_array_equal(first, compose_effects(Twin(effects=(clip, gain)), scene).change(scene))
    np.testing.assert_allclose(first[:, 0], scene.nominal[:, 0] * 0.1 - 2.0 * 1.1, atol=1e-12)
