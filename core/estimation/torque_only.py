"""Recordings without a wrist wrench: what can and cannot be said from joint torques."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.estimation.estimate import Identification, PaperEstimate, TimeSeries
from core.estimation.kinematics import Poses, smooth_motion
from core.estimation.segments import segments_of_motion, segments_of_phase
from core.recording.recording import Recording
from core.words.message import Message

SMOOTHING_S = 0.05


def torque_only(recording: Recording, poses: Poses | None) -> Identification:
    """The answer without estimate: the recording is read and checked, and what it lacks is named."""
    nan = np.full(10, np.nan)
    paper = PaperEstimate(nan, nan, np.full(6, np.nan))
    lacks, needed = (
        ("estimation-no-wrench", "estimation-wrench-needed")
        if recording.wrench is None
        else ("estimation-no-motion", "estimation-motion-needed")
    )
    verdict, warnings = Message.of("estimation-nothing-determined", reason=Message.of(lacks)), (Message.of(needed),)
    if poses is None:
        return Identification(paper, None, verdict, warnings, bounds=tuple(_torques(recording)))
    motion, speed = smooth_motion(poses, window_s=SMOOTHING_S)
    segments = (
        segments_of_phase(recording.phase)
        if recording.phase is not None
        else segments_of_motion(recording.t, motion.omega, speed, motion.g, threshold=np.array([0.01, 0.005]))
    )
    said = [*_motion(recording, motion.omega, motion.alpha, motion.g), *_torques(recording)]
    return Identification(paper, None, verdict, warnings, segments, bounds=tuple(said), drawn=lambda: TimeSeries(recording.t, motion))


def _motion(recording: Recording, omega: Array, alpha: Array, g: Array) -> list[Message]:
    duration = float(recording.t[-1] - recording.t[0])
    rate = (len(recording) - 1) / duration if duration > 0 else 0.0
    said = [Message.of("estimation-read", lasts_s=duration, rate_hz=rate)]
    if recording.q is not None:
        spans = [Message.of("estimation-joint-span", span_rad=float(span)) for span in np.ptp(recording.q, axis=0)]
        said.append(Message.of("estimation-joint-spans", spans=spans))
    speed, acceleration = (float(np.percentile(np.linalg.norm(x, axis=1), 99)) for x in (omega, alpha))
    spread = float(np.linalg.eigvalsh(np.cov(g.T))[0] ** 0.5 / np.linalg.norm(recording.gravity))
    lively = "estimation-lively" if spread > 0.1 and acceleration > 1.0 else "estimation-hardly-lively"
    said.append(Message.of(lively, turns_rad_s=speed, turns_rad_s2=acceleration, spread=spread))
    return said


def _torques(recording: Recording) -> list[Message]:
    if recording.tau is None:
        return []
    largest = [Message.of("estimation-joint-torque", torque_n_m=float(torque)) for torque in np.abs(recording.tau).max(axis=0)]
    return [Message.of("estimation-joint-torques", torques=largest)]
