"""Every sentence of a refusal, a stop or a reason has German words, and the console finds them for what the engine really says."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace

import numpy as np
import pytest
from playwright.sync_api import Browser, expect

from core.cell.cell import Box, Pose
from core.cell.folder import list_cell_folders, load_cell
from core.control.checks import GuardStop, Numbers
from core.control.faults import make_distance_error, make_frozen_error, make_stop_error
from core.errors import BadCell, Lateness, NoStartConfiguration, PlanDisputed
from core.planning.rotation_room import Obstruction
from core.robot.model import RobotModel
from core.robot.pair_group import Nearest
from core.second_opinion.arm import build_solid_arm
from core.second_opinion.opinion import Approach, Opinion, PeakSpeed
from core.second_opinion.pairs import OVERLAP, PairKind, classify_pairs
from core.second_opinion.refusal import refuse_disputed
from core.sessions.leased import _LATE, _sentence
from server.http.errors import Conflict, NotFound
from server.http.problem_answers import NEXT_STEPS
from server.jobs.jobs import JobStatus
from server.jobs.kinds import ADDITION, DIAGNOSIS, TRIALS
from tests.server.hostile_uploads import CELL
from tests.server.real_service import Console, RealService
from tests.web.engine_phrases import HOLE, of_refusals
from tests.web.german_words import german
from tests.web.screens import show, signed_in

IN_HOLES = {
    "joint {}", "payload", "start", "goal", "transfer {}", "rotation {}", "wave {}", "home",
    "unreachable {}", "too close to {}", "{} too close to {}",
    "a released load would fly into zone {}", "{} too weak to hold the load",
    "no room for the rotation: {}", *(f"{each} {HOLE}" for each in Obstruction),
    "{} There is a plan for the other sensor axes: --axes {}.",
    "{} ms (limit {} ms)", *_LATE.values(), *JobStatus, ADDITION, DIAGNOSIS, TRIALS,
    *(f"{HOLE}: {step}" for _, step in NEXT_STEPS.values()),
}  # fmt: skip
"""What sentences name in words, made elsewhere than the sentence."""
MIXED_UNITS = {"{} of {} is {} N (range {} N m)", "{} of {} is {} N m (range {} N)"}
"""Of a choice that is made once for both places."""
ENGLISH = {"the", "is", "stopped", "robot", "limit", "again", "and", "from", "close", "found", "expected"}
CLOSE = Nearest(0.021, 0.03, "payload", "operator", np.zeros(3), np.zeros(3))


def engine_sentences() -> list[str]:
    """As the engine makes them: every fault of the guard, each kind of thing that it can be too close to, refusals with their reasons."""
    cell = load_cell(CELL)
    robot = RobotModel.of_cell(cell)
    limits = (robot.lower, robot.upper, robot.velocity, np.ones(robot.n))
    numbers = Numbers(0.001, 0.01, 0.25, 1.0, 0.01, 0.05, 0.1, *limits, np.ones(6), np.ones(robot.n))
    found: list[Exception | str] = [
        make_stop_error(fault, 1, 0.4321, cell=cell, robot=robot, owner="payload", numbers=numbers, samples=())
        for fault in GuardStop
        if fault != GuardStop.NONE
    ]
    near = [replace(CLOSE, second=second) for second in ("operator", "bench", "link3")]
    found += [make_distance_error(each, cell, predicted=predicted, samples=()) for each in near for predicted in (False, True)]
    near_end = Approach(PairKind.ENVIRONMENT, "payload", "bench", 0.025, 0.03, "transfer x+", 1.25)
    fastest = PeakSpeed(0.2575, 0.25, "payload", "home", 0.5)
    for opinion in (Opinion((near_end,), fastest, (), 100), Opinion((), fastest, (), 100)):
        with pytest.raises(PlanDisputed) as disputed:
            refuse_disputed(opinion)
        found.append(disputed.value)
    reasons = {"unreachable": 30, "too close to 'bench'": 12, "'link5' too close to 'bench'": 2, f"{Obstruction.JOINT_LIMIT}": 1}
    found += [
        make_frozen_error(0.3, 0.25, ()),
        NoStartConfiguration("x+", reasons, 0.012, "bench"),
        NoStartConfiguration("x+", {}),
        NotFound("run", "x7"),
        Conflict(f"{DIAGNOSIS} x7: it is {JobStatus.done}; only what waits or runs can be cancelled"),
        *(_sentence(Lateness(cause=cause, late_s=1.2, limit_s=1.0)) for cause in _LATE),
        BadCell("cell.toml: limits.clearance_m", "-0.1", "greater than 0"),
    ]
    return [str(each) for each in found]


def test_the_german_sentences_are_those_that_can_be_said() -> None:
    assert set(german("sentences")) == (of_refusals() | IN_HOLES) - MIXED_UNITS - set(german("flaws"))


def test_every_reason_for_asking_nothing_of_a_pair_has_german_words() -> None:
    """Of the cells at hand, with payloads from a plate to a bracket that reaches back beside the wrist."""
    said: set[str] = set()
    for cell in map(load_cell, list_cell_folders()):
        for size, place in (((0.1, 0.1, 0.02), 0.01), ((0.3, 0.3, 0.3), -0.1)):
            box = Box(size_m=size, pose=Pose(xyz_m=(0.0, 0.0, place)))
            said |= {pair.why for pair in classify_pairs(cell, build_solid_arm(cell, box)) if not pair.kind.is_judged}
    assert {re.sub(r"-?\d+\.\d+", HOLE, why) for why in said} | {OVERLAP} == set(german("left-out"))


def told_in_german(service: RealService, browser: Browser, sentences: list[str]) -> list[str]:
    """What the console's history shows as the reasons of runs that ended with these sentences."""
    person = Console(service)
    ended = person.run(person.queue(seed=7))
    person.http.post(f"/api/runs/{ended['run']}/commands", json={"command": "stop"})
    person.leave()
    reasons = {"result": None, "reason_kind": "too-close"}
    answer = [ended | reasons | {"run": f"{k}", "reason": sentence} for k, sentence in enumerate(sentences)]
    with signed_in(service, browser) as at:
        at.page.route("**/api/runs?*", lambda route: route.fulfill(json=answer))
        at.page.evaluate("localStorage.setItem('heft.language', 'de')")
        at.page.reload()
        show(at, "history")
        exact = at.page.locator(".run-list .told small")
        expect(exact).to_have_count(len(sentences))
        assert exact.locator("[lang=en]").all_inner_texts() == []
        return exact.all_inner_texts()


def filled(phrase: str, names: Iterable[str]) -> str:
    parts = phrase.split(HOLE)
    return parts[0] + "".join(name + part for name, part in zip(names, parts[1:], strict=False))


def test_the_console_finds_the_words_of_every_phrase(service: RealService, browser: Browser) -> None:
    words = german("flaws") | german("sentences")
    named = [f"'x{k}'" for k in range(12)]
    told = told_in_german(service, browser, [filled(english, named) for english in words])
    assert dict(zip(words, told, strict=True)) == {english: filled(said, named) for english, said in words.items()}


def test_what_the_guard_and_the_planner_say_is_german_to_the_last_word(service: RealService, browser: Browser) -> None:
    told = told_in_german(service, browser, engine_sentences())
    assert [text for text in told if ENGLISH & set(re.findall(r"[A-Za-z]+", text))] == []
    assert "Gelenk joint2 steht bei 0,4321 rad" in " ".join(told)
