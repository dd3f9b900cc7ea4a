"""Recordings without a wrist wrench: what can and cannot be said from joint torques."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.estimation.estimate import Identification, PaperEstimate, TimeSeries
from core.estimation.kinematics import Poses, smooth_motion
from core.estimation.segments import segments_of_motion, segments_of_phase
from core.recording.recording import Recording
from core.remark import Remark

Array = NDArray[np.float64]

SMOOTHING_S = 0.05
NEEDED = Remark(
    "wrench_needed",
    "a payload follows from joint torques only together with the arm's own parameters (link masses, first moments, inertias and friction), "
    "or with a recording of the same motion without the payload; or record the wrench of a wrist sensor",
)
MOTION_NEEDED = Remark("motion_needed", "record joint positions or sensor poses beside the wrench")


def torque_only(recording: Recording, poses: Poses | None) -> Identification:
    """The answer without estimate: the recording is read and checked, and what it lacks is named."""
    nan = np.full(10, np.nan)
    paper = PaperEstimate(nan, nan, np.full(6, np.nan))
    lacks = "no wrench of a wrist sensor" if recording.wrench is None else "neither joints nor poses beside the wrench"
    verdict = f"The payload is not determined: the recording has {lacks}."
    warnings = (NEEDED,) if recording.wrench is None else (MOTION_NEEDED,)
    if poses is None:
        return Identification(paper, None, verdict, warnings, bounds=tuple(_torques(recording)))
    motion, speed = smooth_motion(poses, window_s=SMOOTHING_S)
    segments = (
        segments_of_phase(recording.phase)
        if recording.phase is not None
        else segments_of_motion(recording.t, motion.omega, speed, motion.g, threshold=np.array([0.01, 0.005]))
    )
    said = [*_motion(recording, motion.omega, motion.alpha, motion.g), *_torques(recording)]
    return Identification(paper, None, verdict, warnings, segments, TimeSeries(recording.t, motion), bounds=tuple(said))


def _motion(recording: Recording, omega: Array, alpha: Array, g: Array) -> list[str]:
    duration = float(recording.t[-1] - recording.t[0])
    rate = (len(recording) - 1) / duration if duration > 0 else 0.0
    said = [f"{duration:.1f} s at {rate:.0f} Hz were read and are free of gaps and non-finite values"]
    if recording.q is not None:
        span = np.degrees(np.ptp(recording.q, axis=0))
        said.append(f"the joints move through {', '.join(f'{s:.0f}' for s in span)} deg")
    fast = np.percentile(np.linalg.norm(omega, axis=1), 99), np.percentile(np.linalg.norm(alpha, axis=1), 99)
    spread = np.linalg.eigvalsh(np.cov(g.T))[0] ** 0.5 / np.linalg.norm(recording.gravity)
    enough = "enough" if spread > 0.1 and fast[1] > 1.0 else "hardly enough"
    said.append(
        f"the sensor frame turns with up to {fast[0]:.2f} rad/s and {fast[1]:.1f} rad/s2, gravity spreads over its weakest "
        f"axis by {100 * spread:.0f} % of its size: with a wrist sensor this motion would be {enough} for all ten parameters"
    )
    return said


def _torques(recording: Recording) -> list[str]:
    if recording.tau is None:
        return []
    largest = np.abs(recording.tau).max(axis=0)
    return [
        f"the joint torques reach {', '.join(f'{x:.1f}' for x in largest)} N m; arm, friction and payload together, "
        "of which the payload's share cannot be told"
    ]
