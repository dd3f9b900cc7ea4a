"""What is exported is the body that was identified: read back with the rules of each target, and by MuJoCo and Pinocchio themselves."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.errors import BadInput, BadPayload
from core.export.exports import TARGETS, payload_of, require_mount, target_of
from core.payload.shapes import Pose
from core.payload.uncertain_parameters import UncertainParameters
from tests.core.export.cloud import cloud, covariance
from tests.core.export.known_result import answer
from tests.core.export.readers import PARTLY, READERS, read_sunrise, read_xarm

CELLS = Path(__file__).parents[3] / "cells"
MOUNTS = [Pose(xyz_m=(0.012, -0.034, 0.051), rpy_rad=(0.3, -1.1, 2.4)), Pose(xyz_m=(0.0, 0.0, 0.03), rpy_rad=(np.pi, 0.0, np.pi / 4))]
"""A sensor that sits crooked, and one that hangs upside down."""


def test_every_target_is_read_back_here():
    assert {target.name for target in TARGETS} == {*READERS, *PARTLY}


@pytest.mark.parametrize("name", [*READERS, *PARTLY])
@pytest.mark.parametrize("mount", MOUNTS)
def test_a_body_that_a_crooked_sensor_saw_is_written_along_the_axes_of_the_flange(name: str, mount: Pose):
    at_sensor, at_flange = cloud(7), cloud(7).moved(mount.rotation, mount.translation)
    text = target_of(name).render_file(payload_of(answer(at_sensor, None), mount))
    m, com, inertia = {**READERS, **PARTLY}[name](text)
    truth = at_flange.inertia(at_flange.com)
    assert m == pytest.approx(at_flange.masses.sum(), rel=1e-7)
    np.testing.assert_allclose(com, at_flange.com, atol=1e-8)
    held = np.isfinite(inertia)
    assert held.sum() == {"kuka_sunrise": 3, "xarm": 0}.get(name, 9)
    np.testing.assert_allclose(inertia[held], truth[held], atol=1e-6 * np.trace(truth))


def test_nothing_is_written_in_the_sensors_axes():
    with pytest.raises(BadInput, match="belongs to no cell"):
        require_mount(None)
    cell = load_cell(CELLS / "ur5e_line")
    assert require_mount(cell) == cell.sensor.mount
    unsaid = cell.model_copy(update={"sensor": cell.sensor.model_copy(update={"mount": None})})
    assert isinstance(unsaid, Cell)
    with pytest.raises(BadInput, match=r"'ur5e_line' does not say how the sensor sits on the flange.*sensor\.mount\.xyz_m"):
        require_mount(unsaid)


@pytest.mark.parametrize("name", READERS)
@pytest.mark.parametrize("seed", range(6))
def test_what_is_read_back_is_the_body(name: str, seed: int):
    body = cloud(seed)
    target = target_of(name)
    m, com, inertia = READERS[name](target.render_file(body.parameters(covariance(seed))))
    truth = body.inertia(body.com)
    assert m == pytest.approx(body.masses.sum(), rel=1e-7)
    np.testing.assert_allclose(com, body.com, atol=1e-8)
    np.testing.assert_allclose(inertia, truth, atol=1e-6 * np.trace(truth))
    assert list(target.lacks(body.parameters(covariance(seed)))) == []


def test_sunrise_drops_the_products_and_says_how_large_they_are_against_their_uncertainty():
    body = cloud(1)
    parameters = body.parameters(covariance(1))
    target = target_of("kuka_sunrise")
    m, com, inertia = read_sunrise(target.render_file(parameters))
    truth = body.inertia(body.com)
    assert m == pytest.approx(body.masses.sum())
    np.testing.assert_allclose(com, body.com, atol=1e-8)
    np.testing.assert_allclose(np.diag(inertia), np.diag(truth), rtol=1e-6)
    lacks = {lack.name: lack for lack in target.lacks(parameters)}
    assert {name: lack.value for name, lack in lacks.items()} == pytest.approx({"Ixy": truth[0, 1], "Ixz": truth[0, 2], "Iyz": truth[1, 2]})
    assert all(lack.times_std == pytest.approx(abs(lack.value) / lack.std) for lack in lacks.values())


def test_xarm_takes_no_inertia_and_needs_none():
    body = cloud(2)
    known = body.parameters(covariance(2))
    phi, S = known.phi.copy(), known.covariance.copy()
    phi[4:], S[4:, :], S[:, 4:] = np.nan, np.nan, np.nan
    static = UncertainParameters(phi, S)
    target = target_of("xarm")
    m, com, _ = read_xarm(target.render_file(static))
    np.testing.assert_allclose([m, *com], [body.masses.sum(), *body.com], rtol=1e-8)
    assert list(target.lacks(static)) == []
    assert len(list(target.lacks(known))) == 6
    with pytest.raises(BadPayload, match="Ixx: found not determined"):
        target_of("mujoco").render_file(static)


def test_universal_robots_takes_no_inertia_beyond_its_limit():
    heavy = cloud(3)
    masses = heavy.masses * 2e4
    with pytest.raises(BadPayload, match="133 kg m2"):
        target_of("ur").render_file(type(heavy)(masses, heavy.points).parameters(covariance(3)))


def test_an_unknown_target_is_refused_with_those_that_there_are():
    with pytest.raises(BadInput, match="one of ur, kuka_krl"):
        target_of("fanuc")


def test_opc_ua_names_its_units_by_their_common_codes():
    load = json.loads(target_of("opc_ua").render_file(cloud(0).parameters(covariance(0))))
    assert load["Mass"]["EngineeringUnits"]["UnitId"] == 4933453
    assert load["CenterOfMass"]["CartesianCoordinates"]["LengthUnit"]["UnitId"] == 5066068
