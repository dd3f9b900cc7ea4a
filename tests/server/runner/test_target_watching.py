"""A run's target is watched by another process, from the samples on disk."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.planning.settings import Timing
from core.procedure.target_watch import TargetAnswer
from core.requirement.target import Standing, Target
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from core.sessions.session import RobotState
from server.runner.messages import Order
from server.runner.sample_stream import SampleStream
from server.runner.target_watching import WatchElsewhere
from tests.server.real_service import ROOT, wait_for
from tests.synthetic import payload, record, run_of

CELL = load_cell(ROOT / "cells" / "lwr4_bench")
EMPTY = SampleLog(CELL, RobotModel.of_cell(CELL), payload=None, reference=None)
Watching = Callable[[Target], WatchElsewhere]


@pytest.fixture
def watching(tmp_path: Path) -> Iterator[Watching]:
    """Makes watches of the run in the test's folder, and ends them."""
    begun: list[WatchElsewhere] = []

    def begin(target: Target) -> WatchElsewhere:
        order = Order(
            run="r", cell=CELL, payload="steel_block", known=CELL.payloads["steel_block"], payload_box=CELL.payload_box, timing=Timing(),
            planner="rrt_connect", seed=0, mass_guess_kg=1.0, pace="real_time", folder=tmp_path, target=target,
        )  # fmt: skip
        begun.append(WatchElsewhere(order, target))
        return begun[-1]

    yield begin
    for each in begun:
        each.close()


@pytest.fixture(scope="module")
def recorded():
    return record(run_of("lwr4_bench", period=0.004), payload("steel_block"), np.random.default_rng(0))


def write(folder: Path, recorded) -> None:
    states = [
        RobotState(t=t, q=q, dq=np.zeros(7), q_cmd=q, wrench=wrench)
        for t, q, wrench in zip(recorded.t, recorded.q, recorded.wrench, strict=True)
    ]
    with SampleStream(folder) as stream:
        for k in range(0, len(states), 500):
            stream.append(states[k : k + 500], recorded.phase[k : k + 500].tolist())


def answer_of(watch: WatchElsewhere) -> TargetAnswer:
    watch.ask(EMPTY)
    wait_for(lambda: watch.newest() is not None, "an answer")
    answer = watch.newest()
    assert answer is not None
    return answer


def test_samples_on_disk_are_held_against_the_target(tmp_path, recorded, watching):
    write(tmp_path, recorded)
    assert answer_of(watching(Target(mass_share=0.1))).standing is Standing.REACHED
    # the calibration that is assumed allows 1.4 % of the mass, and no repetition helps
    strict = answer_of(watching(Target(mass_share=0.001)))
    assert strict == TargetAnswer(Standing.TYPE_B, "xyz")


def test_there_is_no_answer_before_there_are_samples_and_one_afterwards(tmp_path, recorded, watching):
    watch = watching(Target(mass_share=0.1))
    watch.ask(EMPTY)
    assert watch.newest() is None
    write(tmp_path, recorded)
    assert answer_of(watch).standing is Standing.REACHED


def test_a_process_that_is_lost_ends_no_run(tmp_path, recorded, watching):
    write(tmp_path, recorded)
    watch = watching(Target(mass_share=0.1))
    known = answer_of(watch)
    watch._process.kill()
    watch._process.join()
    for _ in range(100):
        watch.ask(EMPTY)
        assert watch.newest() == known
