"""An exported payload says how exactly it is known: in the file where that has a place, and the file is still read as before."""

from __future__ import annotations

import ast
import json
from pathlib import Path

import numpy as np
import pytest

from core.array import Array
from core.cell.folder import load_cell
from core.errors import BadPayload
from core.estimation.budget import ASSUMED, TITLES
from core.estimation.budget_part import BudgetPart, SourcePart
from core.estimation.result import Result
from core.export.exports import TARGETS, payload_of, require_mount, target_of
from core.export.uncertainty import ExportUncertainty, state_uncertainty, uncertainty_of
from core.payload.inertia import InertialParameters
from core.payload.shapes import Pose
from tests.core.export.cloud import cloud, covariance
from tests.core.export.known_result import answer
from tests.core.export.readers import READERS, read_sunrise

CELL = load_cell(Path(__file__).parents[3] / "cells" / "ur5e_line")
MOUNT = require_mount(CELL)
BODY = cloud(2)
HOLD_REMARKS = {"ur": "#", "xarm": "#", "kuka_krl": ";", "abb": "!", "mujoco": "<!--", "urdf": "<!--"}
HOLD_FIELDS = {"franka", "flexiv", "opc_ua"}


def judged(gain: float = 0.01) -> Result:
    """A payload whose repeatability is that of `covariance`, and whose gain may be off by a share of everything."""
    whole = answer(BODY, "ur5e_line")
    assert whole.estimate is not None
    phi = np.array(whole.estimate.phi, dtype=float)
    alone = covariance(0)
    direction = gain * phi
    source = SourcePart(
        name="sensor_gain", title=TITLES["sensor_gain"], stated=False, std=direction.tolist(), com_std_m=[0.0] * 3,
        inertia_com_std_kg_m2=[0.0] * 6, directions=[direction.tolist()],
    )  # fmt: skip
    budget = BudgetPart(
        repeatability=alone.tolist(), repeatability_std=np.sqrt(np.diag(alone)).tolist(), repeatability_com_std_m=[0.0] * 3,
        repeatability_inertia_com_std_kg_m2=[0.0] * 6, sources=[source], largest=["sensor_gain"] * 10, assumptions=[ASSUMED["sensor_gain"]],
    )  # fmt: skip
    total = alone + np.outer(direction, direction)
    estimate = whole.estimate.model_copy(update={"covariance": total.tolist(), "std": np.sqrt(np.diag(total)).tolist(), "budget": budget})
    return whole.model_copy(update={"estimate": estimate})


def rendered(name: str, result: Result, mount: Pose = MOUNT) -> tuple[str, ExportUncertainty]:
    known = uncertainty_of(result, mount)
    return target_of(name).render_file(payload_of(result, mount), known), known


def drawn(spread: Array) -> Array:
    """(K, 10), mass, centre of mass and inertia about it of bodies at the flange, drawn at the sensor."""
    estimate = judged().estimate
    assert estimate is not None
    found = []
    for row in np.random.default_rng(3).multivariate_normal(np.array(estimate.phi, dtype=float), spread, size=3000):
        body = InertialParameters(row).to_frame(MOUNT.rotation, MOUNT.translation)
        found.append([body.mass, *body.com, *body.inertia_com[np.triu_indices(3)]])
    return np.array(found)


def test_the_half_widths_are_those_of_bodies_drawn_at_the_sensor_and_seen_at_the_flange() -> None:
    result = judged()
    assert result.estimate is not None
    known = uncertainty_of(result, MOUNT)
    whole = 1.96 * drawn(np.array(result.estimate.covariance, dtype=float)).std(axis=0)
    repeats = 1.96 * drawn(covariance(0)).std(axis=0)
    stated = [known.mass_half_width_kg, *known.com_half_width_m, *known.inertia_com_half_width_kg_m2]
    alone = [known.mass_repeatability_kg, *known.com_repeatability_m, *known.inertia_com_repeatability_kg_m2]
    np.testing.assert_allclose(np.array(stated, dtype=float), whole, rtol=0.06)
    np.testing.assert_allclose(np.array(alone, dtype=float), repeats, rtol=0.06)
    assert known.frame == "flange"


def test_a_gain_decides_the_mass_and_leaves_the_centre_of_mass_to_the_repeatability() -> None:
    """What scales everything alike moves no centre of mass, seen from the sensor."""
    known = uncertainty_of(judged(), Pose())
    assert (known.largest["mass"], known.largest["centre_of_mass"]) == ("sensor_gain", "repeatability")
    assert (known.assumed, known.repeatability_only, known.frame) == (["sensor_gain"], False, "flange")


