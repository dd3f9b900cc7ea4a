"""The verdict of a run by its cell: good enough, not good enough with the parameter and its numbers, or why it cannot be judged."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from core.array import Array
from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.cell.thresholds import ContactThresholds
from core.requirement.answer import RequirementPart
from core.requirement.verdict import judge_estimate
from core.robot.model import RobotModel

BENCH = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
ROBOT = RobotModel.of_cell(BENCH)
PHI = BENCH.payloads["steel_block"].parameters.phi
STD = np.array([0.003, *[0.0003] * 3, *[0.00008] * 6])


@dataclass
class Found:
    """An estimate, as much of it as is judged."""

    std: Array = field(default_factory=lambda: STD)
    phi: Array = field(default_factory=lambda: PHI)
    determined: Any = field(default_factory=lambda: np.ones(10, dtype=bool))

    @property
    def covariance(self) -> Array:
        return np.diag(self.std**2)


def cell_with(**stated: Any) -> Cell:
    return BENCH.model_copy(update={"thresholds": ContactThresholds(**stated)})


def judged(found: Found | None, **stated: Any) -> RequirementPart:
    return judge_estimate(cell_with(**stated), ROBOT, found)


def test_an_exact_answer_is_good_enough_with_its_margin_in_plain_words() -> None:
    verdict = judged(Found())
    assert verdict.adequacy is not None
    assert verdict.adequacy.good_enough
    assert verdict.assumed
    assert verdict.message.code == "requirement-good-enough"
    assert verdict.message.parameters["margin"] == pytest.approx(verdict.adequacy.margin, rel=0.05)
    assert "times more exact than needed; mass decides" in verdict.message.text
    assert "requirement-assumed" in [each.code for each in verdict.details]
    assert [each.kind for each in verdict.thresholds] == ["tcp_force"]
    assert verdict.motion == "brisk"


def test_what_is_too_uncertain_is_named_with_what_is_allowed_and_its_interval() -> None:
    """By hand: 5 N of guiding force allow 5 / 9.81 kg, and an interval of 2 kg is wider."""
    verdict = judged(Found(std=STD * [1.0 / 0.003 / 1.96 * 2.0, *[1.0] * 9]), guiding_force_n=5.0, source="the line's manual")
    assert verdict.adequacy is not None
    assert not verdict.adequacy.good_enough
    part = verdict.adequacy.parameter
    assert (part.name, part.unit) == ("m", "kg")
    assert part.error == pytest.approx(5.0 / 9.81, rel=1e-3)
    assert part.half_width == pytest.approx(2.0, rel=1e-6)
    assert "mass may be off by 0.51 kg, its interval is ± 2 kg" in verdict.message.text
    assert not verdict.assumed
    assert "the line's manual" in verdict.details[-1].text


def test_an_inertia_that_is_too_uncertain_is_named_with_its_axis() -> None:
    verdict = judged(Found(std=STD * [*[1.0] * 9, 5000.0]))
    assert verdict.adequacy is not None
    assert verdict.adequacy.parameter.name == "Izz"
    assert verdict.message.say("en").startswith("Not good enough for this cell: inertia about z may be off by")
    assert verdict.message.say("de").startswith("Nicht genau genug für diese Zelle: Trägheit um z")


def test_what_is_too_much_only_together_is_said_so() -> None:
    """By hand: each axis within 0.8 of what is allowed; 2.795 is the 95 % quantile of chi with three degrees of freedom."""
    com_m = 0.005
    std = 0.8 * com_m / 1.96
    covariance = np.diag([1e-8, *[(PHI[0] * std) ** 2] * 3, *[1e-10] * 6])
    found = Found(std=np.sqrt(np.diag(covariance)))
    verdict = judged(found, tcp_force_n=1000.0, com_m=com_m)
    assert verdict.adequacy is not None
    assert verdict.adequacy.used == pytest.approx(0.8 / 1.96 * 2.795, rel=0.02)
    assert verdict.adequacy.parameter.error == pytest.approx(com_m)
    assert verdict.message.code == "requirement-together-not-good-enough"


def test_an_answer_in_which_something_is_not_determined_is_not_judged_and_says_what() -> None:
    found = Found(phi=np.append(PHI[:9], np.nan), determined=[True] * 9 + [False])
    verdict = judged(found, guiding_force_n=5.0)
    assert verdict.adequacy is None
    assert verdict.message.code == "requirement-not-determined"
    assert "Izz" in verdict.message.text


@pytest.mark.parametrize("found", [None, Found(phi=np.append(-0.1, PHI[1:]))], ids=["nothing identified", "a mass below zero"])
def test_without_a_payload_there_is_nothing_to_judge(found: Found | None) -> None:
    verdict = judged(found)
    assert (verdict.adequacy, verdict.allowed) == (None, [])
    assert verdict.message.code == "requirement-no-body"


def test_the_verdict_comes_back_from_json_as_it_was() -> None:
    verdict = judged(Found())
    assert RequirementPart.model_validate_json(verdict.model_dump_json()) == verdict


def test_an_arm_that_crawls_keeps_nobody_waiting() -> None:
    """A thousandth of the speed makes hours of motion, in no more rows."""
    robot = BENCH.robot.model_copy(update={"velocity_rad_s": (0.002,) * 7})
    judge_estimate(BENCH, ROBOT, Found())  # what is loaded and compiled once does not count
    began = time.process_time()
    verdict = judge_estimate(BENCH.model_copy(update={"robot": robot}), ROBOT, Found())
    assert time.process_time() - began < 3.0
    assert verdict.motion_s > 3600.0
