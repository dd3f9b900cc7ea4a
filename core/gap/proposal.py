"""Which motion to make next: the one that settles the worst tie in the least robot time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.gap.answer import Experiment
from core.gap.candidate_motions import CandidateMotion, candidates, second_payload
from core.gap.prediction import Prediction
from core.gap.rehearsal import rehearse
from core.gap.tie import INSEPARABLE_SIGMA, Tie
from core.gap.windows import Windows
from core.recording.recording import Recording

CLEAR_SIGMA = 6.0
"""Distance from which one name can be given; of motions that reach it the one with most sigmas per second is taken."""
FEWEST = 3
"""Motions that planning may try, one after the other, before it refuses the experiment."""


@dataclass(frozen=True)
class Proposal:
    """A motion with what it is predicted to do.

    Args:
        ties: that it splits, the worst first.
        before, after: distance of the worst tie, sigma, now and with both recordings together.
        seconds: of the robot.
    """

    motion: CandidateMotion
    ties: tuple[Tie, ...]
    before: float
    after: float
    seconds: float

    @property
    def worth(self) -> tuple[bool, float]:
        """What is clear goes before what is not; then by the gain per second, or by the distance."""
        clear = self.after >= CLEAR_SIGMA
        return clear, (self.after - self.before) / self.seconds if clear else self.after

    @property
    def alone(self) -> float:
        """Distance that the motion by itself puts between the two of the worst tie, sigma."""
        return float(np.sqrt(max(0.0, self.after**2 - self.before**2)))

    @property
    def answer(self) -> Experiment:
        """As it leaves the engine."""
        return Experiment(
            id=self.motion.id,
            motion=self.motion.sentence,
            stops=list(self.motion.stops),
            splits=[(tie.first.name, tie.second.name) for tie in self.ties],
            sigma_before=self.before,
            sigma_after=self.after,
            seconds=self.seconds,
        )


def proposals(recording: Recording, windows: Windows, ties: Sequence[Tie]) -> tuple[Proposal, ...]:
    """What to do about ties, best first; the second payload alone where no motion splits the worst of them.

    Nothing where all of them are clear already: what is in doubt then is the shape of the models, and no motion settles that. A motion is
    proposed only where it alone puts the worst tie apart by what makes two explanations separable; what both recordings reach together may
    be what the first has already.
    """
    open_ones = [tie for tie in ties if tie.distance_sigma < CLEAR_SIGMA]
    if not open_ones or windows.basis.scene.position is None:  # nobody knows how the sensor would be accelerated
        return ()
    tried = [
        predict_by_kinematics(recording, windows, motion, open_ones)
        for motion in candidates(recording, windows.basis.segments, windows.basis.poses.g)
    ]
    useful = sorted((it for it in tried if it.alone >= INSEPARABLE_SIGMA), key=lambda it: it.worth, reverse=True)
    if useful:
        return tuple(useful[:FEWEST])
    worst = min(open_ones, key=lambda tie: tie.distance_sigma)
    return (_with_second_payload(recording, worst, max((it.after for it in tried), default=worst.distance_sigma)),)


def predict_by_kinematics(recording: Recording, windows: Windows, motion: CandidateMotion, ties: Sequence[Tie]) -> Proposal:
    """What a motion would do, by kinematics alone."""
    return predict_along_path(rehearse(recording, windows.basis.poses, motion.stops), windows, motion, ties)


def predict_along_path(path: Recording, windows: Windows, motion: CandidateMotion, ties: Sequence[Tie]) -> Proposal:
    """What a motion would do to ties along a path, rehearsed or planned (its wrench is not looked at)."""
    ordered = sorted(ties, key=lambda tie: tie.distance_sigma)
    prediction = Prediction(windows, path, ordered[0].first)
    after = [float(np.hypot(tie.distance_sigma, prediction.distance_sigma(tie.first, tie.second))) for tie in ordered]
    split = tuple(tie for tie, sigma in zip(ordered, after, strict=True) if tie is ordered[0] or sigma >= INSEPARABLE_SIGMA)
    return Proposal(motion, split, ordered[0].distance_sigma, after[0], prediction.seconds)


def _with_second_payload(recording: Recording, tie: Tie, best: float) -> Proposal:
    """The request for a second payload. What that tells depends on the payload; the distance stated is what the best motion reaches."""
    return Proposal(second_payload(best), (tie,), tie.distance_sigma, best, float(recording.t[-1] - recording.t[0]))
