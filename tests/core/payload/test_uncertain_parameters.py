"""Another frame and another point change the numbers and carry their covariance along; the oracle is Pinocchio."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest
from scipy.spatial.transform import Rotation

from core.array import Array
from core.cell.folder import find_cell, load_cell
from core.payload.uncertain_parameters import UncertainParameters
from tests.core.export.cloud import cloud, covariance

PIN = [0, 1, 2, 3, 4, 5, 7, 6, 8, 9]


def by_pinocchio(phi: Array, rotation: Array, translation: Array) -> Array:
    """Parameters (10,) in another frame."""
    body = pin.Inertia.FromDynamicParameters(phi[PIN]).se3Action(pin.SE3(rotation, translation))
    return np.array(body.toDynamicParameters())[PIN]


def about_com(phi: Array) -> Array:
    """[com, inertia about it] (9,)."""
    body = pin.Inertia.FromDynamicParameters(phi[PIN])
    return np.array([*body.lever, *body.inertia[[0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]]])


def differences(function, phi: Array) -> Array:
    """Jacobian by central differences."""
    steps = 1e-6 * np.eye(10)
    return np.column_stack([(function(phi + step) - function(phi - step)) / 2e-6 for step in steps])


@pytest.fixture(params=range(4))
def case(request) -> tuple[UncertainParameters, Array, Array]:
    rng = np.random.default_rng(request.param)
    return cloud(request.param).parameters(covariance(request.param)), Rotation.random(rng=rng).as_matrix(), rng.normal(0.0, 0.2, 3)


def test_another_frame_moves_the_parameters_and_their_covariance(case):
    sensor, rotation, translation = case
    flange = sensor.in_frame(rotation, translation)
    np.testing.assert_allclose(flange.phi, by_pinocchio(sensor.phi, rotation, translation), atol=1e-12)
    J = differences(lambda phi: by_pinocchio(phi, rotation, translation), sensor.phi)
    np.testing.assert_allclose(flange.covariance, J @ sensor.covariance @ J.T, rtol=1e-5, atol=1e-13)


def test_the_centre_of_mass_and_the_inertia_about_it_have_the_uncertainty_that_differences_give(case):
    sensor, rotation, translation = case
    flange = sensor.in_frame(rotation, translation)
    J = differences(about_com, flange.phi)
    expected = np.sqrt(np.diag(J @ flange.covariance @ J.T))
    np.testing.assert_allclose([*flange.com_m, *flange.inertia_com], about_com(flange.phi), atol=1e-12)
    np.testing.assert_allclose([*flange.com_std, *flange.inertia_com_std], expected, rtol=1e-4)


def test_turning_without_unknowns_leaves_the_size_of_the_uncertainty_of_the_mass(case):
    sensor, rotation, translation = case
    assert sensor.in_frame(rotation, translation).std[0] == pytest.approx(sensor.std[0])


def test_what_mixes_with_an_unknown_is_unknown_and_nothing_else():
    known = cloud(0).parameters(covariance(0))
    phi, S = known.phi.copy(), known.covariance.copy()
    phi[9], S[9, :], S[:, 9] = np.nan, np.nan, np.nan
    turned = UncertainParameters(phi, S).in_frame(Rotation.from_euler("z", 0.7).as_matrix(), [0.0, 0.0, 0.02])
    assert np.flatnonzero(np.isnan(turned.phi)).tolist() == [9]
    assert np.flatnonzero(np.isnan(turned.std)).tolist() == [9]


@pytest.mark.parametrize("name", ["lwr4_bench", "ur5e_line"])
def test_the_cells_say_how_their_sensor_is_mounted(name):
    mount = load_cell(find_cell(name)).sensor.mount
    assert mount is not None
    assert 0.0 < mount.translation[2] < 0.05


def test_what_scales_everything_alike_leaves_the_centre_of_mass_without_a_deviation() -> None:
    """Its variance is zero but for rounding, on either side of zero."""
    for seed in range(20):
        phi = np.abs(np.random.default_rng(seed).normal(1.0, 0.3, 10))
        assert UncertainParameters(phi, np.outer(0.01 * phi, 0.01 * phi)).com_std == pytest.approx(np.zeros(3), abs=1e-8)