@pytest.mark.parametrize("name", READERS)
def test_a_file_that_states_its_uncertainty_is_read_as_one_that_does_not(name: str) -> None:
    result = judged()
    text, _ = rendered(name, result)
    plain = target_of(name).render_file(payload_of(result, MOUNT))
    assert text != plain
    for one, other in zip(READERS[name](text), READERS[name](plain), strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("name", HOLD_REMARKS)
def test_remarks_state_interval_repeatability_what_contributes_most_and_what_is_assumed(name: str) -> None:
    text, known = rendered(name, judged())
    assert text.isascii()
    assert target_of(name).holds_uncertainty
    plain = target_of(name).render_file(payload_of(judged(), MOUNT))
    remarks = [line for line in text.splitlines() if line not in plain.splitlines()]
    assert all(line.startswith(HOLD_REMARKS[name]) for line in remarks)
    said = "\n".join(remarks)
    assert f"mass +- {known.mass_half_width_kg:.2g} kg; repeats within +- {known.mass_repeatability_kg:.2g} kg; mostly sensor gain" in said
    assert all(f"{1e3 * value:.2g} mm" in said for value in known.com_half_width_m if value is not None)
    assert all(f"{value:.2g} kg m2".replace("e-0", "e-") in said for value in known.inertia_com_half_width_kg_m2 if value is not None)
    assert "assumed, because nobody has stated it: sensor gain" in said
    assert "along the axes of the flange" in said


@pytest.mark.parametrize("name", sorted(HOLD_FIELDS))
def test_an_object_states_it_in_a_field_of_its_own_beside_those_of_the_target(name: str) -> None:
    text, known = rendered(name, judged())
    written = json.loads(text)
    assert ExportUncertainty.model_validate(written.pop("heft_uncertainty")) == known
    assert written == json.loads(target_of(name).render_file(payload_of(judged(), MOUNT)))


def test_xarm_stays_python_that_calls_with_the_same_numbers() -> None:
    text, _ = rendered("xarm", judged())
    plain = target_of("xarm").render_file(payload_of(judged(), MOUNT))
    assert ast.dump(ast.parse(text)) == ast.dump(ast.parse(plain))


def test_values_to_be_typed_in_stay_values_alone() -> None:
    text, _ = rendered("kuka_sunrise", judged())
    assert not target_of("kuka_sunrise").holds_uncertainty
    assert text == target_of("kuka_sunrise").render_file(payload_of(judged(), MOUNT))
    assert read_sunrise(text)[0] == pytest.approx(BODY.masses.sum())


def test_every_target_is_looked_at_here() -> None:
    assert {target.name for target in TARGETS} == {*HOLD_REMARKS, *HOLD_FIELDS, "kuka_sunrise"}


def test_a_result_of_an_earlier_version_is_said_to_know_the_repeatability_alone() -> None:
    known = uncertainty_of(answer(BODY, "ur5e_line"), MOUNT)
    assert known.repeatability_only
    assert known.mass_half_width_kg == known.mass_repeatability_kg
    assert "repeatability alone" in state_uncertainty(known)[-1].text


def test_what_is_not_determined_is_left_out() -> None:
    whole = judged().estimate
    assert whole is not None
    phi = [*whole.phi[:4], *[None] * 6]
    spread = [[value if i < 4 and j < 4 else None for j, value in enumerate(row)] for i, row in enumerate(whole.covariance)]
    static = judged().model_copy(update={"estimate": whole.model_copy(update={"phi": phi, "covariance": spread})})
    text, known = rendered("xarm", static)
    assert known.inertia_com_half_width_kg_m2 == [None] * 6
    assert "inertia" not in known.largest
    assert "Ixx" not in text


def test_where_nothing_was_identified_there_is_nothing_to_state() -> None:
    with pytest.raises(BadPayload, match="nothing that was identified"):
        uncertainty_of(judged().model_copy(update={"estimate": None}), MOUNT)


def test_german_has_no_list_of_numbers_that_looks_like_one_number() -> None:
    said = [line.say("de") for line in state_uncertainty(uncertainty_of(judged(), MOUNT))]
    assert said[0] == "Halbe Breiten der 95-%-Intervalle, entlang der Achsen des Flansches:"
    assert " mm, " in said[2]
