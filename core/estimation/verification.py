"""Motions that the fit did not use, predicted from all the others: what the estimate is worth on something new."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.estimation.estimate import Verification
from core.estimation.generalised_least_squares import DELAY, OFFSET, TILT, Fit, fit
from core.estimation.kinematics import Poses
from core.estimation.noise import WrenchNoise
from core.estimation.segments import Segment
from core.estimation.weak_form import WeakForm
from core.payload.inertia import spatial_inertia

FEWEST_WINDOWS = 8
"""A motion with fewer is too short to judge by."""


@dataclass(frozen=True)
class LeaveOneOut:
    """Everything that it takes to leave a motion out.

    Args:
        poses: of all samples.
        wrench: (N, 6), raw, without what the cell's twin adds.
        noise: of one sample.
        segments: the motions.
    """

    poses: Poses
    wrench: Array
    noise: WrenchNoise
    segments: tuple[Segment, ...]

    def verifications(self) -> tuple[Verification, ...]:
        """One for each axis about which the robot rotated."""
        phases = dict.fromkeys(segment.phase for segment in self.segments if segment.phase.startswith("rotate"))
        found = (self._without(phase) for phase in phases)
        return tuple(each for each in found if each is not None)

    def _without(self, phase: str) -> Verification | None:
        left_out = np.zeros(len(self.wrench), dtype=bool)
        for segment in self.segments:
            left_out[segment.rows] |= segment.phase == phase
        rest, motion = WeakForm(self.poses, within=~left_out), WeakForm(self.poses, within=left_out)
        if min(len(rest), len(motion)) < FEWEST_WINDOWS:
            return None
        found = fit(rest, self.wrench, self.noise)
        predicted, uncertainty = prediction(motion, found)
        noise = estimate_window_variance(motion, found)
        return Verification(
            phase=phase,
            windows=len(motion),
            rms=np.sqrt(np.mean((motion.average(self.wrench) - predicted) ** 2, axis=0)),
            noise=np.sqrt(noise),
            expected=np.sqrt(noise + uncertainty.mean(axis=0)),
        )


def prediction(form: WeakForm, found: Fit) -> tuple[Array, Array]:
    """The wrench (K, 6) in the windows of other motions, and the variance (K, 6) that the fit's uncertainty gives it."""
    features, rate = form.features(float(found.x[DELAY]))
    V = features.regressor(found.x[TILT])
    tilt, late = features.tilt_columns(found.phi, found.x[TILT]), rate.regressor(found.x[TILT]) @ found.phi
    constant = np.broadcast_to(np.eye(6), (len(form), 6, 6))
    J = np.concatenate((V, tilt, late[..., None], constant), axis=2)
    drift = np.column_stack([np.interp(form.centres, found.centres, found.drift[:, c]) for c in range(6)])
    return V @ found.phi + found.x[OFFSET] + drift, np.einsum("kci,ij,kcj->kc", J, found.covariance, J)


def estimate_window_variance(form: WeakForm, found: Fit) -> Array:
    """(6,), mean variance of a window by the noise of the sensor and, through the payload, of the kinematics."""
    wrench_gram, pose_gram = form.gram
    M = spatial_inertia(found.phi)
    kinematic = np.diag(M @ form.poses.noise @ M.T)
    return np.asarray(found.noise.variance * wrench_gram[0].mean() + kinematic * pose_gram[0].mean())
