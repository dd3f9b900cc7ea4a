"""What a run measures: a wrench that was not measured is neither recorded nor estimated from, and the motion goes on through it."""

from __future__ import annotations

import numpy as np
import pytest

from core.cell.folder import find_cell, load_cell
from core.procedure.recorder import Recorder, build_estimator
from core.sessions.sample_log import SampleLog
from core.sessions.session import RobotState
from tests.synthetic import Run, payload, record, run_of

COUNT = 15_000


def test_a_wrench_that_was_only_held_is_left_out_and_the_estimate_stays():
    run = run_of("lwr4_bench", 0)
    recording = record(run, payload("steel_block"), np.random.default_rng(0))
    assert recording.q is not None and recording.wrench is not None
    held = np.random.default_rng(1).random(COUNT) < 0.05
    whole, part = (new_recorder(run) for _ in range(2))
    still = np.zeros(recording.q.shape[1])
    for k in range(COUNT):
        t, q, wrench = recording.t[k], recording.q[k], recording.wrench[k]
        whole.take([RobotState(t, q, still, q, wrench)], "transfer")
        part.take([RobotState(t, q, still, q, wrench + 50.0 * held[k], wrench_measured=not held[k])], "transfer")
    assert len(part.log) == COUNT - held.sum()
    assert whole.online is not None and part.online is not None
    np.testing.assert_array_equal(part.online.motion.alpha, whole.online.motion.alpha)
    assert whole.phi[0] is not None
    assert part.phi[0] == pytest.approx(whole.phi[0], rel=1e-3)


def new_recorder(run: Run) -> Recorder:
    log = SampleLog(load_cell(find_cell(run.cell)), run.robot, payload=None, reference=None)
    return Recorder(log, build_estimator(log, 1e-3))
