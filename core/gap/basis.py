"""From a recording to the basis of its diagnosis: poses, windows, noise, motions, and the nominal run that effects are applied to."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array, eye_array

from core.array import Array, interpolate
from core.effects.joint_twists import find_joint_twists
from core.effects.joint_waves import JointWaves
from core.errors import HeftError
from core.estimation.kinematics import Poses, axial, poses_of, smooth_motion
from core.estimation.lost_rows import is_broken
from core.estimation.noise import WrenchNoise, unknown_noise
from core.estimation.resting import find_resting
from core.estimation.scene import scene_of, scene_of_poses
from core.estimation.segments import Segment, cut_at_gaps, hold_label, motionless, segments_of_motion, segments_of_phase, stretches
from core.estimation.weak_form import RawFeatures, regressor_of
from core.gap.calm_noise import find_fresh_noise
from core.gap.windows import ZERO_STD_RAD, Basis, Rows, window_matrix, window_rows
from core.payload.inertia import Motion, regressor
from core.recording.held_readings import find_fresh
from core.recording.recording import Recording

GRID_S, MOST_INSTANTS = 0.005, 40_000
"""Period of the scene that effects are applied to, up to so many of its instants (200 s): what lasts longer has a coarser one, and wider
windows; of ten minutes up to 5 Hz are seen instead of 8 Hz."""
SMOOTHING_S = 0.036
"""Of the motion that effects act on: short enough for the corners of a trapezoid, long enough for the encoders' noise."""
SHORTEST_S, FEWEST_SAMPLES = 3.0, 200
NARROW_S, NARROW_INSTANTS = 0.0125, 2.5
"""Knot spacing of the narrow windows, and the least of it in periods of the scene."""
LEAST_ZERO_STD_RAD = 1e-6
"""A prior needs some width."""
FEWEST_HOLDS = 4
"""Where positions are not recorded and the sensor rested so often, turned, rest is compared alone: how it was accelerated nobody knows."""
TURNED_M_S2 = 0.5
"""By which gravity has to differ between such holds, standard deviation along its second direction."""
SLOWEST_STREAM_S, STREAM, RESOLVED = 0.25, 0.1, 0.015
"""Poses more than so many seconds apart, or farther than the second figure off the middle of their neighbours (`find_way_off`), are no
motion; off by less than the third they show how it went. Streams of arms are off by 0.001 to 0.004 at 20 Hz, by 0.003 to 0.08 at 10 Hz,
where from 0.03 on their accelerations are wrong by more than the noise; lists of poses by 2 to 4."""
FEWEST_POSES = 16
"""A linear channel under any gravity that drifts can follow eleven of them whatever the noise."""


class TooLittleError(HeftError):
    """The recording is too short or lacks too much to say anything about a gap."""


def basis_of(recording: Recording) -> Basis:
    """The basis of one recording.

    Raises:
        TooLittleError: no wrench, no poses, or too few samples.
    """
    poses = poses_of(recording)
    if recording.wrench is None:
        raise TooLittleError("gap-no-wrench")
    if poses is None:
        raise TooLittleError("gap-no-motion")
    if poses.apart and (rows := _find_poses(recording, poses)) is not None:
        return basis_of_poses(recording, poses, recording.wrench, rows)
    if recording.t[-1] - recording.t[0] < SHORTEST_S or len(recording) < FEWEST_SAMPLES:
        lasts_s = float(recording.t[-1] - recording.t[0])
        raise TooLittleError("gap-too-short", lasts_s=lasts_s)
    return build_unchecked_basis(recording, poses, recording.wrench)


def _find_poses(recording: Recording, poses: Poses) -> NDArray[np.intp] | None:
    """Rows of a list of poses: its holds, all where it has no labels, or of a motion that is logged too slowly what stands still; None
    where the motion shows well enough."""
    off = find_way_off(poses) if poses.period <= SLOWEST_STREAM_S else np.inf
    if off < STREAM:
        rest = np.flatnonzero(find_resting(poses))
        shows = off < RESOLVED and poses.position is not None
        if len(recording) >= FEWEST_SAMPLES and (shows or len(rest) < FEWEST_POSES):
            return None
        if len(rest) >= FEWEST_POSES:
            return rest
    is_hold = np.ones(len(recording), dtype=bool) if recording.phase is None else np.char.startswith(recording.phase, "hold")
    return np.flatnonzero(is_hold)


def find_way_off(poses: Poses) -> float:
    """How far poses are off the middle of their neighbours, mean square over that of half the way between these."""
    R = poses.rotation
    return float(np.square(R[2:] - 2.0 * R[1:-1] + R[:-2]).sum() / max(np.square(R[2:] - R[:-2]).sum(), 1e-300))


def basis_of_poses(recording: Recording, poses: Poses, wrench: Array, kept: NDArray[np.intp]) -> Basis:
    """The basis of a list of poses with one wrench (N, 6) each, averaged or not; of rows `kept`, in which nothing moves.

    Raises:
        TooLittleError: so few that noise cannot be told from a gap.
    """
    if len(kept) < FEWEST_POSES:
        raise TooLittleError("gap-too-few-poses", poses=len(kept), needed=FEWEST_POSES)
    g, R, t, w = poses.g[kept], poses.rotation[kept], poses.t[kept], wrench[kept]
    phase = np.array([hold_label(each) for each in g]) if recording.phase is None else recording.phase[kept]
    V = regressor_of(-g, np.zeros((len(g), 3, 3)))
    known = recording.reference_of_whole
    each = csr_array(eye_array(len(t)))
    noise = noise_of_poses(t, R, w, recording.sensor.noise_std)
    return Basis(
        replace(poses.take(kept), jitter_s=0.0),  # nothing moves while they are read
        noise,
        tuple(Segment(k, k + 1, str(name)) for k, name in enumerate(phase)),
        replace(scene_of_poses(recording, poses, phase, kept), noise=noise.std),
        w,
        V,
        None if known is None else known.phi,
        find_zero_std(recording),
        each,
        each,
        csr_array(each.shape),
        Rows(t, poses.period, each, np.zeros(len(t), dtype=np.intp)),
    )


