"""What is not sought and yet in the wrench: gains and cross-talk of the sensor, zeros of the joints, its mounting, gravity.

Each has a standard uncertainty that the cell or the recording states, or that is assumed. It enters the least squares linearised, as a
column that says how the windowed wrench changes when it is off by one such standard uncertainty, with a prior of unit variance times the
*strength* of its group. The strength lies between nothing and 1, and the restricted likelihood decides it; what is not significant has
none. So clean data lose no precision to what is not there, and what is there is told apart by its own pattern and taken off.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.kinematics import Joints, Poses
from core.estimation.weak_form import Features, WeakForm
from core.payload.calibration import reading_std
from core.payload.rotations import rotation_of, skew
from core.payload.site import GRAVITY_STD_M_S2, UNKNOWN_GRAVITY_STD_M_S2
from core.recording.recording import Recording
from core.twin.twin import NOMINAL, Twin

ASSUMED_ZERO_STD_RAD = 8.7e-4
"""0.05 deg: what the zero of a joint is good for after a maker's own calibration."""
ASSUMED_MOUNT_STD_RAD = 1.7e-3
"""0.1 deg about each axis: what two dowel pins hold."""
COARSE = 0.2
"""Share of the windows' spacing at which poses are taken for the columns of the joints' zeros; a thousandth of a column does not count."""
STEP_RAD = 1e-4
"""By which a zero is moved for its column."""
KEPT_DELAY_S = 0.002
"""By which the delay may change before these columns are made again."""
MEASURED_BY = {
    "sensor_gain": "sensor_gain",
    "sensor_crosstalk": "sensor_crosstalk",
    "joint_offset": "joint_zeros",
    "sensor_rotation": "sensor_mount",
}
"""Effects of a twin that say of a group how large it is; their own uncertainty takes its place."""
BUDGETED = "gravity"
"""The group that no recording is asked about; it counts with its uncertainty alone. Gravity shows only in how much less a mass weighs at
rest than it resists in motion, and an arm that swings on its gears changes that by several per cent."""
LEAST_STRENGTH = 1e-6
LEAST_EVIDENCE = 6.0
"""Below it a group is left out of the fit and counts with its uncertainty alone; in clean data one of a hundred is above it by chance."""
LEAST_SEEN = 1e-3
"""Degrees of freedom that a group must have shown for its strength to be changed."""


@dataclass(frozen=True)
class NuisanceGroup:
    """Nuisances of one kind, which share a strength.

    Args:
        name: of the source in the budget.
        rows: among all nuisances.
        stated: whether somebody has stated the standard uncertainty.
    """

    name: str
    rows: slice
    stated: bool


@dataclass(frozen=True)
class Nuisances:
    """All of a recording's, in units of their standard uncertainties: 6 gains, 30 cross-talks, n zeros, 3 of the mounting, 1 of gravity.

    Args:
        reading_std: (6, 6), of what channel i reads per load of channel j.
        zero_std_rad: (n,), of the joints' zeros; none for a recording without joints.
        mount_std_rad: of the sensor's orientation, about each of its axes.
        gravity_std: m/s2.
        stated: names of the groups whose size somebody has stated.
    """

    reading_std: Array
    zero_std_rad: Array
    mount_std_rad: float
    gravity_std: float
    stated: frozenset[str] = field(default_factory=frozenset)

    @cached_property
    def groups(self) -> tuple[NuisanceGroup, ...]:
        """In the order of their rows."""
        sizes = {"sensor_gain": 6, "sensor_crosstalk": 30, "joint_zeros": len(self.zero_std_rad), "sensor_mount": 3, "gravity": 1}
        edges = np.cumsum([0, *sizes.values()])
        named = zip(sizes, edges[:-1].tolist(), edges[1:].tolist(), strict=True)
        return tuple(NuisanceGroup(name, slice(a, b), name in self.stated) for name, a, b in named if b > a)

    @cached_property
    def size(self) -> int:
        """How many there are."""
        return int(self.groups[-1].rows.stop)

    @property
    def of_loads(self) -> int:
        """How many concern one channel each: gains and cross-talk."""
        return 36

    @property
    def mount(self) -> slice:
        """Rows of the mounting."""
        return next(group.rows for group in self.groups if group.name == "sensor_mount")

    def mounting(self, b: Array) -> Array:
        """(3, 3), how nuisances b (size,) turn the sensor: too far for a column alone where it is half a degree."""
        return rotation_of(self.mount_std_rad * b[self.mount])

    def rows_of_channel(self, c: int) -> NDArray[np.intp]:
        """(6,), which of them turn the loads of the six channels into what channel c reads, in the order of the loads."""
        beside = 6 + 5 * c + np.arange(5)
        return np.insert(beside, c, c)

    def reading(self, b: Array) -> Array:
        """(6, 6), what channel i reads beyond its own load, per load of channel j, for nuisances b (size,)."""
        return np.stack([self.reading_std[c] * b[self.rows_of_channel(c)] for c in range(6)])

    def correct(self, poses: Poses, b: Array) -> Poses:
        """Poses and gravity as the nuisances b (size,) say they were."""
        zeros, mount, gravity = self._kinematic(b)
        strength = 1.0 + gravity / np.linalg.norm(poses.gravity)
        return poses.with_zeros(zeros).with_sensor_turned(rotation_of(mount), poses.gravity * strength)

    def _kinematic(self, b: Array) -> tuple[Array, Array, float]:
        """Zeros (n,), rad, mounting (3,), rad, and gravity, m/s2."""
        rest, n = b[self.of_loads :], len(self.zero_std_rad)
        return self.zero_std_rad * rest[:n], self.mount_std_rad * rest[n : n + 3], self.gravity_std * float(rest[n + 3])


