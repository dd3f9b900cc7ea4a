"""The least squares on the weak form: its uncertainty against the scatter over seeds, its mean against the truth.

The payload is four point masses; their accelerations are differences of a rotation that is known in closed form.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.signal import lfilter
from scipy.spatial.transform import Rotation

from core.estimation.generalised_least_squares import fit
from core.estimation.identification import identify_recording
from core.estimation.kinematics import Poses
from core.estimation.noise import WrenchNoise
from core.estimation.weak_form import WeakForm
from core.recording.recording import Recording

GRAVITY = np.array([0.0, 0.0, -9.81])
MASSES = np.array([0.5, 0.3, 0.4, 0.6])
PLACES = np.array([[0.05, 0.0, 0.1], [-0.04, 0.06, 0.02], [0.0, -0.07, 0.05], [0.02, 0.03, 0.12]])
STD = np.repeat([0.05, 0.003], 3)
MOMENTS = [4, 7, 9]


def true_phi() -> np.ndarray:
    inertia = sum(m * (r @ r * np.eye(3) - np.outer(r, r)) for m, r in zip(MASSES, PLACES, strict=True))
    return np.concatenate(([MASSES.sum()], MASSES @ PLACES, np.asarray(inertia)[np.triu_indices(3)]))


def attitude(t: np.ndarray, pace: float) -> np.ndarray:
    """(N, 3, 3), swinging about all three axes with about `pace` rad/s."""
    angles = (1.1 * np.sin(pace * t), 0.9 * np.sin(1.3 * pace * t + 1.0), 0.8 * np.sin(0.7 * pace * t + 2.0))
    return np.asarray(Rotation.from_rotvec(np.column_stack(angles)).as_matrix())


@cache
def swinging(period: float, lasts_s: float, pace: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times (N,), attitudes (N, 3, 3) about a sensor origin at rest, and the wrench (N, 6) that carries the point masses."""
    t, h = period * np.arange(round(lasts_s / period)), 1e-4
    R = attitude(t, pace)
    second = (attitude(t + h, pace) - 2.0 * R + attitude(t - h, pace)) / h**2
    wrench = np.zeros((len(t), 6))
    for mass, place in zip(MASSES, PLACES, strict=True):
        force = mass * np.einsum("nji,nj->ni", R, second @ place - GRAVITY)
        wrench += np.hstack((force, np.cross(place, force)))
    return t, R, wrench


@pytest.mark.parametrize("measured", [True, False])
def test_noise_that_lasts_longer_than_a_window_widens_the_uncertainty_to_the_scatter(measured: bool) -> None:
    """It keeps 0.98 from sample to sample, and the fit is told that it is white and does not walk: residuals have to say that it is not.

    Without the widening the parameters are off by ten of the standard uncertainties stated, with the residuals' size alone by three.
    """
    t, R, wrench = swinging(0.002, 10.0, 1.5)
    form = WeakForm(Poses(t, R, np.zeros((len(t), 3)), GRAVITY, np.zeros((6, 6))))
    z = []
    for seed in range(8):
        fresh = np.random.default_rng(seed).normal(size=wrench.shape) * np.sqrt(1.0 - 0.98**2)
        fresh[0] /= np.sqrt(1.0 - 0.98**2)
        noise = lfilter([1.0], [1.0, -0.98], fresh, axis=0)
        found = fit(form, wrench + STD * noise, WrenchNoise(STD, np.ones(6), measured, np.zeros(6)))
        z.append((found.phi - true_phi()) / np.sqrt(np.diag(found.covariance)[:10]))
    assert 0.6 < np.sqrt(np.mean(np.square(z))) < 1.8


def test_white_noise_asks_for_no_widening_although_neighbouring_windows_share_their_samples() -> None:
    t, R, wrench = swinging(0.002, 10.0, 1.5)
    form = WeakForm(Poses(t, R, np.zeros((len(t), 3)), GRAVITY, np.zeros((6, 6))))
    z = []
    for seed in range(6):
        noise = np.random.default_rng(seed).normal(size=wrench.shape)
        found = fit(form, wrench + STD * noise, WrenchNoise(STD, np.ones(6), True))
        np.testing.assert_array_equal(found.scale, 1.0)
        z.append((found.phi - true_phi()) / np.sqrt(np.diag(found.covariance)[:10]))
    assert 0.7 < np.sqrt(np.mean(np.square(z))) < 1.4


def test_noise_of_the_poses_in_the_regressor_does_not_shrink_the_moments_of_inertia() -> None:
    """With 3e-4 rad on a slow motion the noise makes up much of the regressor: uncompensated, Izz comes out a half too small."""
    std, (t, R, wrench) = 3e-4, swinging(0.001, 6.0, 1.0)
    covariance = np.diag(np.repeat([0.0, std**2], 3))
    moments, z = [], []
    for seed in range(4):
        rng = np.random.default_rng(seed)
        seen = R @ Rotation.from_rotvec(std * rng.normal(size=(len(t), 3))).as_matrix()
        form = WeakForm(Poses(t, seen, np.zeros((len(t), 3)), GRAVITY, covariance))
        found = fit(form, wrench + STD * rng.normal(size=wrench.shape), WrenchNoise(STD, np.ones(6), True))
        moments.append(found.phi[MOMENTS])
        z.append((found.phi - true_phi())[MOMENTS] / np.sqrt(np.diag(found.covariance)[MOMENTS]))
    shrunk = 1.0 - np.mean(moments, axis=0) / true_phi()[MOMENTS]
    assert (shrunk < [0.05, 0.05, 0.2]).all()
    assert np.sqrt(np.mean(np.square(z))) < 2.5


@pytest.mark.parametrize(("step_s", "std_rad", "pace"), [(0.002, 1e-3, 1.0), (0.004, 3e-4, 0.5)])
def test_noisy_orientations_of_a_slow_motion_have_a_covariance_that_can_be_factored(step_s: float, std_rad: float, pace: float) -> None:
    t, R, w = swinging(step_s, 12.0, pace)
    rng = np.random.default_rng(0)
    seen = R @ Rotation.from_rotvec(std_rad * rng.normal(size=(len(t), 3))).as_matrix()
    wrench, position = w + STD * rng.normal(size=w.shape), 1e-4 * rng.normal(size=(len(t), 3))
    found = identify_recording(Recording(t, GRAVITY, wrench=wrench, orientation=seen, position=position)).estimate
    assert found is not None
    assert abs(found.phi[0] - 1.8) < 4.0 * found.std[0]
