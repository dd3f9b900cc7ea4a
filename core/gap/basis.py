"""From a recording to the basis of its diagnosis: poses, windows, noise, motions, and the nominal run that effects are applied to."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.array import Array
from core.errors import HeftError
from core.estimation.kinematics import Poses, axial, poses_of, smooth_motion
from core.estimation.noise import sensor_noise, unknown_noise
from core.estimation.scene import scene_of
from core.estimation.segments import Segment, cut_at_gaps, motionless, segments_of_motion, segments_of_phase, stretches
from core.estimation.weak_form import RawFeatures, regressor_of
from core.gap.windows import Basis, window_matrix
from core.payload.inertia import Motion
from core.recording.recording import Recording

GRID_S = 0.005
"""Period of the scene that effects are applied to."""
SMOOTHING_S = 0.036
"""Of the motion that effects act on: short enough for the corners of a trapezoid, long enough for the encoders' noise."""
SHORTEST_S = 3.0
NARROW_S = 0.0125
"""Knot spacing of the narrow windows."""
SLOWEST_PERIOD_S = 0.02
NOTHING_MOVES_RAD = 0.02


class TooLittleError(HeftError):
    """The recording is too short or too still to say anything about a gap."""


def basis_of(recording: Recording) -> Basis:
    """The basis of one recording.

    Raises:
        TooLittleError: no wrench, no motion, or too few samples.
    """
    poses = poses_of(recording)
    if recording.wrench is None:
        raise TooLittleError("gap-no-wrench")
    if poses is None:
        raise TooLittleError("gap-no-motion")
    if poses.period > SLOWEST_PERIOD_S or len(recording) < 200:
        raise TooLittleError("gap-poses-only", samples=len(recording), rate_hz=1.0 / poses.period)
    if recording.t[-1] - recording.t[0] < SHORTEST_S:
        lasts_s = float(recording.t[-1] - recording.t[0])
        raise TooLittleError("gap-too-short", lasts_s=lasts_s)
    if float(np.ptp(poses.g, axis=0).max()) < NOTHING_MOVES_RAD * 9.81:
        raise TooLittleError("gap-hardly-turns")
    return build_unchecked_basis(recording, poses, recording.wrench)


def build_unchecked_basis(recording: Recording, poses: Poses, wrench: Array) -> Basis:
    """The basis of a recording with its poses and wrench (N, 6), whether it can say anything or not."""
    motion, speed = smooth_motion(poses, window_s=SMOOTHING_S)
    segments = cut_at_gaps(segments_of(recording, motion, speed), recording.t)
    still = motionless(recording.t, segments)
    noise = sensor_noise(recording.t, wrench, still, segments, nominal_std=recording.sensor.noise_std) or unknown_noise()
    raw = RawFeatures(poses)
    grid = max(GRID_S, poses.period)
    narrow = max(NARROW_S, 4.0 * poses.period)
    ends = [poses.t[part][[0, -1]] for part in stretches(poses.t)]
    t = np.concatenate([np.arange(first + 2.0 * narrow, last - 2.0 * narrow, grid) for first, last in ends])
    spread = window_matrix(t, narrow, poses.t)
    g, a, B = (np.asarray(spread @ x.reshape(len(poses.t), -1)).reshape(len(t), *x.shape[1:]) for x in (poses.g, raw.a, raw.B))
    omega = np.column_stack([np.interp(t, poses.t, channel) for channel in motion.omega.T])
    scene = replace(scene_of(recording, poses, Motion(g, a, omega, axial(B)), segments, t), window=narrow)
    known = recording.reference_of_whole
    reference = None if known is None else known.phi
    return Basis(poses, noise, segments, scene, np.asarray(spread @ wrench), regressor_of(a - g, B), reference, spread, raw.difference)


def segments_of(recording: Recording, motion: Motion, speed: Array) -> tuple[Segment, ...]:
    """Motions by their labels, or found."""
    if recording.phase is not None:
        return segments_of_phase(recording.phase)
    return segments_of_motion(recording.t, motion.omega, speed, motion.g, threshold=np.array([0.01, 0.005]))