class NuisanceColumns:
    """How the windowed wrench of one recording changes with its nuisances.

    Args:
        form: windows; `nuisances` of the same recording.
    """

    def __init__(self, form: WeakForm, nuisances: Nuisances) -> None:
        self.nuisances = nuisances
        self._form = form
        self._delay = np.inf
        self._zeros: list[Features] = []

    def of_every_channel(self, features: Features, phi: Array, tilt: Array, delay: float) -> Array:
        """(K, 6, n + 4): of zeros, mounting and gravity, which show in every channel.

        Args:
            features: at this delay, s; phi (10,) and tilt (2,), rad, about which it is linearised.
        """
        held = self.nuisances
        zeros = [f.wrench(tilt, phi) * std for f, std in zip(self._zero_features(delay), held.zero_std_rad, strict=True)]
        turned = [_turn_features(features, axis).wrench(tilt, phi) * held.mount_std_rad for axis in np.eye(3)]
        still = Features(np.zeros_like(features.a), features.base, np.zeros_like(features.B), features.gravity)
        weight = still.wrench(tilt, phi) * (held.gravity_std / float(np.linalg.norm(features.gravity)))
        return np.stack([*zeros, *turned, weight], axis=-1)

    def of_channel(self, c: int, load: Array) -> Array:
        """(K, 6): of gains and cross-talk of channel c for the wrench `load` (K, 6), in the order of `rows_of_channel`."""
        return np.asarray(load * self.nuisances.reading_std[c])

    def dense(self, features: Features, phi: Array, tilt: Array, delay: float) -> Array:
        """(K, 6, size): all of them."""
        load, held = features.wrench(tilt, phi), self.nuisances
        columns = np.zeros((len(load), 6, held.size))
        for c in range(6):
            columns[:, c, held.rows_of_channel(c)] = self.of_channel(c, load)
        columns[:, :, held.of_loads :] = self.of_every_channel(features, phi, tilt, delay)
        return columns

    def _zero_features(self, delay: float) -> list[Features]:
        """Change of the features per radian of each joint's zero."""
        joints = self._form.poses.joints
        if joints is not None and abs(delay - self._delay) > KEPT_DELAY_S:
            every = 1 if self._form.static else max(1, int(COARSE * self._form.spacing / self._form.poses.period + 0.01))
            coarse = self._form.poses.take(slice(None, None, every))
            moved = (coarse.with_zeros(zeros) for zeros in np.vstack((np.zeros(joints.robot.n), STEP_RAD * np.eye(joints.robot.n))))
            before, *after = self._form.features_of(coarse.t, moved, delay)
            self._zeros = [features.less(before, STEP_RAD) for features in after]
            self._delay = delay
        return self._zeros


def _turn_features(features: Features, axis: Array) -> Features:
    """Change of the features per radian by which the sensor is turned about one of its axes (3,)."""
    S = skew(axis)
    return Features(-features.a @ S.T, -S @ features.base, features.B @ S - S @ features.B, features.gravity)


def improve_strength(strength: float, b: Array, covariance: Array) -> float:
    """One step towards the variance of nuisances b (n,), with their posterior covariance (n, n), that the restricted likelihood asks for.

    It stays between next to nothing and 1, the variance that is stated; what the data say nothing of keeps its strength. The step is that
    of Wood & Fasiolo 2017 (Biometrics 73).
    """
    seen = len(b) - float(np.trace(covariance)) / strength
    return strength if seen < LEAST_SEEN else float(np.clip(b @ b / seen, LEAST_STRENGTH, 1.0))


def find_evidence(strength: float, b: Array, covariance: Array) -> float:
    """Twice the logarithm of how much more probable the data are with nuisances of this strength than without them.

    Args:
        b, covariance: (n,) and (n, n), posterior; the ratio of prior to posterior density at zero is the ratio sought (Dickey 1971).
    """
    _, size = np.linalg.slogdet(covariance / strength)
    return float(b @ np.linalg.solve(covariance, b) + size)


def nuisances_of(recording: Recording, joints: Joints | None, twin: Twin = NOMINAL) -> Nuisances:
    """What the recording states of them; what it does not state is assumed, and what the cell's twin has measured is its own affair."""
    measured = {MEASURED_BY[name] for name in twin.ids if name in MEASURED_BY}
    sensor, calibration = recording.sensor, recording.sensor.calibration
    given = {
        "sensor_gain": calibration.gain_std is not None,
        "sensor_crosstalk": calibration.crosstalk_std is not None,
        "joint_zeros": recording.zero_std_rad is not None,
        "sensor_mount": sensor.mount_std_rad is not None,
        "gravity": recording.site is not None,
    }
    zero_std = ASSUMED_ZERO_STD_RAD if recording.zero_std_rad is None else recording.zero_std_rad
    mount_std = ASSUMED_MOUNT_STD_RAD if sensor.mount_std_rad is None else sensor.mount_std_rad
    reading = reading_std(calibration, sensor.range)
    gain = np.eye(6, dtype=bool)
    reading[gain] *= "sensor_gain" not in measured
    reading[~gain] *= "sensor_crosstalk" not in measured
    return Nuisances(
        reading_std=reading,
        zero_std_rad=np.full(0 if joints is None else joints.robot.n, 0.0 if "joint_zeros" in measured else zero_std),
        mount_std_rad=0.0 if "sensor_mount" in measured else mount_std,
        gravity_std=UNKNOWN_GRAVITY_STD_M_S2 if recording.site is None else GRAVITY_STD_M_S2,
        stated=frozenset(name for name, known in given.items() if known) | measured,
    )
