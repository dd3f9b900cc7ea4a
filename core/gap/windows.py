"""A recording as whitened equations: what was measured, what the nominal twin predicts, and the way from an effect to its rows.

Both sides go through the same windows (cubic B-splines, `estimation.weak_form`), so that neither lag nor smoothing looks like a gap. Rows
are windows times channels, whitened with the covariance of sensor and kinematics: noise alone has unit variance in every row.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from core.array import Array, interpolate
from core.effects.composition import Term
from core.effects.joint_error import joint_count, true_motion, without_joints
from core.effects.rigid_body import wrench_change
from core.effects.scene import Scene
from core.estimation.banded import bands_of, count_bands, factorise
from core.estimation.drift import STEP_STD
from core.estimation.jitter import find_jittered
from core.estimation.kinematics import Poses
from core.estimation.noise import WrenchNoise
from core.estimation.pose_gram import PoseGram
from core.estimation.segments import Segment, stretches
from core.estimation.splines import cardinal
from core.estimation.weak_form import LEAST_SPACING_PERIODS, SPACING_S, tilt_axes
from core.gap.kinematic_noise import KinematicNoise, draw_noise
from core.gap.whitener import Whitener
from core.payload.inertia import Motion, spatial_inertia
from core.payload.rigid_wrench import wrench
from core.payload.rotations import cross
from core.recording.recording import PAUSE_S

PHI = slice(0, 10)
OFFSET = slice(10, 16)
LATE, BLUR = 18, 19
"""The delay, s, and the blur, a variance in s2."""

PHI_STD = np.concatenate(([30.0], np.full(3, 3.0), np.full(6, 1.0)))
OFFSET_STD = np.full(6, 1e3)
BACKGROUND_STD = np.concatenate((np.full(2, 4e-4), [3e-4, 2e-6], np.full(6, 1e-3)))
"""Small imperfections that every cell has, always in the model with tight priors: two tilts of 0.02 deg, a delay of 0.3 ms, a blur of 2 ms
(interpolation between samples, jitter), six gains of 0.1 %; then the zeros of the joints, and where no position is known the place that
the sensor turns about."""
ZERO_STD_RAD = 3.5e-4
"""0.02 deg, of a joint's zero where nobody states it; a larger one is an effect and has to be named."""
ZERO_STEP_RAD = 1e-4
TURNING_STD_M = 1.0
"""Of where a sensor whose position nobody knows turns about, each coordinate: an arm's length."""
STEP_INSTANTS = 5.0
"""The least spacing of the windows, in periods of the scene."""
LONG_SHARE, PIECE_SHARE = 0.25, 0.1
"""Of a recording: what moves for longer than the first at a stretch is left out in pieces as long as the second, since nothing would be
left to predict it from."""
FORGOTTEN_S = 0.5
"""Time after which delays and filters have forgotten what was before."""


@dataclass(frozen=True)
class Rows:
    """Where the equations of each channel lie: at windows of a motion, or at poses.

    Args:
        centres: (K,), s.
        step: between two of them, s.
        average: (K, N), mean over the scene's grid for each.
        part: (K,), number of the stretch between two pauses that it belongs to.
        every: samples from one fresh reading to the next.
        at_rest: nothing moves in any of them.
    """

    centres: Array
    step: float
    average: csr_array
    part: NDArray[np.intp]
    every: float = 1.0
    at_rest: bool = False


@dataclass(frozen=True)
class Basis:
    """Everything about a recording that the windows are built from.

    Effects act on a fine grid; measurement and nominal twin come to it through the same narrow windows, so what effects do is exact
    where they are linear in time (delays, filters).

    Args:
        poses: of all samples.
        noise: of one sample of the wrench.
        segments: the motions.
        scene: nominal run on the fine grid, N rows.
        wrench: (N, 6), measured, on the fine grid.
        V: (N, 6, 10), nominal regressor, likewise.
        reference: (10,), the payload as somebody else knows it, None where nobody does.
        zero_std_rad: of the joints' zeros.
        spread: (N, samples), the narrow windows over the motion; `reading`: (N, samples), those over the readings; `difference`: (samples,
            samples), second differences of the poses.
        rows: of the equations.
    """

    poses: Poses
    noise: WrenchNoise
    segments: tuple[Segment, ...]
    scene: Scene
    wrench: Array
    V: Array
    reference: Array | None
    zero_std_rad: float
    spread: csr_array
    reading: csr_array
    difference: csr_array
    rows: Rows


