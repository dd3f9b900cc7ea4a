"""A recording of attitudes alone, in which the sensor is turned and hardly ever rests: where the place is that it turned about.

Without positions it is not known how the sensor's origin is accelerated, and only what stands still can be used. Somebody who turns a wrist
about one joint has no such rows. Then the origin is taken to stay at one distance from one place at rest, `r` in the sensor's axes, so that
its acceleration is `alpha x r + omega x (omega x r)`; the three numbers are found from the wrench along with the payload, and what they
leave open counts with the repeatability.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from core.array import Array
from core.estimation.determination import find_determined
from core.estimation.estimate import Estimate, Identification
from core.estimation.kinematics import local_derivative, poses_of, smooth_motion
from core.estimation.verdict import verdict_of
from core.payload.inertia import PHI_NAMES, Motion, regressor
from core.payload.rotations import cross
from core.recording.recording import Recording
from core.words.message import Message

WINDOW_S = 0.2
"""Over which wrench and motion are smoothed alike; attitudes of a slower clock have no acceleration in between."""
SPACING_S = 0.1
"""Between two rows: their noise is nearly independent."""
TURNED_RAD = 0.5
"""What is turned by less does not tell the weight from the offset of the sensor."""
FEWEST_ROWS = 10
"""Six readings each: payload, offsets and place are 19 unknowns, and the scatter is found from what they leave."""
PLACE_STD_M = 1.0
"""Prior of each coordinate of the place: it is within an arm's reach."""
PHI_STD = np.concatenate(([30.0], np.full(3, 3.0), np.full(6, 1.0)))
OFFSET_STD = 100.0

Identify = Callable[[Recording], Identification]


@dataclass(frozen=True)
class TurningPlace:
    """Where the sensor was turned about.

    Args:
        r: (3,), from that place to the sensor's origin, sensor axes, m.
        covariance: (3, 3), m2.
    """

    r: Array
    covariance: Array

    @property
    def directions(self) -> Array:
        """(3, 3), one standard deviation along each principal axis of the covariance, a column each."""
        sizes, axes = np.linalg.eigh(self.covariance)
        return np.asarray(axes * np.sqrt(np.maximum(sizes, 0.0)))


def identify_by_turning(recording: Recording, identify: Identify) -> Identification | None:
    """The payload of a recording without positions, by the place that the sensor was turned about.

    Args:
        identify: from a recording with positions to its answer.

    Returns:
        None where that does not help: nothing is turned, or the mass is not determined with it either.
    """
    place = find_turning_place(recording)
    if place is None:
        return None
    answer = identify(_put_at(recording, place.r))
    estimate = answer.estimate
    if estimate is None or not estimate.determined[0]:
        return None
    moved = [identify(_put_at(recording, place.r + way)).estimate for way in place.directions.T]
    changes = np.stack([np.zeros(len(estimate.phi)) if each is None else np.nan_to_num(each.phi - estimate.phi) for each in moved], axis=1)
    widened = _widen(estimate, changes)
    if not widened.determined[0]:
        return None
    said = Message.of("estimation-turned-about", distance_m=float(np.linalg.norm(place.r)), std_m=_distance_std(place))
    return replace(answer, estimate=widened, verdict=verdict_of(widened, static=False), warnings=(said, *answer.warnings))


