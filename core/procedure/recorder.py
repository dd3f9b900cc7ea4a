"""Takes a run's samples: for its recording, and for the estimate along the way."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.estimation.online import OnlineEstimator
from core.sessions.sample_log import SampleLog
from core.sessions.session import RobotState

UNKNOWN: tuple[float | None, ...] = (None,) * 10


class Recorder:
    """Everything that a run measures, in the order of time.

    Args:
        log: takes the samples.
        online: estimates from them along the way; None where nobody would see that.
    """

    def __init__(self, log: SampleLog, online: OnlineEstimator | None = None) -> None:
        self.log, self.online = log, online

    def take(self, states: Sequence[RobotState], phase: str) -> None:
        """Samples of a motion; the estimate follows the joints through those whose wrench was not measured."""
        for state in self.log.extend(states, phase):
            if self.online is None:
                continue
            if state.wrench_measured:
                self.online.update(state.q, state.wrench)
            else:
                self.online.follow(state.q)

    def take_braking(self, states: Sequence[RobotState]) -> None:
        """Samples of a robot that brakes; nothing is estimated from them along the way."""
        self.log.extend(states, "transfer")

    @property
    def phi(self) -> tuple[float | None, ...]:
        """The estimate so far; None where a parameter is not yet known."""
        if self.online is None:
            return UNKNOWN
        return tuple(float(value) if np.isfinite(value) else None for value in self.online.so_far.phi)


def build_estimator(log: SampleLog, period: float) -> OnlineEstimator:
    """What estimates along the way from samples of a log's robot, one every `period` s."""
    cell = log.cell
    noise_std = np.array(cell.sensor.noise_std)
    return OnlineEstimator(log.robot, cell.gravity, period=period, noise_std=noise_std, encoder_std=cell.robot.encoder_std_rad)