class Windows:
    """Whitened rows of one recording.

    Args:
        basis: of the recording.
        held: effects of the cell's twin, always on with parameters that are known.
    """

    def __init__(self, basis: Basis, held: tuple[Term, ...] = ()) -> None:
        self.basis = basis
        self.held = held
        t = basis.scene.t
        self.step, self.centres, self._to_windows = basis.rows.step, basis.rows.centres, basis.rows.average
        self.y = y = self._average(basis.wrench)
        """(K, 6), measured, N and N m."""
        V = self._average(basis.V)
        self.phi = phi = self._first_phi(y, V)
        """(10,), the payload by which the noise of the poses is taken to show in the wrench."""
        self._factors = self._whiteners(phi)
        self._whitener = Whitener(self._to_windows, self._factors)
        nominal = basis.V @ phi
        rate = np.zeros_like(nominal) if basis.scene.apart else np.gradient(nominal, t, axis=0)
        late = self._average(np.stack((-rate, 0.5 * np.gradient(rate, t, axis=0)), axis=2))
        gain = np.einsum("kc,cd->kcd", V @ phi, np.eye(6))
        constant, later = np.split(self._offsets(), [6], axis=2)
        zeros = self._average(_find_zero_columns(basis.scene.with_phi(phi)))
        places_known = basis.scene.position is not None or basis.rows.at_rest
        turning = self._average(_find_turning_columns(basis.scene, phi, known=places_known))
        self.X = self.whiten(np.concatenate((V, constant, self._average(self._tilt(phi)), late, gain, zeros, turning, later), axis=2))
        """(6, K, 26 + n + 6 p): columns of the nominal twin with its small imperfections, and what p pauses changed in its offsets."""
        self.target = self.whiten(y[..., None])[..., 0]
        """(6, K)."""
        zero_std = np.full(zeros.shape[2], basis.zero_std_rad)
        small = np.concatenate((BACKGROUND_STD, zero_std, np.full(turning.shape[2], TURNING_STD_M)))
        self.background = slice(OFFSET.stop, OFFSET.stop + len(small))
        """Columns of the small imperfections."""
        self.prior_std = np.concatenate((PHI_STD, OFFSET_STD, small, np.tile(STEP_STD, later.shape[2] // 6)))
        self.group = self._groups()

    def __len__(self) -> int:
        return len(self.centres)

    @cached_property
    def flat(self) -> Array:
        """(6 K, n), the columns X one channel behind the other."""
        return self.X.reshape(-1, self.X.shape[2])

    @cached_property
    def normal(self) -> Array:
        """(n, n), their products."""
        return np.asarray(self.flat.T @ self.flat)

    def _average(self, x: Array) -> Array:
        """(K, ...) windowed means of rows (N, ...)."""
        return np.asarray(self._to_windows @ x.reshape(len(x), -1)).reshape(len(self.centres), *x.shape[1:])

    def _offsets(self) -> Array:
        """(K, 6, 6 + 6 p), of all rows, and of those between each of the p pauses and the next."""
        part = self.basis.rows.part
        rows = [np.ones(len(part)), *(part == k for k in range(1, part[-1] + 1))]
        return np.concatenate([np.multiply.outer(row, np.eye(6)) for row in rows], axis=2)

    def _tilt(self, phi: Array) -> Array:
        """(N, 6, 2), change of the wrench per radian of tilt about two axes across gravity."""
        scene = self.basis.scene
        columns = []
        for axis in tilt_axes(scene.gravity).T:
            g = np.cross(axis, scene.gravity) @ scene.rotation
            still = np.zeros_like(g)
            columns.append(wrench(Motion(g, still, still, still), phi))
        return np.stack(columns, axis=2)

    def _first_phi(self, y: Array, V: Array) -> Array:
        """Payload by least squares with offsets, channels weighed by their noise."""
        sigma = self.basis.noise.std
        offsets = self._offsets()
        rows = (np.concatenate((V, offsets), axis=2) / sigma[:, None]).reshape(y.size, -1)
        prior = np.diag(np.concatenate((PHI_STD, np.resize(OFFSET_STD, offsets.shape[2]))) ** -1.0)
        right = np.concatenate(((y / sigma).ravel(), np.zeros(len(prior))))
        return np.asarray(np.linalg.lstsq(np.vstack((rows, prior)), right, rcond=None)[0][:10])

    def _whiteners(self, phi: Array) -> list[Array]:
        """Cholesky factors, banded, of the covariance of each channel's windows."""
        R, W = csr_array(self._to_windows @ self.basis.reading), csr_array(self._to_windows @ self.basis.spread)
        D = csr_array(W @ self.basis.difference)
        of_sensor, of_pose = csr_array(R @ R.T), csr_array(D @ D.T)
        count = max(count_bands(of_sensor), count_bands(of_pose))
        pose = PoseGram.of(self.basis.poses.noise, D, [csr_array(W @ each) for each in self._jittered], count)
        sensor, M = bands_of(of_sensor, count), spatial_inertia(phi)
        return [factorise(self.basis.noise.variance[c] * sensor + pose.find_variance_through(M[c])) for c in range(6)]

    def whiten(self, x: Array) -> Array:
        """Rows (6, K, n) with unit noise from windowed wrenches (K, 6, n)."""
        return np.ascontiguousarray(self.whiten_windowed(x.transpose(2, 0, 1)).transpose(1, 2, 0))

    def unwhiten(self, rows: Array) -> Array:
        """(K, 6), N and N m, of rows (6, K)."""
        result = np.zeros((rows.shape[1], 6))
        for c, factor in enumerate(self._factors):
            for k, band in enumerate(factor):
                result[k:, c] += (band * rows[c])[: rows.shape[1] - k]
        return result

    def average_rotation(self) -> Array:
        """(K, 3, 3), sensor axes in the base frame at each window."""
        return self._average(self.basis.scene.rotation)

    def on_grid(self, rows: Array) -> Array:
        """(N, 6), rows (6, K) on the scene's grid, in standard deviations of the noise."""
        return interpolate(self.basis.scene.t, self.centres, rows.T)

    @property
    def noise_std(self) -> Array:
        """(6,), of one windowed wrench, N and N m."""
        return np.array([np.sqrt(np.median((factor**2).sum(axis=0))) for factor in self._factors])

    def rows_of(self, changes: Iterable[Array]) -> Array:
        """Rows (6, K, n) of n changes of the wrench on the scene's grid, (N, 6) each."""
        return np.stack([self._whitener.average_and_whiten(change) for change in changes]).transpose(1, 2, 0)

    def row_of(self, change: Array) -> Array:
        """(6 K,), rows of one change (N, 6), one channel behind the other."""
        return self._whitener.average_and_whiten(change).ravel()

    def whiten_windowed(self, wrenches: Array) -> Array:
        """Rows (M, 6, K) of wrenches (M, K, 6) that are windowed already."""
        return np.stack([self._whitener.whiten(wrench) for wrench in wrenches])

    def _groups(self) -> NDArray[np.int64]:
        """(K,), number of the motion that each window belongs to, or of the piece of a long one: what is left out together."""
        t = self.basis.poses.t
        lasts_s = float(np.ptp(t))
        spans = [(t[part.start], t[part.stop - 1]) for part in self.basis.segments]
        pieces = [int(np.ceil((b - a) / (PIECE_SHARE * lasts_s))) if b - a > LONG_SHARE * lasts_s else 1 for a, b in spans]
        return self._find_last(np.concatenate([np.linspace(a, b, n, endpoint=False) for (a, b), n in zip(spans, pieces, strict=True)]))

    def _find_last(self, begins: Array) -> NDArray[np.int64]:
        """(K,), which of some stretches that begin behind each other, s, each window lies in."""
        return np.maximum(np.searchsorted(begins, self.centres, side="right") - 1, 0)

    @cached_property
    def phase(self) -> NDArray[np.str_]:
        """(K,), label of each window."""
        names = np.array([part.phase for part in self.basis.segments])
        return names[self._find_last(self.basis.poses.t[[part.start for part in self.basis.segments]])]

    @cached_property
    def _jittered(self) -> list[csr_array]:
        """Accelerations (samples, samples) by errors of the instants."""
        return find_jittered(self.basis.poses, self.basis.difference)

    @cached_property
    def kinematic_noise(self) -> KinematicNoise:
        """Draws of what the noise of the poses and of their instants makes of the accelerations."""
        basis = self.basis
        jittered = [csr_array(basis.spread @ each) for each in self._jittered]
        return draw_noise(basis.poses, csr_array(basis.spread @ basis.difference), jittered, basis.scene.t, self._to_windows)

    @cached_property
    def samples_per_row(self) -> float:
        """Fresh readings for each window."""
        return self.step / (self.basis.poses.period * self.basis.rows.every)


def _find_zero_columns(scene: Scene) -> Array:
    """(N, 6, n), change of the wrench per radian of each joint's zero; none without joints."""
    if without_joints(scene) is not None:
        return np.zeros((len(scene), 6, 0))
    steps = ZERO_STEP_RAD * np.eye(joint_count(scene))
    moved = [wrench_change(scene, true_motion(scene, np.tile(step, (len(scene), 1)))) for step in steps]
    return np.stack(moved, axis=2) / ZERO_STEP_RAD


def _find_turning_columns(scene: Scene, phi: Array, *, known: bool) -> Array:
    """(N, 6, 3), change of the wrench per metre from a place at rest to a sensor whose position is not known, sensor axes: turning about
    it, the sensor's origin is accelerated by `alpha x r + omega x (omega x r)`; none where that is known, or nothing moves."""
    if known or scene.apart:
        return np.zeros((len(scene), 6, 0))
    m, still = scene.motion, np.zeros_like(scene.motion.g)
    by_axis = (cross(m.alpha, axis) + cross(m.omega, cross(m.omega, axis)) for axis in np.eye(3))
    return np.stack([wrench(Motion(still, a, still, still), phi) for a in by_axis], axis=2)


def window_rows(poses: Poses, t: Array, every: float = 1.0, least_s: float = SPACING_S) -> Rows:
    """Windows over the grid t (N,) of a motion of which `every` so many samples one reading is fresh, `least_s` apart at least."""
    of_samples, of_instants = max(LEAST_SPACING_PERIODS, 2.0 * every) * poses.period, STEP_INSTANTS * float(np.median(np.diff(t)))
    step = max(least_s, of_samples, of_instants)
    centres = window_centres(t, step)
    part = np.cumsum(np.diff(centres, prepend=centres[0]) > PAUSE_S, dtype=np.intp)
    return Rows(centres, step, window_matrix(centres, step, t), part, every)


def window_centres(t: Array, step: float) -> Array:
    """(K,), centres of the windows over times t (N,) that hold no gap.

    What an effect remembers is not known after a gap: as long as the gap was, at most `FORGOTTEN_S`, is left out.
    """
    gap, centres = 0.0, []
    for part, after in pairwise((*stretches(t), slice(len(t), len(t)))):
        centres.append(np.arange(t[part.start] + 2.0 * step + min(gap, FORGOTTEN_S), t[part.stop - 1] - 2.0 * step, step))
        gap = t[after.start] - t[part.stop - 1] if after.start < len(t) else 0.0
    return np.concatenate(centres)


def window_matrix(centres: Array, step: float, t: Array) -> csr_array:
    """(K, N): cubic B-spline windows over times t (N,), each summing to 1."""
    period = float(np.median(np.diff(t)))
    reach = int(np.ceil(2.0 * step / period)) + 1
    nearest = np.clip(np.searchsorted(t, centres), 0, len(t) - 1)
    columns = nearest[:, None] + np.arange(-reach, reach + 1)
    inside = (columns >= 0) & (columns < len(t))
    columns = np.clip(columns, 0, len(t) - 1)
    weights = np.where(inside, cardinal((t[columns] - centres[:, None]) / step, 3), 0.0)
    weights /= weights.sum(axis=1, keepdims=True)
    rows = np.repeat(np.arange(len(centres)), columns.shape[1])
    matrix = csr_array((weights.ravel(), (rows, columns.ravel())), shape=(len(centres), len(t)))
    matrix.eliminate_zeros()  # where windows end, a fifth of all
    return matrix
