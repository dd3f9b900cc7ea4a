"""What is sought and what is beside it in the torques, with its priors: payload, links, gains, friction, rotors, offsets, delay."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from core.array import Array
from core.estimation.joint_torques.windows import TorqueWindows

LATE_STD_S = 0.03
"""How late torques may be against positions."""
STRIBECK_RAD_S = (0.03, 0.1)
"""Velocities over which friction falls from rest to motion."""
SHEAR_RAD_S = 0.3
"""Velocity from which a lubricant's friction grows less than in proportion."""
FRICTION_SHARE = (0.2, 0.5)
"""Of a joint's torque: Coulomb friction, and viscous friction at 1 rad/s."""
SHAPE_SHARE = 0.02
"""Of a joint's torque: what the departure from Coulomb and viscous friction is before the data have said how large it is."""
LOAD_STD = 0.05
"""Friction per torque that the joint transmits."""
CHANGE_SHARE = 0.02
"""Of a joint's torque: by how much friction changes between two recordings."""
POSITION_SHARE = 0.003
"""Of a joint's torque limit: what cables, hoses and gears add as a function of its angle before the data have said how large it is."""
HARMONICS = (1.0, 2.0)
"""Of a joint's turn, in that function."""
ROTOR_S2 = 0.05
"""Inertia of rotors through their gears per torque limit, kg m2 per N m; that of the torque seen where no limit is stated."""
MOST = {"link_mass": 25.0, "link_centre": 25.0, "link_inertia": 100.0, "shape": 100.0, "change": 100.0, "position": 100.0}
"""Strengths that the restricted likelihood may give, in units of the prior variances."""
LEAST_STRENGTH = 1e-4
COMMON_GAIN = 0.7
"""Of the uncertainty of one gain: what all of them are off by together, a constant or a temperature."""
SOURCES = {"link_mass": "arm_model", "link_centre": "arm_model", "link_inertia": "arm_model", "torque_gain": "torque_gain"}
"""Groups that are the same in every recording (type B) -> their source in the budget."""
SHAPES = len(STRIBECK_RAD_S) + 2
PHI = slice(0, 10)


@dataclass(frozen=True)
class Group:
    """Unknowns of one kind.

    Args:
        name: of the kind.
        rows: among all unknowns.
        most: the largest strength (variance, in units of the prior's) that the restricted likelihood may give it; 1 where it is not asked.
        least: the smallest; what is stated of an arm is never taken for better than that.
    """

    name: str
    rows: slice
    most: float = 1.0
    least: float = LEAST_STRENGTH


@dataclass(frozen=True)
class Recorded:
    """One recording in windows; `carries`: whether the payload hangs on it; `known`: (10,), what hangs on it beside."""

    windows: TorqueWindows
    carries: bool
    known: Array


