"""What is wrong or doubtful in a cell is said, once for each thing."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from core.new_cell.findings import CellFinding, findings_of

ROOT = Path(__file__).parents[3]
FRICTION = "friction.coulomb_n_m = [3.52, 3.52, 2.0, 2.0, 2.0, 0.76, 0.76]\nfriction.viscous_n_m_s = [8.8, 8.8, 5.0, 5.0, 5.0, 1.9, 1.9]"
FIXTURE = "size_m = [0.25, 0.25, 0.2], pose.xyz_m = [0.45, -0.6, 0.1]"


@pytest.fixture
def changed(tmp_path: Path) -> Callable[..., list[CellFinding]]:
    """The findings of the shipped bench with texts replaced, in cell.toml or in robot.urdf."""

    def findings(*replaced: tuple[str, str], file: str = "cell.toml") -> list[CellFinding]:
        shutil.copytree(ROOT / "cells/lwr4_bench", tmp_path / "bench")
        target = tmp_path / "bench" / file
        text = target.read_text()
        for old, new in replaced:
            assert old in text
            text = text.replace(old, new)
        target.write_text(text)
        return findings_of(tmp_path / "bench")

    return findings


def keys(found: list[CellFinding], severity: str) -> set[str]:
    return {each.where.rpartition(": ")[2] for each in found if each.severity == severity}


def test_nothing_is_wrong_with_the_shipped_bench_and_its_zone_is_within_reach(changed):
    found = changed()
    assert not keys(found, "wrong")
    assert "zones.operator" in keys(found, "doubtful")
    assert not keys(found, "doubtful") & {"payload_box", "floor_z_m", "gravity_m_s2", "robot.friction", "sensor.mount", "sensor"}


@pytest.mark.parametrize(
    ("old", "new", "key"),
    [
        ("pose.xyz_m = [0.0, 0.0, 0.08]\n\n[[obstacles]]", "pose.xyz_m = [0.0, 0.0, 0.12]\n\n[[obstacles]]", "payload_box"),
        ("size_m = [0.16, 0.16, 0.16]", "size_m = [0.16, 0.55, 0.16]", "payload_box"),
        ("floor_z_m = -0.75", "floor_z_m = -3.0", "floor_z_m"),
        (FRICTION, "", "robot.friction"),
        ("mount.xyz_m = [0.0, 0.0, 0.0157]", "", "sensor.mount"),
        ("range = [145, 145, 290, 5, 5, 5]", "range = [30, 30, 60, 5, 5, 5]", "sensor.range"),
        ("range = [145, 145, 290, 5, 5, 5]", "range = [900, 900, 900, 5, 5, 5]", "sensor.range"),
        ('name = "ATI Mini45"', 'name = "not stated: any"', "sensor"),
        ("cartesian_speed_m_s = 0.25", "cartesian_speed_m_s = 0.9", "limits.cartesian_speed_m_s"),
        ("acceleration_rad_s2 = [15.0", "acceleration_rad_s2 = [150.0", "robot.acceleration_rad_s2"),
    ],
)
def test_each_doubt_is_told_where_it_is(changed, old, new, key):
    found = changed((old, new))
    assert not keys(found, "wrong")
    assert key in keys(found, "doubtful")
    assert all(each.advice and each.found for each in found)


def test_what_cannot_be_planned_in_is_wrong_and_stands_first(changed):
    found = changed(("home_rad = [0.0, -0.35", "home_rad = [0.0, 9.0"))
    assert found[0].severity == "wrong"
    assert "home_rad" in found[0].where


def test_a_home_inside_an_obstacle_is_wrong(changed):
    found = changed((FIXTURE, "size_m = [0.5, 0.5, 2.0], pose.xyz_m = [0.45, 0.0, 0.5]"))
    assert [each.severity for each in found].count("wrong") == 1
    assert "robot.home_rad" in found[0].where


def test_a_joint_too_weak_for_its_own_arm_is_doubtful(changed):
    found = changed(('effort="176"', 'effort="3"'), file="robot.urdf")
    assert any("the arm and its tools may ask" in each.found for each in found)


def test_a_finding_is_said_in_the_language_of_its_reader(changed):
    wrong, *others = changed(("clearance_m = 0.03", "clearance_m = 0.3"), ("cartesian_speed_m_s = 0.25", "cartesian_speed_m_s = 0.9"))
    assert wrong.say("en").startswith("wrong: ")
    assert wrong.say("de").startswith("falsch: ")
    said = [each.say("de") for each in others]
    assert (
        "fraglich: cell.toml: limits.cartesian_speed_m_s: gefunden: 0,9 m/s, erwartet: höchstens 0,5 m/s, wo Menschen in der Nähe sind."
        in said
    )


def test_a_finding_in_json_has_its_code_and_what_it_names(changed):
    found = json.loads(json.dumps([each._asdict() for each in changed(("cartesian_speed_m_s = 0.25", "cartesian_speed_m_s = 0.9"))]))
    [speed] = [each for each in found if each["message"]["code"] == "newcell-speed-high"]
    assert speed["severity"] == "doubtful"
    assert speed["where"] == "cell.toml: limits.cartesian_speed_m_s"
    assert speed["message"]["parameters"] == {"where": speed["where"], "speed_m_s": 0.9, "most_m_s": 0.5}


def test_a_file_that_is_no_cell_is_wrong(changed):
    found = changed(("[robot]", "[robots]"))
    assert {each.severity for each in found} == {"wrong"}
    assert len(found) >= 2  # robot is missing, robots is no key
