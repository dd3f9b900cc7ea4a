"""The torque of a joint reads something where there is nothing: its sensor's zero is off."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Finding, Parameter, Symptom, View
from core.effects.friction_fit import FrictionSignals, fit_joint
from core.recording.recording import Recording
from core.robot.model import RobotModel
from core.words.message import Message

OF_LIMIT, OF_SPREAD = 0.01, 0.05
"""Share of the joint's torque limit that is tolerated; where no limit is stated, of the spread of its torque."""
CERTAIN = 5.0
"""Standard deviations."""


class TorqueOffset(Symptom):
    """`tau_j = Y_j(q, dq, ddq) pi + A ddq_j + Fc sign(dq_j) + Fv dq_j + o`, per joint, over the samples in which it moves, as for friction.

    Sought where there is no wrist wrench, so that the torques are all that tells of the load. Material where an offset is more than 1 % of
    the joint's torque limit in the URDF; where none is stated, 5 % of the spread of its torque.
    """

    id = "torque_offset"
    title = Message.of("effect-torque-offset-title")
    stage = "actuation"
    side = "joints"

    def parameters(self, recording: Recording) -> tuple[Parameter, ...]:
        """The offset of each joint, N m."""
        joints = range(0 if recording.q is None else recording.q.shape[1])
        return tuple(Parameter(f"joint_{j + 1}_torque_offset_nm", "N m", 0.0, -1e3, 1e3, 1.0) for j in joints)

    def observe(self, recording: Recording, view: View) -> Finding | None:
        """The offsets; None with a wrench, without torques, or where no joint moves enough."""
        run = None if recording.wrench is not None or recording.tau is None else FrictionSignals.of(recording)
        if run is None or recording.robot is None:
            return None
        fits = [fit_joint(run, j) for j in range(run.q.shape[1])]
        if all(fit is None for fit in fits):
            return None
        offset, std = (np.array([np.nan if fit is None else getattr(fit, name) for fit in fits]) for name in ("offset", "offset_std"))
        tolerated = _find_tolerated(recording, run.spread)
        certain = np.nan_to_num(np.abs(offset) / std)
        times = np.nan_to_num(np.abs(offset) / tolerated)
        k = int(np.argmax(np.where(certain > CERTAIN, times, -1.0)))
        if certain[k] <= CERTAIN:
            return None
        seen = Message.of("symptom-torque-offset", joint=k + 1, offset_nm=offset[k], offset_std_nm=std[k], tolerated_nm=tolerated[k])
        return Finding(offset, std, float(certain[k]), bool(times[k] > 1.0), float(times[k]), seen)

    def advice(self, finding: Finding) -> Message:
        """Advises setting the torque sensors to zero anew."""
        return Message.of("advice-torque-offset")


def _find_tolerated(recording: Recording, spread: Array) -> Array:
    """(n,), N m."""
    assert recording.robot is not None
    limit = np.asarray(RobotModel(recording.robot).model.effortLimit)
    return np.where(limit > 0.0, OF_LIMIT * limit, OF_SPREAD * spread)
