"""The motion ahead, joined to the recording at hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.library import library
from core.effects.scene import PER_ROW
from core.gap.basis import basis_of
from core.gap.effect_fit import fit_effects, fit_nominal
from core.gap.prediction import Prediction, append_scene
from core.gap.rehearsal import rehearse
from core.gap.windows import Windows
from core.planning.stop import Stop
from tests.synthetic import Imperfections, payload, record, run_of


def test_whatever_is_known_of_each_row_is_known_of_both() -> None:
    scene = basis_of(record(run_of(repetitions=1), payload("steel_block"), np.random.default_rng(1))).scene
    both = append_scene(scene, scene)
    assert both.joint_inertia.shape == (2 * len(scene), 7, 7)
    for name in set(PER_ROW) - {"motion", "links"}:
        assert getattr(scene, name) is None or len(getattr(both, name)) == 2 * len(scene), name
    assert scene.links is not None and both.links is not None
    for first, joined in zip(scene.links.loads, both.links.loads, strict=True):
        np.testing.assert_array_equal(joined, np.concatenate((first, first)))


def test_what_links_ask_stays_at_its_mean_where_it_is_not_known_ahead() -> None:
    scene = basis_of(record(run_of(repetitions=1), payload("steel_block"), np.random.default_rng(1))).scene
    both = append_scene(scene, replace(scene, links=None))
    assert scene.links is not None and both.links is not None
    moment = scene.links.loads.moment
    np.testing.assert_array_equal(both.links.loads.moment[: len(scene)], moment)
    np.testing.assert_allclose(both.links.loads.moment[len(scene) :], np.tile(moment.mean(axis=0), (len(scene), 1)))


def test_an_effect_that_both_explanations_have_puts_nothing_between_them() -> None:
    recording = record(run_of(repetitions=1), payload("steel_block"), np.random.default_rng(1), Imperfections(drift_n=2.0))
    windows, effects = Windows(basis_of(recording)), {effect.id: effect for effect in library()}
    nominal = fit_nominal(windows)
    scene = windows.basis.scene.with_phi(nominal.phi)
    drift = effects["sensor_drift"]
    first = fit_effects(windows, (drift,), nominal, drift.starts(scene, windows.on_grid(nominal.residual)))
    prediction = Prediction(windows, rehearse(recording, windows.basis.poses, (Stop(down=(0.0, 0.0, 1.0)),)), first)
    other = replace(first, theta=first.theta + 3.0 * first.theta_std)
    assert prediction.distance_sigma(first, other) == pytest.approx(0.0, abs=0.01)
    without = fit_effects(windows, (effects["base_tilt"],), nominal, effects["base_tilt"].starts(scene, windows.on_grid(nominal.residual)))
    assert prediction.distance_sigma(first, without) > 1.0
