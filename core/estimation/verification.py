"""Motions that the fit did not use, predicted from all the others: what the estimate is worth on something new."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.estimation.drift import variance_between
from core.estimation.estimate import Verification
from core.estimation.fit import DELAY, OFFSET, TILT, Fit
from core.estimation.generalised_least_squares import fit_like
from core.estimation.kinematics import Poses
from core.estimation.nuisances import NuisanceColumns
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
        whole: the fit to all motions, whose weights are taken.
        segments: the motions.
    """

    poses: Poses
    wrench: Array
    whole: Fit
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
        found = fit_like(rest, self.wrench, self.whole)
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
    tilt, delay = found.x[TILT], float(found.x[DELAY])
    features, rate = form.features(delay)
    if found.nuisances is not None:
        mounting = found.nuisances.mounting(found.b)
        features, rate = features.turn(mounting), rate.turn(mounting)
    V = features.regressor(tilt)
    late = rate.regressor(tilt) @ found.phi
    constant = np.broadcast_to(np.eye(6), (len(form), 6, 6))
    beside, others = np.zeros((len(form), 6, 0)), found.b.copy()
    if found.nuisances is not None:
        beside = NuisanceColumns(form, found.nuisances).dense(features, found.phi, tilt, delay)
        # the features are turned already
        others[found.nuisances.mount] = 0.0
    J = np.concatenate((V, features.tilt_columns(found.phi, tilt), late[..., None], constant, beside), axis=2)
    drift, of_trend = found.drift_at(form.centres)
    white, flicker, walk = found.sizes[:, 0], found.sizes[:, 1:3], found.sizes[:, 3]
    drifted = of_trend + variance_between(flicker, walk, white * form.poses.period, form.centres, found.centres, form.spacing)
    uncertainty = np.einsum("kci,ij,kcj->kc", J, found.covariance, J, optimize=True) + drifted
    return V @ found.phi + found.x[OFFSET] + drift + beside @ others, uncertainty


def estimate_window_variance(form: WeakForm, found: Fit) -> Array:
    """(6,), mean variance of a window by the noise of the sensor and, through the payload, of the kinematics."""
    wrench_gram, pose_gram = form.gram
    M = spatial_inertia(found.phi)
    kinematic = np.array([pose_gram.find_variance_through(row)[0].mean() for row in M])
    return np.asarray(found.sizes[:, 0] * wrench_gram[0].mean() + kinematic)