def noise_of_poses(t: Array, rotation: Array, wrench: Array, stated: Array | None) -> WrenchNoise:
    """Noise of one pose's wrench: what is left of wrenches (N, 6) when each channel may be linear in the sensor's attitude (N, 3, 3) and in
    time t (N,), as it is under any gravity, with any rigid payload, on any linear sensor that drifts; no more than is stated of one
    sample (6,)."""
    columns = np.column_stack((rotation.reshape(len(t), 9), np.ones(len(t)), t - t.mean()))
    left = wrench - columns @ np.linalg.lstsq(columns, wrench, rcond=None)[0]
    std = np.sqrt(np.square(left).sum(axis=0) / (len(t) - columns.shape[1]))
    std = np.maximum(std if stated is None else np.minimum(std, stated), 1e-9)
    return WrenchNoise(std, np.ones(6), measured=True)


def build_unchecked_basis(recording: Recording, poses: Poses, wrench: Array) -> Basis:
    """The basis of a recording with its poses and wrench (N, 6), whether it can say anything or not."""
    motion, speed = smooth_motion(poses, window_s=SMOOTHING_S)
    segments = cut_at_gaps(segments_of(recording, motion, speed), recording.t)
    still = motionless(recording.t, segments)
    fresh = find_fresh(wrench)
    rows = np.arange(len(wrench)) if fresh is None else fresh.rows
    noise = find_fresh_noise(recording.t, wrench, still, segments, rows, nominal_std=recording.sensor.noise_std) or unknown_noise()
    raw = RawFeatures(poses)
    grid = max(GRID_S, poses.period, float(np.ptp(poses.t)) / MOST_INSTANTS)
    narrow = max(NARROW_S, 4.0 * poses.period, NARROW_INSTANTS * grid)
    ends = [poses.t[part][[0, -1]] for part in stretches(poses.t)]
    t = np.concatenate([np.arange(first + 2.0 * narrow, last - 2.0 * narrow, grid) for first, last in ends])
    spread = reading = window_matrix(t, narrow, poses.t)
    g, a, B = (np.asarray(spread @ x.reshape(len(poses.t), -1)).reshape(len(t), *x.shape[1:]) for x in (poses.g, raw.a, raw.B))
    omega = interpolate(t, poses.t, motion.omega)
    scene = replace(scene_of(recording, poses, Motion(g, a, omega, axial(B)), segments, t), window=narrow)
    known = recording.reference_of_whole
    reference = None if known is None else known.phi
    V, equations = regressor_of(a - g, B), window_rows(poses, t, 1.0 if fresh is None else fresh.every)
    if fresh is not None:
        # At uneven rows second differences let the noise of the poses through: what the lines between change is seen on the smooth motion.
        reading = csr_array(spread @ fresh.between)
        V += ((reading - spread) @ regressor(motion).reshape(len(poses.t), -1)).reshape(V.shape)
    if poses.position is None or is_broken(poses.t):
        equations = _take_rest(equations, g, np.asarray(spread @ still.astype(float)))
    if equations.at_rest:
        V = regressor_of(-g, np.zeros_like(B))
    twists = None if scene.jacobian is None or scene.dq is None else find_joint_twists(scene.jacobian, scene.dq)
    scene = replace(scene, noise=noise.std, residual_window=equations.step, joint_twists=twists, joint_waves=JointWaves())
    measured, zero_std = np.asarray(reading @ wrench), find_zero_std(recording)
    return Basis(poses, noise, segments, scene, measured, V, reference, zero_std, spread, reading, raw.difference, equations)


def _take_rest(rows: Rows, g: Array, still: Array) -> Rows:
    """The windows in which nothing moves, where they hold enough; else all of them, about one place.

    Args:
        g: (N, 3), gravity in the sensor's axes, on the grid. still: (N,), share of the samples behind each that are at rest.
    """
    rests = np.flatnonzero(rows.average @ still > 1.0 - 1e-9)
    holds = np.split(rests, np.flatnonzero(np.diff(rests) > 1) + 1)
    turned = np.array([(rows.average[hold] @ g).mean(axis=0) for hold in holds if len(hold)])
    if len(turned) < FEWEST_HOLDS or np.linalg.svd(turned - turned.mean(axis=0), compute_uv=False)[1] < TURNED_M_S2 * np.sqrt(len(turned)):
        return rows
    return replace(rows, centres=rows.centres[rests], average=csr_array(rows.average[rests]), part=rows.part[rests], at_rest=True)


def find_zero_std(recording: Recording) -> float:
    """Standard uncertainty of the joints' zeros, rad: as stated, or assumed."""
    return ZERO_STD_RAD if recording.zero_std_rad is None else max(recording.zero_std_rad, LEAST_ZERO_STD_RAD)


def segments_of(recording: Recording, motion: Motion, speed: Array) -> tuple[Segment, ...]:
    """Motions by their labels, or found."""
    if recording.phase is not None:
        return segments_of_phase(recording.phase)
    return segments_of_motion(recording.t, motion.omega, speed, motion.g, threshold=np.array([0.01, 0.005]))
