"""`core.effects.base_that_sinks`: ground that gives way under an arm, and point masses on its sensor."""

from __future__ import annotations

import numpy as np
import pytest

from core.effects.base_that_sinks import BaseThatSinks
from core.effects.library import library
from core.gap.basis import basis_of
from core.gap.diagnosis import diagnose
from core.recording.recording import Recording
from tests.core.effects.turned_base import BODY, run, with_gravity_turned

Array = np.ndarray
TILT = np.array([0.006, -0.004, 0.0])
SUNK = np.array([0.02, 0.012, 0.0])
"""rad, about x, y and z of the base, in the end."""
START_S, TIME_CONSTANT_S = 14.0, 8.0


def sinking() -> Recording:
    """Not level at first, then as ground that settles."""
    since = run().t - run().t[0] - START_S
    share = np.where(since > 0.0, 1.0 - np.exp(-np.maximum(since, 0.0) / TIME_CONSTANT_S), 0.0)
    return with_gravity_turned(TILT + share[:, None] * SUNK)


def test_a_base_that_sinks_is_named_with_its_tilt_its_sinking_and_its_start() -> None:
    few = [effect for effect in library() if effect.id in ("base_tilt", "joint_offset", "sensor_drift", "sensor_gain")]
    diagnosis = diagnose(sinking(), few)
    best = diagnosis.effects[0]
    assert (diagnosis.verdict, best.id) == ("explained", "base_tilt")
    assert best.parameters["start_s"].value == pytest.approx(START_S, abs=0.5)
    assert best.parameters["settling_rate_per_s"].value == pytest.approx(1.0 / TIME_CONSTANT_S, rel=0.1)
    for k, axis in enumerate("xy"):
        assert best.parameters[f"about_{axis}_rad"].value == pytest.approx(TILT[k], abs=5e-4)
        assert best.parameters[f"sink_{axis}_rad"].value == pytest.approx(SUNK[k], rel=0.05)
    assert not best.addable


def test_a_base_that_does_not_sink_stands_as_a_tilted_one_does() -> None:
    few = [effect for effect in library() if effect.id in ("base_tilt", "sensor_gain")]
    best = diagnose(with_gravity_turned(np.tile(SUNK, (len(run().t), 1))), few).effects[0]
    assert best.id == "base_tilt"
    assert sorted(best.parameters) == ["about_x_rad", "about_y_rad"]


def test_before_its_start_nothing_has_changed() -> None:
    scene = basis_of(sinking()).scene.with_phi(BODY.phi)
    w = np.zeros((len(scene), 6))
    change = BaseThatSinks().wrench(scene, w, np.array([0.0, 0.0, 0.02, 0.01, START_S, 0.1]))
    early = scene.elapsed <= START_S
    assert not change[early].any()
    assert np.abs(change[~early]).max() > 0.1
