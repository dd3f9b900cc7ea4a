"""Collects a run's samples while it goes on, so that a recording can be closed at any moment."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable

import numpy as np

from core.cell.cell import Cell, Payload
from core.cell.tools import find_tools
from core.recording.order_reference import NO_ORDER, OrderReference
from core.recording.recording import Recording, SensorDescription, append_recording
from core.recording.stated_friction import read_friction
from core.robot.model import RobotModel
from core.sessions.session import RobotState

PATIENCE_S = 0.1
"""What comes later from a sensor than this after its moment is not recorded."""


class SampleLog:
    """Robot states with the phase in which each was taken, in the order of time.

    Args:
        before: a recording of the same robot that they continue.
        order: that they are made for.
        complete: gives a state its wrench where that has come since; states without one wait for it for `PATIENCE_S`.
    """

    def __init__(
        self,
        cell: Cell,
        robot: RobotModel,
        *,
        payload: str | None,
        reference: Payload | None,
        before: Recording | None = None,
        order: OrderReference = NO_ORDER,
        complete: Callable[[RobotState], RobotState] | None = None,
    ) -> None:
        self.cell = cell
        self.robot = robot
        self.payload = payload
        self.reference = reference
        self.before = before
        self.order = order
        self.states: list[RobotState] = []
        self.phases: list[str] = []
        self._complete = complete
        self._waiting: deque[tuple[RobotState, str]] = deque()

    def __len__(self) -> int:
        return len(self.states)

    @property
    def seconds(self) -> float:
        """From the first sample to the last, s."""
        return self.states[-1].t - self.states[0].t if self.states else 0.0

    def extend(self, states: Iterable[RobotState], phase: str) -> list[RobotState]:
        """Appends samples of one phase, but for those that no recording can hold: not finite, with a clock that stands still, or
        with a wrench that was not measured then.

        The guard stops the robot at such a sample, and its error carries it. Returns those whose turn has come, in the order of time:
        what was appended, and what was left out for want of a measured wrench.
        """
        self._waiting.extend((state, phase) for state in states)
        return self._settle(self._waiting[-1][0].t - PATIENCE_S if self._waiting else -np.inf)

    def _settle(self, until_s: float) -> list[RobotState]:
        """Takes states up to the first that lacks its wrench and may still wait for it."""
        taken: list[RobotState] = []
        while self._waiting:
            state, phase = self._waiting[0]
            if self._complete is not None and not state.wrench_measured:
                state = self._complete(state)
                if not state.wrench_measured and state.t > until_s:
                    break
            self._waiting.popleft()
            if not self._fits(state):
                continue
            taken.append(state)
            if state.wrench_measured:
                self.states.append(state)
                self.phases.append(phase)
        return taken

    def _fits(self, state: RobotState) -> bool:
        later = not self.states or state.t > self.states[-1].t
        finite = np.isfinite(state.t + state.q.sum() + state.dq.sum() + state.q_cmd.sum() + state.wrench.sum())
        return later and bool(finite) and (state.tau is None or bool(np.isfinite(state.tau).all()))

    def recording(self) -> Recording:
        """The samples so far, after those of the recording that they continue; none waits any longer."""
        self._settle(np.inf)
        return self._new() if self.before is None else append_recording(self.before, self._new())

    def _new(self) -> Recording:
        """Gravity is turned into the base frame, which the recording's URDF starts from."""
        states = self.states
        sensor = self.cell.sensor
        has_torque = bool(states) and all(state.tau is not None for state in states)
        has_temperature = bool(states) and all(state.temperature is not None for state in states)
        return Recording(
            t=np.array([state.t for state in states]),
            gravity=self.cell.gravity_in_base,
            wrench=np.array([state.wrench for state in states]),
            q=np.array([state.q for state in states]),
            dq=np.array([state.dq for state in states]),
            q_cmd=np.array([state.q_cmd for state in states]),
            tau=np.array([state.tau for state in states]) if has_torque else None,
            temperature=np.array([state.temperature for state in states]) if has_temperature else None,
            phase=np.array(self.phases),
            robot=self.robot.description,
            friction=read_friction(self.cell),
            sensor=SensorDescription(
                np.array(sensor.noise_std),
                np.array(sensor.range),
                np.array(sensor.resolution),
                calibration=sensor.calibration,
                mount_std_rad=sensor.mount_std_rad,
                name=sensor.name,
            ),
            zero_std_rad=self.cell.robot.zero_std_rad,
            encoder_std_rad=self.cell.robot.encoder_std_rad,
            site=self.cell.site,
            reference=None if self.reference is None else self.reference.parameters,
            reference_source=None if self.reference is None else self.reference.source,
            source="heft run",
            cell=self.cell.name,
            payload=self.payload,
            tools=find_tools(self.cell),
            order=self.order,
        )
