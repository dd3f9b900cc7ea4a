"""What is wanted of an answer, and whether an answer has it: against numbers that were worked out by hand or drawn."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.errors import BadInput
from core.payload.inertia import InertialParameters
from core.payload.uncertain_parameters import UncertainParameters
from core.requirement.target import CellRequirement, Standing, Target, TargetCheck, parse_target
from core.requirement.target_answer import LeftOutPart, hold_against_target
from core.robot.model import RobotModel

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
BLOCK = InertialParameters.from_com(2.0, [0.0, 0.0, 0.05], np.diag([0.003, 0.004, 0.005]))


@dataclass
class Answer:
    """An estimate of the block with independent errors."""

    type_a: np.ndarray
    type_b: np.ndarray = field(default_factory=lambda: np.zeros(10))
    phi: np.ndarray = field(default_factory=BLOCK.phi.copy)

    @property
    def covariance(self) -> np.ndarray:
        return np.diag(self.type_a**2 + self.type_b**2)

    @property
    def repeatability(self) -> UncertainParameters:
        return UncertainParameters(self.phi, np.diag(self.type_a**2))


def stds(**given: float) -> np.ndarray:
    """Small ones, but for those that are given."""
    found = np.full(10, 1e-9)
    for name, value in given.items():
        found[["m", "mx", "my", "mz", "xx", "xy", "xz", "yy", "yz", "zz"].index(name)] = value
    return found


@pytest.mark.parametrize(
    ("text", "target"),
    [
        ("mass=0.1%,inertia=1%", Target(mass_share=0.001, inertia_share=0.01)),
        (" Mass = 2 % , com=0.5mm", Target(mass_share=0.02, centre_of_mass_m=0.0005)),
        ("com=0.002m", Target(centre_of_mass_m=0.002)),
        ("requirement", Target(requirement=True)),
        ("requirement,inertia=.5%", Target(requirement=True, inertia_share=0.005)),
    ],
)
def test_a_target_is_read_as_people_type_it(text, target):
    read, expected = parse_target(text).model_dump(), target.model_dump()
    assert read == pytest.approx(expected)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "mass=0.1%"),
        ("0.1%", "mass=0.1%"),
        ("mass", "mass=0.1%"),
        ("mass=0.1", "mass=0.1%"),
        ("mass=1mm", "mass=0.1%"),
        ("com=1%", "mass=0.1%"),
        ("mass=1%,mass=2%", "mass=0.1%"),
        ("weight=1%", "mass=0.1%"),
        ("mass=-1%", "mass=0.1%"),
        ("mass=0%", "more than nothing"),
        ("inertia=150%", "at most 100 %"),
        ("com=2m", "at most 100 %"),
    ],
)
def test_what_is_no_target_is_refused_with_what_one_looks_like(text, words):
    with pytest.raises(BadInput, match="--target") as refused:
        parse_target(text)
    assert words in str(refused.value)


def test_a_target_names_something_as_soon_as_one_of_its_fields_does():
    assert not Target().names_something
    assert Target(requirement=True).names_something
    assert Target(centre_of_mass_m=0.001).names_something


def test_a_mass_is_known_as_exactly_as_its_whole_interval_says():
    check = TargetCheck(Target(mass_share=0.01))
    answer = Answer(stds(m=0.006), stds(m=0.008))  # together 0.01 kg: +- 0.0196 kg of the 0.02 kg that are allowed
    mass = hold_against_target(check, answer).quantities[0]
    assert (mass.wanted, mass.half_width) == pytest.approx((0.02, 1.96 * 0.01))
    assert (mass.repeatability, mass.systematic) == pytest.approx((1.96 * 0.006, 1.96 * 0.008))
    assert mass.standing == "reached"


def test_the_inertia_is_about_the_centre_of_mass_and_in_the_direction_in_which_it_is_known_least():
    check = TargetCheck(Target(inertia_share=0.01))
    answer = Answer(stds(xx=1e-5, xy=4e-5))
    inertia = hold_against_target(check, answer).quantities[0]
    assert inertia.wanted == pytest.approx(0.01 * np.sqrt(0.003**2 + 0.004**2 + 0.005**2))
    assert inertia.half_width == pytest.approx(1.96 * 4e-5 * np.sqrt(2.0))  # a product stands in the matrix twice


def test_the_centre_of_mass_is_held_against_the_scatter_of_drawn_ones():
    answer = Answer(stds(m=0.01, mx=2e-4, my=1e-4, mz=3e-4))
    com = hold_against_target(TargetCheck(Target(centre_of_mass_m=1e-3)), answer).quantities[0]
    drawn = np.random.default_rng(0).multivariate_normal(answer.phi, answer.covariance, size=200_000)
    scatter = np.cov((drawn[:, 1:4] / drawn[:, :1]).T)
    assert com.half_width == pytest.approx(1.96 * np.sqrt(np.linalg.eigvalsh(scatter)[-1]), rel=0.01)


@pytest.mark.parametrize(
    ("type_a", "type_b", "standing"),
    [
        (0.001, 0.002, Standing.REACHED),
        (0.020, 0.002, Standing.OPEN),
        (0.020, 0.020, Standing.OPEN),  # what repetitions can take away is still worth it
        (0.002, 0.020, Standing.TYPE_B),
    ],
)
def test_type_b_is_what_is_left_where_it_is_above_the_target_and_repetitions_change_nothing(type_a, type_b, standing):
    answer = Answer(stds(m=type_a), stds(m=type_b))
    assert hold_against_target(TargetCheck(Target(mass_share=0.01)), answer).standing == standing.value


def test_as_long_as_repetitions_help_one_quantity_they_are_not_left_out_for_another():
    check = TargetCheck(Target(mass_share=0.001, inertia_share=0.01))
    answer = Answer(stds(xx=1e-3), stds(m=0.05))
    found = hold_against_target(check, answer)
    assert [each.standing for each in found.quantities] == ["type_b", "open"]
    assert found.standing == "open"


def test_what_is_not_determined_is_no_target_met():
    answer = Answer(stds(zz=np.nan))
    answer.phi[9] = np.nan
    found = hold_against_target(TargetCheck(Target(mass_share=0.01, inertia_share=0.5)), answer)
    assert [each.standing for each in found.quantities] == ["reached", "open"]
    assert found.quantities[1].half_width is None
    assert hold_against_target(TargetCheck(Target(mass_share=0.01)), None).standing == "open"


def test_a_rotation_has_told_enough_when_its_own_column_repeats_well_enough_whatever_the_others_do():
    check, alone = TargetCheck(Target(inertia_share=0.01, mass_share=0.01)), np.diag(stds(m=1.0, yy=1.0, zz=1.0, xx=1e-6) ** 2)
    assert check.find_standing_of_turns(BLOCK.phi, alone, "x").standing is Standing.REACHED
    assert check.find_standing_of_turns(BLOCK.phi, alone, "y").standing is Standing.OPEN
    assert check.find_standing_of_turns(BLOCK.phi, alone, "z").standing is Standing.OPEN


def test_the_requirement_is_reached_where_the_verdict_on_the_result_says_good_enough():
    check = TargetCheck(Target(requirement=True), CellRequirement(CELL, RobotModel.of_cell(CELL)))
    fine = hold_against_target(check, Answer(stds(m=0.001)))
    assert fine.standing == "reached"
    coarse = hold_against_target(check, Answer(stds(), stds(m=3.0)))
    assert coarse.standing == "type_b"
    assert coarse.quantities[0].half_width == pytest.approx(3000.0 * fine.quantities[0].half_width, rel=0.05)


def test_without_its_cell_no_requirement_is_reached():
    assert hold_against_target(TargetCheck(Target(requirement=True)), Answer(stds())).standing == "open"


def test_it_is_said_what_a_run_left_out():
    check, answer = TargetCheck(Target(mass_share=0.01)), Answer(stds())
    early = hold_against_target(check, answer, LeftOutPart(made=4, planned=12, repetitions=5, saved_s=21.3))
    assert early.message.say("en") == "Target reached after 4 of 12 motions: the robot went home 21 s sooner."
    fewer = hold_against_target(check, answer, LeftOutPart(made=12, planned=12, repetitions=1, saved_s=0.9))
    assert fewer.message.say("en") == "Target reached with one repetition fewer: 1 s saved."
    assert hold_against_target(check, answer).message.say("de") == "Ziel erreicht."
    worse = hold_against_target(check, Answer(stds(), stds(m=1.0)))
    assert worse.message.say("en").startswith("Target not reached (mass): type B is what is left, more repetitions would not help.")
    assert worse.quantities[0].message.say("en") == ("mass: 9800 % of what the target allows; repeatability alone 0 %, type B alone 9800 %")
