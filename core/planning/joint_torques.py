"""What torques a plan asks of the joints with the load that is stated, against the URDF's `effort`.

Recursive Newton-Euler over every set point, with finite differences of the set points as they will be commanded, and the friction that the
cell states. The drives' own inertia is in no URDF and is left out; at the accelerations of a plan it is some per cent.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell, Payload
from core.cell.tools import add_cell_tools
from core.cell.urdf import check_urdf
from core.errors import TooHeavy
from core.payload.inertia import InertialParameters
from core.planning.summary import LargestTorque, PlanTorques
from core.robot.dynamics import LinkDynamics
from core.robot.model import RobotModel
from core.robot.trajectory import JointTrajectory
from core.second_opinion.opinion import JointPath
from core.second_opinion.part_name import name_part
from core.words.message import Message

HOLDING_SHARE = 0.9
"""Of a joint's torque: what holding still may take where a pose is chosen. The rest is for moving."""

MOVING_SHARE = 0.98
"""Of a joint's torque: what a transfer may take before it is made slower."""

MOVING_RAD_S = 1e-4
"""A joint that is slower stands, and has no friction to overcome."""


@dataclass(frozen=True)
class Load:
    """What the robot is taken to carry.

    Args:
        parameters: sensor frame.
        source: where that is from.
    """

    parameters: InertialParameters
    source: Message


def find_known_load(cell: Cell, name: str | None) -> Load | None:
    """A payload that the cell knows by name; None where it knows none of that name."""
    return describe_known_load(name or "", cell.payloads.get(name or ""))


def describe_known_load(name: str, known: Payload | None) -> Load | None:
    """What is known of a payload; None where nothing is."""
    return None if known is None else Load(known.parameters, Message.of("planning-load-known", payload=name))


def even_load(box: Box, mass_kg: float, source: Message) -> Load:
    """A mass spread evenly over a box (sensor frame)."""
    size = np.array(box.size_m)
    inertia = box.pose.rotation @ np.diag(mass_kg / 12.0 * (size @ size - size**2)) @ box.pose.rotation.T
    return Load(InertialParameters.from_com(mass_kg, box.pose.translation, inertia), source)


def guess_load(cell: Cell, box: Box, mass_guess_kg: float) -> Load:
    """A payload of which only the box is known: as heavy as the cell says that the robot may carry, otherwise the guess."""
    limit = cell.robot.payload_limit_kg
    if limit is None:
        return even_load(box, mass_guess_kg, Message.of("planning-load-guessed"))
    return even_load(box, limit, Message.of("planning-load-payload-limit"))


class JointTorques:
    """The torques of one cell's robot with one load and the cell's tools, and its joints' limits.

    A joint is not judged where the URDF states no torque for it (`effort` 0), or no mass for something that it carries.
    """

    def __init__(self, cell: Cell, robot: RobotModel, load: Load) -> None:
        self.load = load
        self._dynamics = LinkDynamics(robot, cell.gravity, add_cell_tools(cell, load.parameters))
        self._joints = robot.description.joints
        effort = {joint.name: joint.effort or 0.0 for joint in check_urdf(cell.urdf, str(cell.folder / cell.robot.urdf)).joints}
        self._limits = np.array([effort[joint] for joint in self._joints])
        friction = cell.robot.friction
        self._coulomb = np.zeros(robot.n) if friction is None else np.array(friction.coulomb_n_m)
        self._viscous = np.zeros(robot.n) if friction is None else np.array(friction.viscous_n_m_s)
        masses = np.array([inertia.mass for inertia in robot.model.inertias])[-robot.n :]
        self._why = [self._explain_unjudged(j, masses) for j in range(robot.n)]
        self._judged = np.flatnonzero([why is None for why in self._why])

    def _explain_unjudged(self, j: int, masses: Array) -> Message | None:
        """Why the torque of a joint cannot be judged; None where it can."""
        if self._limits[j] <= 0.0:
            return Message.of("planning-joint-without-effort", joint=self._joints[j])
        without = next((self._joints[k] for k in range(j, len(masses)) if masses[k] <= 0.0), None)
        return None if without is None else Message.of("planning-joint-without-mass", joint=self._joints[j], after=without)

    def too_weak_to_hold(self, q: Array) -> tuple[str, float] | None:
        """The joint that has the largest share of its torque to give to hold still at q (n,), and that share; None where all can."""
        if len(self._judged) == 0:
            return None
        shares = self._holding_shares(q[None])[0]
        most = int(np.argmax(shares))
        return (self._joints[self._judged[most]], float(shares[most])) if shares[most] > HOLDING_SHARE else None

    def holding_share(self, q: Array) -> float:
        """The largest share of its torque that any joint has to give to hold still at any row of q (N, n); 0 where none is judged."""
        return float(self._holding_shares(q).max(initial=0.0))

    def _holding_shares(self, q: Array) -> Array:
        """(N, judged joints)."""
        still = np.zeros_like(q)
        return np.asarray(np.abs(self._dynamics.torque(q, still, still)[:, self._judged]) / self._limits[self._judged])

    def suffice(self, trajectory: JointTrajectory) -> bool:
        """Whether every joint has the torque, and a little more, for a motion from standstill to standstill."""
        most = self.of([JointPath("", trajectory.q)], trajectory.period).largest
        return most is None or most.ratio <= MOVING_SHARE

    def of(self, paths: Sequence[JointPath], period: float) -> PlanTorques:
        """The largest share of its torque that a joint has to give, anywhere along motions from standstill to standstill.

        Args:
            paths: their set points; what holds lie between them ask for no more than their ends.
            period: between set points, s.
        """
        largest = [self._largest(path, period) for path in paths] if len(self._judged) else []
        return PlanTorques(
            load=self.load.source,
            mass_kg=self.load.parameters.mass,
            largest=max(largest, key=lambda each: each.ratio, default=None),
            not_judged=[why for why in self._why if why is not None],
        )

    def _largest(self, path: JointPath, period: float) -> LargestTorque:
        padded = np.concatenate((path.q[:1], path.q, path.q[-1:]))
        dq = (padded[2:] - padded[:-2]) / (2.0 * period)
        ddq = np.diff(padded, 2, axis=0) / period**2
        friction = self._coulomb * np.where(np.abs(dq) > MOVING_RAD_S, np.sign(dq), 0.0) + self._viscous * dq
        torque = self._dynamics.torque(path.q, dq, ddq) + friction
        ratio = np.abs(torque[:, self._judged]) / self._limits[self._judged]
        row, column = (int(k) for k in np.unravel_index(np.argmax(ratio), ratio.shape))
        j = int(self._judged[column])
        still = np.zeros((1, len(padded[0])))
        return LargestTorque(
            joint=self._joints[j],
            torque_n_m=abs(float(torque[row, j])),
            holding_n_m=abs(float(self._dynamics.torque(path.q[row][None], still, still)[0, j])),
            limit_n_m=float(self._limits[j]),
            ratio=float(ratio[row, column]),
            part=path.name,
            time_s=row * period,
        )


def refuse_too_heavy(torques: PlanTorques) -> None:
    """Nothing where every joint that can be judged has enough torque.

    Raises:
        TooHeavy: the joint with the largest share has not.
    """
    most = torques.largest
    if most is not None and most.ratio > 1.0:
        raise TooHeavy(
            "planning-too-heavy",
            mass_kg=torques.mass_kg,
            joint=most.joint,
            torque_n_m=most.torque_n_m,
            limit_n_m=most.limit_n_m,
            holding_n_m=most.holding_n_m,
            time_s=most.time_s,
            part=name_part(most.part),
        )
