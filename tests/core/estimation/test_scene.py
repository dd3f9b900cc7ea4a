"""`core.estimation.scene`: the nominal run on a grid whose period that of the recording does not divide."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.gap.basis import basis_of
from core.recording.recording import Recording
from tests.synthetic import Imperfections, payload, record, run_of


def thin(recording: Recording, step: int) -> Recording:
    columns = ("t", "wrench", "q", "dq", "q_cmd", "tau", "phase")
    return replace(recording, **{name: x[::step] for name in columns if (x := getattr(recording, name)) is not None})


@pytest.mark.parametrize("step", [1, 2, 3, 4], ids=["1 kHz", "500 Hz", "333 Hz", "250 Hz"])
def test_joints_move_on_evenly_whatever_the_rate_of_the_recording(step: int) -> None:
    exact = Imperfections(noise_std=np.full(6, 1e-3), encoder_std=0.0, resolution=None)
    whole = record(run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0), exact)
    assert whole.q is not None
    velocity = np.gradient(whole.q, whole.t, axis=0)
    scene = basis_of(thin(whole, step)).scene
    assert scene.q is not None and scene.dq is not None
    for found, true in ((scene.q, whole.q), (scene.dq, velocity)):
        expected = np.column_stack([np.interp(scene.t, whole.t, joint) for joint in true.T])
        assert np.abs(found - expected).max() < 0.01 * np.ptp(velocity)
