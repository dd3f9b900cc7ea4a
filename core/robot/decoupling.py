"""The decoupling motion of the paper (section 3 and 4): opposed trapezoids of angular velocity about one sensor axis.

About an axis along gravity, through the sensor origin, `tau = I dw` holds exactly for that axis (Eq. 4), so only the
samples with
angular acceleration tell something about the inertia: they are what the number of repetitions is chosen for.
"""

from __future__ import annotations

import math

import numpy as np

from core.cell.cell import Box
from core.robot.trajectory import AngularProfile

ACCELERATION = 4.8
"""Angular acceleration of the paper's experiments, rad/s2."""

SPEED_MARGIN = 0.95
"""Share of the Cartesian speed limit that the profile uses; the rest is for the robot's tracking."""


def rate_limit(box: Box, cartesian_speed: float) -> float:
    """Largest angular speed of a rotation through the sensor origin at which no corner of the payload box is too fast,
    rad/s.

    The ratio of section 4: Cartesian limit (m/s) to the distance of the extreme point from the sensor frame. The
    distance from the axis would allow more, but the excursion grows with the square of the speed while the knowledge
    gained does not.
    """
    return SPEED_MARGIN * cartesian_speed / float(np.linalg.norm(box.corners, axis=1).max())


def decoupling_profile(
    box: Box,
    *,
    cartesian_speed: float,
    period: float,
    repetitions: int = 1,
    acceleration: float = ACCELERATION,
    plateau: float = 0.05,
    excursion: float = 0.6,
) -> AngularProfile:
    """Out and back, `repetitions` times: trapezoids `+w`, `-w` without a pause, from angle 0 one-sided to `max(angle)`
    and back to 0.

    Breakpoints lie on the control grid, so the angular acceleration is exactly `+acceleration`, 0 or `-acceleration`
    and `angle` is exactly the integral of the piecewise linear `rate`.

    Args:
        box: payload box in the sensor frame.
        cartesian_speed: limit of every corner of the box, m/s.
        period: control period, s.
        repetitions: how often out and back.
        acceleration: rad/s2.
        plateau: time at constant speed in each trapezoid, s.
        excursion: largest angle wanted, rad; lowers the speed where the box would allow a wider swing.

    Raises:
        ValueError: an argument that is not positive, or a box so large that not even one period of acceleration fits.
    """
    if min(cartesian_speed, period, acceleration, excursion) <= 0 or plateau < 0 or repetitions < 1:
        raise ValueError("speed, period, acceleration, excursion and repetitions of a decoupling motion must be positive")
    step = acceleration * period
    hold = round(plateau / period)
    # peak^2 / acceleration + peak * plateau = excursion
    widest = 0.5 * acceleration * (math.sqrt((hold * period) ** 2 + 4.0 * excursion / acceleration) - hold * period)
    ramp = math.floor(min(rate_limit(box, cartesian_speed), widest) / step + 1e-9)
    if ramp < 1:
        raise ValueError(f"the payload box allows {rate_limit(box, cartesian_speed):.4f} rad/s, less than one period of acceleration")
    out = np.repeat([1.0, 0.0, -1.0], [ramp, hold, ramp])
    rate = np.concatenate(([0.0], np.cumsum(np.tile(np.concatenate((out, -out)), repetitions)))) * step
    angle = np.concatenate(([0.0], np.cumsum(0.5 * period * (rate[1:] + rate[:-1]))))
    angle[-1] = 0.0  # what rounding leaves
    return AngularProfile(period, angle, rate)


def count_accelerating_samples(profile: AngularProfile) -> int:
    """How many periods of the profile have angular acceleration."""
    return int(np.count_nonzero(np.abs(np.diff(profile.rate)) > 1e-9))


def predict_inertia(box: Box, mass: float, axis: int) -> float:
    """Moment of a body that fills the box evenly, about a sensor axis (0, 1, 2) through the sensor origin, kg m2.

    What `repetitions_for` is told as long as nothing better is known; `mass` (kg) may come from the motionless phases.
    """
    rotation, size = box.pose.rotation, np.array(box.size_m)
    about_centre = rotation @ np.diag((size @ size - size**2) / 12.0) @ rotation.T
    centre = np.delete(box.pose.translation, axis)
    return float(mass * (about_centre[axis, axis] + centre @ centre))


def repetitions_for(once: AngularProfile, *, torque_std: float, inertia_std: float, budget: float) -> int:
    """How often to repeat a profile so that white torque noise alone leaves no more than the wanted standard deviation.

    Least squares of `tau = I dw` over N samples with `|dw| = A` gives `std(I) = torque_std / (A sqrt(N))`; the torque
    offset, which is estimated as well, takes nothing from it because the accelerations of out and back cancel.

    Args:
        once: the profile with one repetition.
        torque_std: noise of the torque about the axis, N m.
        inertia_std: wanted standard deviation of the moment of inertia, kg m2.
        budget: most robot time for this axis, s; at least one repetition is done in any case.
    """
    if min(torque_std, inertia_std, budget) <= 0:
        raise ValueError("noise, wanted standard deviation and budget must be positive")
    acceleration = float(np.abs(np.diff(once.rate)).max()) / once.period
    needed = math.ceil((torque_std / (acceleration * inertia_std)) ** 2 / count_accelerating_samples(once))
    return max(1, min(needed, math.floor(budget / once.duration)))
