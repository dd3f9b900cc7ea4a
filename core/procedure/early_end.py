"""What a run leaves out because its target is met: repetitions, rotations, holds."""

from __future__ import annotations

from collections.abc import Sequence

from core.control.rotation import Rotation
from core.estimation.estimate import Estimate
from core.planning.plan import Leg, Plan
from core.planning.settings import Timing
from core.procedure.target_watch import TargetAnswer, TargetWatch
from core.requirement.target import Standing
from core.requirement.target_answer import LeftOutPart, TargetPart, hold_against_target
from core.sessions.sample_log import SampleLog


class EarlyEnd:
    """Asks for the target along a run, and keeps count of what need not be done any more.

    Args:
        watch: answers; None for a run without a target, which leaves nothing out.
        log: of the run's samples.
    """

    def __init__(self, watch: TargetWatch | None, log: SampleLog) -> None:
        self.watch, self._log = watch, log
        self._reached = False
        self._swings = 0
        self.made = 0
        """Holds and rotations that are recorded."""
        self._skipped = self._repetitions = 0
        self._saved_s = 0.0

    @property
    def reached(self) -> bool:
        """Whether the robot may go home; once it may, it stays so."""
        answer = self._newest
        self._reached = self._reached or (answer is not None and answer.standing is Standing.REACHED)
        return self._reached

    @property
    def left_out(self) -> LeftOutPart | None:
        """All that was left out; None where it was nothing."""
        if not self._repetitions and not self._skipped:
            return None
        planned = self.made + self._skipped
        return LeftOutPart(made=self.made, planned=planned, repetitions=self._repetitions, saved_s=self._saved_s)

    def look(self, rotation: Rotation, *, last: bool) -> float:
        """To be called while a rotation goes on: asks after each swing, and ends it with the swing under way where it has told enough.

        Args:
            last: whether it is the last rotation of the plan; what comes after others may still make type B smaller.

        Returns:
            Robot time that this saves, s.
        """
        if self.watch is None:
            return 0.0
        if rotation.repetitions_done > self._swings:
            self._swings = rotation.repetitions_done
            if self.watch.asks_in_motion:
                self.watch.ask(self._log)
        answer, about = self._newest, "xyz"[rotation.axis]
        if answer is None or not (about in answer.turned_enough or self.reached or (last and answer.standing is Standing.TYPE_B)):
            return 0.0
        before_s = rotation.profile.duration
        self._repetitions += rotation.end_early()
        saved_s = before_s - rotation.profile.duration
        self._saved_s += saved_s
        return saved_s

    def count_motion(self) -> None:
        """A hold or a rotation is recorded."""
        self.made += 1
        self._swings = 0
        if self.watch is not None and not self.reached:
            self.watch.ask(self._log)

    def skip_rest(self, leg: Leg, timing: Timing, made: int) -> float:
        """Counts what of a leg is left out after its first `made` holds and rotations; robot time that this saves, s."""
        lasts_s = [timing.hold_s] if leg.moving_s == 0.0 else [timing.hold_s, leg.moving_s, timing.settle_s]
        left_s = lasts_s[made:]
        self._skipped += len(left_s)
        if leg.profile is not None and made < 2:
            self._repetitions += len(leg.profile.rests)
        self._saved_s += sum(left_s)
        return sum(left_s)

    def skip_legs(self, plan: Plan, k: int) -> None:
        """Counts what is left out where the robot takes the way home of leg `k`."""
        for leg in plan.legs[k + 1 :]:
            self._saved_s += leg.transfer.trajectory.duration
            self.skip_rest(leg, plan.timing, 0)
        way = plan.legs[k].home
        if way is not None:
            self._saved_s += plan.home.trajectory.duration - way.transfer.trajectory.duration

    def answer_target(self, estimate: Estimate | None) -> TargetPart | None:
        """How far the run's estimate meets its target, with what was left out; None where it has none."""
        return None if self.watch is None else hold_against_target(self.watch.check, estimate, self.left_out)

    @property
    def _newest(self) -> TargetAnswer | None:
        return None if self.watch is None else self.watch.newest()


def is_last_turn(leg: Leg, plan: Plan) -> bool:
    """Whether no rotation comes after that of this leg."""
    turns: Sequence[Leg] = [each for each in plan.legs if each.profile is not None]
    return bool(turns) and turns[-1] is leg
