"""Holds what a run has recorded so far against its target while it goes on, by the same estimator as its result."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

from core.estimation.identification import identify_recording
from core.planning.stop import AXES
from core.requirement.target import Standing, TargetCheck
from core.sessions.sample_log import SampleLog
from core.twin.twin import Twin

ON_THE_WAY = 0.95
"""Share of the target that has to be enough on the way, so that the result, with a few more samples, meets all of it."""
OF_ONE_TURN = 0.7
"""The same of what one rotation tells, whose errors add to those of the others."""


@dataclass(frozen=True)
class TargetAnswer:
    """How far the samples up to some moment meet the target.

    Args:
        standing: of all that it names.
        turned_enough: sensor axes about which further rotations would tell nothing that is still wanted, `xz` for example.
    """

    standing: Standing
    turned_enough: str


def answer_target(log: SampleLog, check: TargetCheck, twin: Twin) -> TargetAnswer:
    """The answer of the samples of a log."""
    estimate = identify_recording(log.recording(), twin).estimate
    if estimate is None:
        return TargetAnswer(Standing.OPEN, "")
    alone = estimate.repeatability.covariance
    turns = {axis: check.find_standing_of_turns(estimate.phi, alone, axis, share=OF_ONE_TURN) for axis in AXES}
    enough = "".join(axis for axis, found in turns.items() if found.standing is Standing.REACHED)
    return TargetAnswer(check.find_standing(estimate, alone, share=ON_THE_WAY).standing, enough)


class TargetWatch(ABC):
    """Somebody who is asked at the end of each hold and of each swing, and answers when the estimate is done."""

    asks_in_motion = True
    """Whether asking takes no time of who asks, so that it may be done while the robot moves."""

    def __init__(self, check: TargetCheck) -> None:
        self.check = check

    @abstractmethod
    def ask(self, log: SampleLog) -> None:
        """Asks of the samples so far."""

    @abstractmethod
    def newest(self) -> TargetAnswer | None:
        """The newest answer; None where there is none yet."""


class WatchHere(TargetWatch):
    """Answers at once, in this process: who asks waits.

    Args:
        twin: of the cell.
        clock_waits: whether the robot's clock stands meanwhile, as it does where a simulation goes as fast as it can.
    """

    def __init__(self, check: TargetCheck, twin: Twin, *, clock_waits: bool) -> None:
        super().__init__(check)
        self.asks_in_motion = clock_waits
        self._twin = twin
        self._newest: TargetAnswer | None = None

    def ask(self, log: SampleLog) -> None:
        """Estimates now."""
        self._newest = answer_target(log, self.check, self._twin)

    def newest(self) -> TargetAnswer | None:
        """Of the last time it was asked."""
        return self._newest