class TorqueModel:
    """Predicted torques of all recordings together and how they change with the unknowns, all but the payload in units of their priors.

    Args:
        recorded: of one arm with n joints.
        links: (n, 10), nominal; modes: (10 n, 10 n), their errors of one standard deviation.
        gain_std: (n,), relative, of the torques.
    """

    def __init__(self, recorded: Sequence[Recorded], links: Array, modes: Array, gain_std: Array, effort: Array) -> None:
        self.recorded = tuple(recorded)
        self.n = len(links)
        self.nominal_links, self._modes, self._gain_std = links.ravel(), modes, gain_std
        self._of_modes = [each.windows.Y[:, :, : 10 * self.n] @ modes for each in self.recorded]
        seen = np.max([np.abs(each.windows.samples[1]).max(axis=0) for each in self.recorded], axis=0)
        self._size = np.maximum(seen, 1e-6)
        limit = np.where(effort > 0.0, effort, self._size)
        self._rotor, self._ripple = ROTOR_S2 * limit, POSITION_SHARE * limit

    @cached_property
    def groups(self) -> dict[str, Group]:
        """By name, in the order of their rows."""
        n, count = self.n, len(self.recorded)
        sizes = {
            "payload": 10,
            "link_mass": n,
            "link_centre": 3 * n,
            "link_inertia": 6 * n,
            "torque_gain": n + 1,
            "late": count,
            "friction": 2 * n,
            "shape": SHAPES * n,
            "load": n,
            "position": 2 * len(HARMONICS) * n,
            "rotor": n,
            "offset": count * n,
            "change": 2 * (count - 1) * n,
        }
        edges = np.cumsum([0, *sizes.values()]).tolist()
        return {
            name: Group(name, slice(a, b), MOST.get(name, 1.0), 1.0 if name.startswith("link") else LEAST_STRENGTH)
            for name, a, b in zip(sizes, edges[:-1], edges[1:], strict=True)
            if b > a
        }

    @property
    def size(self) -> int:
        """How many unknowns there are."""
        return int(max(group.rows.stop for group in self.groups.values()))

    @property
    def arm(self) -> slice:
        """Rows of all errors of the links."""
        return slice(self.groups["link_mass"].rows.start, self.groups["link_inertia"].rows.stop)

    def gains(self, b: Array) -> Array:
        """(n,), by what share each torque reads too much for unknowns b."""
        rows = b[self.groups["torque_gain"].rows]
        return np.asarray(self._gain_std * (rows[:-1] + COMMON_GAIN * rows[-1]))

    def gain_stds(self, covariance: Array) -> Array:
        """(n,), standard uncertainties of `gains` for a covariance of the unknowns."""
        rows, n = self.groups["torque_gain"].rows, self.n
        part = np.hstack((np.eye(n), np.full((n, 1), COMMON_GAIN)))
        return np.asarray(self._gain_std * np.sqrt(np.diag(part @ covariance[rows, rows] @ part.T)))

    def friction(self, b: Array) -> Array:
        """(2, n): Coulomb friction, N m, and viscous friction, N m s/rad, for unknowns b."""
        return np.asarray(b[self.groups["friction"].rows].reshape(2, self.n) * self._size * np.array(FRICTION_SHARE)[:, None])

    def evaluate(self, b: Array) -> list[tuple[Array, Array]]:
        """Of each recording, torques (K, n) that unknowns b (size,) predict, and their derivative (K, n, size)."""
        return [self._evaluate_one(k, b) for k in range(len(self.recorded))]

    def _evaluate_one(self, k: int, b: Array) -> tuple[Array, Array]:
        n, groups, each = self.n, self.groups, self.recorded[k]
        windows = each.windows
        J = np.zeros((*windows.speed.shape, self.size))
        beta = np.concatenate((self.nominal_links + self._modes @ b[self.arm], each.known + (b[PHI] if each.carries else 0.0)))
        rigid = windows.Y @ beta
        sign = np.sign(windows.speed)
        load_std = LOAD_STD * b[groups["load"].rows]
        gains, own = self.gains(b), groups["torque_gain"].rows
        factor = (1.0 + gains + load_std * sign * np.sign(rigid))[:, :, None]
        if each.carries:
            J[:, :, PHI] = factor * windows.Y[:, :, 10 * n :]
        J[:, :, self.arm] = factor * self._of_modes[k]
        J[:, :, groups["late"].rows.start + k] = -LATE_STD_S * windows.rate @ beta
        joints = np.arange(n)
        J[:, joints, own.start + joints] = self._gain_std * rigid
        J[:, :, own.stop - 1] = COMMON_GAIN * self._gain_std * rigid
        J[:, joints, groups["load"].rows.start + joints] = LOAD_STD * sign * np.abs(rigid)
        J[:, joints, groups["rotor"].rows.start + joints] = self._rotor * windows.acceleration
        J[:, joints, groups["offset"].rows.start + k * n + joints] = self._size
        for row, (column, share) in enumerate(zip((sign, windows.speed), FRICTION_SHARE, strict=True)):
            J[:, joints, groups["friction"].rows.start + row * n + joints] = share * self._size * column
            if k > 0:
                start = groups["change"].rows.start + (2 * (k - 1) + row) * n
                J[:, joints, start + joints] = CHANGE_SHARE * self._size * column
        for row, column in enumerate(_shapes(windows.speed)):
            J[:, joints, groups["shape"].rows.start + row * n + joints] = SHAPE_SHARE * self._size * column
        for row, column in enumerate(f(h * windows.q) for h in HARMONICS for f in (np.sin, np.cos)):
            J[:, joints, groups["position"].rows.start + row * n + joints] = self._ripple * column
        linear = np.concatenate([np.arange(group.rows.start, group.rows.stop) for name, group in groups.items() if name not in _BILINEAR])
        gained = rigid * (1.0 + gains) + load_std * sign * np.abs(rigid)
        return gained + J[:, :, linear] @ b[linear], J


_BILINEAR = ("payload", "link_mass", "link_centre", "link_inertia", "torque_gain", "load")


def _shapes(speed: Array) -> list[Array]:
    """(K, n) each: friction that falls from rest, that grows less than in proportion, and that differs with the direction."""
    sign, size = np.sign(speed), np.abs(speed)
    return [*(sign * np.exp(-size / v) for v in STRIBECK_RAD_S), sign * np.log1p(size / SHEAR_RAD_S), size]