def find_turning_place(recording: Recording) -> TurningPlace | None:
    """The place, by least squares over smoothed rows: the payload and the offsets are linear for each place (variable projection).

    Returns:
        None where positions are known, rows are poses of their own or too few, or the sensor is hardly turned.
    """
    poses = poses_of(recording)
    if poses is None or recording.wrench is None or poses.position is not None or poses.apart:
        return None
    from scipy.optimize import least_squares  # noqa: PLC0415 - only attitudes without positions wait for an optimiser

    motion, _ = smooth_motion(poses, window_s=WINDOW_S)
    if np.linalg.norm(motion.omega, axis=1).sum() * poses.period < TURNED_RAD:
        return None
    edge = max(1, round(WINDOW_S / poses.period))  # where there is nothing on one side, an acceleration is worth little
    rows = slice(edge, -edge, max(1, round(SPACING_S / poses.period)))
    seen = motion[rows]
    if len(seen) < FEWEST_ROWS:
        return None
    measured = local_derivative(recording.wrench, 0, poses.t, window_s=WINDOW_S)[rows]
    sigma = measured.std(axis=0) + 1e-9
    for _ in range(3):  # the scatter of each channel about the model, which is its weight
        found = least_squares(_residuals, np.zeros(3), args=(seen, measured, sigma), method="lm")
        left = found.fun[: measured.size].reshape(measured.shape) * sigma
        sigma = np.sqrt((left**2).sum(axis=0) / max(len(left) - 4, 1)) + 1e-9
    found = least_squares(_residuals, np.zeros(3), args=(seen, measured, sigma), method="lm")
    jacobian = np.asarray(found.jac)
    return TurningPlace(found.x, _count_alike(left / sigma) * np.linalg.inv(jacobian.T @ jacobian))


def _count_alike(left: Array) -> float:
    """How many neighbouring rows of what is left over (N, 6), in units of its scatter, say the same: as in an AR(1)."""
    lag = float(np.clip((left[1:] * left[:-1]).mean(), 0.0, 0.95))
    return (1.0 + lag) / (1.0 - lag)


def _residuals(r: Array, motion: Motion, measured: Array, sigma: Array) -> Array:
    """What a place leaves of the measured wrench (N, 6) with the payload and the offsets that fit it best, and the priors."""
    V = regressor(replace(motion, a=_acceleration(motion, r)))
    constant = np.broadcast_to(np.eye(6), (len(V), 6, 6))
    X = (np.concatenate((V, constant), axis=2) / sigma[:, None]).reshape(-1, 16)
    prior = np.diag(1.0 / np.concatenate((PHI_STD, np.full(6, OFFSET_STD))))
    A, b = np.vstack((X, prior)), np.concatenate(((measured / sigma).ravel(), np.zeros(16)))
    return np.concatenate((b - A @ np.linalg.lstsq(A, b, rcond=None)[0], r / PLACE_STD_M))


def _acceleration(motion: Motion, r: Array) -> Array:
    """(N, 3), of the sensor's origin, sensor axes."""
    return np.asarray(cross(motion.alpha, r) + cross(motion.omega, cross(motion.omega, r)))


def _put_at(recording: Recording, r: Array) -> Recording:
    """The recording with positions as if the sensor were turned about the origin of the base frame."""
    assert recording.orientation is not None  # `find_turning_place` has found how it turned
    return replace(recording, position=recording.orientation @ r)


def _widen(estimate: Estimate, changes: Array) -> Estimate:
    """With what the place (10, 3) leaves open; parameters that are no longer determined are taken out."""
    beside = changes @ changes.T
    budget = replace(estimate.budget, repeatability=estimate.budget.repeatability + beside)
    known = estimate.determined & find_determined(np.nan_to_num(estimate.phi), np.sqrt(np.diag(budget.repeatability)))
    lost = estimate.determined & ~known
    reasons = {name: Message.of("estimation-place-uncertain") for name, gone in zip(PHI_NAMES, lost, strict=True) if gone}
    phi, covariance = estimate.phi.copy(), estimate.covariance + beside
    phi[lost] = np.nan
    covariance[lost, :] = np.nan
    covariance[:, lost] = np.nan
    return replace(estimate, phi=phi, covariance=covariance, budget=budget, determined=known, reasons={**estimate.reasons, **reasons})


def _distance_std(place: TurningPlace) -> float:
    """Of the distance along the direction in which the place is, m."""
    direction = place.r / max(float(np.linalg.norm(place.r)), 1e-9)
    return float(np.sqrt(direction @ place.covariance @ direction))
