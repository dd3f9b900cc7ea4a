"""`core.trial.second_look`: what a blind trial does with the motion that an answer asks for."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.gap.candidate_motions import second_payload
from core.gap.diagnosis import examine
from core.gap.evidence import Evidence
from core.gap.fit_all import one_by_one
from core.plant.faults import Background, Setting
from core.trial.draw import DrawnTrial, Sealed
from core.trial.second_look import second_look
from tests.late_readings import CARRIED, LATE, SMOOTH, first_run, noisy_cell, short_plan

pytestmark = pytest.mark.thorough


@pytest.fixture(scope="module")
def drawn() -> DrawnTrial:
    cell, plan = noisy_cell(), short_plan()
    setting = Setting(cell, cell.payloads[CARRIED].parameters, plan.robot_s)
    background = Background.draw(np.random.default_rng(0), 1.0, setting)
    sealed = Sealed(
        seed=4, cell=cell.name, payload=CARRIED, kind="single", ids=(LATE.id,), variants=(LATE.variant,), size=1.0, truth="[{}]"
    )
    return DrawnTrial(cell, plan, sealed, (background,), (LATE,))


@pytest.fixture(scope="module")
def evidence() -> Evidence:
    found = examine(first_run(), fit_all=one_by_one)[1]
    assert found is not None
    return found


def test_the_motion_is_made_on_the_same_robot_and_settles_the_name(drawn: DrawnTrial, evidence: Evidence) -> None:
    assert evidence.verdict == "ambiguous"
    after = second_look(drawn, first_run(), evidence, SMOOTH)
    assert after is not None
    assert after.verdict == "explained"
    assert after.effects[0].id == "time_delay"


def test_where_nothing_or_another_payload_is_asked_for_there_is_no_second_look(drawn: DrawnTrial, evidence: Evidence) -> None:
    assert second_look(drawn, first_run(), replace(evidence, proposals=()), SMOOTH) is None
    other = replace(evidence.proposals[0], motion=second_payload(1.0))
    assert second_look(drawn, first_run(), replace(evidence, proposals=(other,)), SMOOTH) is None
