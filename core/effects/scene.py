"""The nominal run that effects are applied to: kinematics, payload and joints, one row per sample on a uniform grid."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.effects.joint_twists import JointTwists
from core.effects.joint_waves import JointWaves
from core.effects.link_loads import LazyLinkLoads
from core.effects.memory import Memory, Past
from core.payload.inertia import Motion, spatial_inertia
from core.payload.rigid_wrench import wrench

PER_ROW = ("t", "phase", "motion", "rotation", "position", "q", "dq", "jacobian", "torque", "links", "temperature", "shaking")

LEVEL_RAD, STILL_RAD, STILL_M = 0.02, 0.005, 0.002


@dataclass(frozen=True)
class Scene:
    """What the twin knows of a run; sensor frame unless said otherwise, SI.

    Args:
        t: (N,), uniform, s.
        phase: (N,), text as in a recording.
        motion: nominal kinematics of the sensor frame, without lag.
        rotation: (N, 3, 3), sensor axes in the base frame.
        position: (N, 3), sensor origin in the base frame; None where unknown.
        gravity: (3,), nominal, base frame.
        phi: (10,), payload as estimated together with the effects.
        q, dq: (N, n), joints; None for a recording of poses.
        jacobian: (N, 6, n), linear over angular velocity of the sensor frame in sensor axes; None likewise.
        torque: (N, n), measured joint torques, N m; None where there are none.
        links: of the arm without payload; None where its masses are not known.
        temperature: (N,), degC, None where not recorded.
        range, resolution: (6,), of the sensor, None where unknown.
        noise: (6,), standard deviation of the wrench's noise, N and N m; None where unknown.
        step: period of the samples, s; the first two times tell where absent. A scene of one row must state it.
        window: knot spacing of the cubic B-splines that motion and readings are means over, s; 0 where they are samples.
        residual_window: the same of what residuals on its rows are means over, beyond that; 0 where they are as fine as the rows.
        memory: of the rows before the first, for a run that is simulated in blocks; None for a run as a whole.
        joint_twists: of this run as a whole, where much is fitted to it; worked out whenever it is asked for where absent.
        joint_waves: of errors that repeat with a joint's angle, likewise.
        apart: whether each row is a pose by itself, and nothing is known of the way from one to the next.
        shaking: (N, n), rad/s2, accelerations of the links that springs in the joints have to bear beside those of the motors; None where
            there are none.
    """

    t: Array
    phase: NDArray[np.str_]
    motion: Motion
    rotation: Array
    position: Array | None
    gravity: Array
    phi: Array
    q: Array | None = None
    dq: Array | None = None
    jacobian: Array | None = None
    torque: Array | None = None
    links: LazyLinkLoads | None = None
    temperature: Array | None = None
    range: Array | None = None
    resolution: Array | None = None
    noise: Array | None = None
    step: float | None = None
    window: float = 0.0
    residual_window: float = 0.0
    memory: Memory | None = None
    joint_twists: JointTwists | None = None
    joint_waves: JointWaves | None = None
    apart: bool = False
    shaking: Array | None = None

    def __len__(self) -> int:
        return len(self.t)

    @property
    def hardly_turns(self) -> bool:
        """Whether gravity keeps its direction in the sensor, as with a palletiser, so that it does not tell payload from offsets."""
        return bool(np.ptp(self.motion.g, axis=0).max() < LEVEL_RAD * np.linalg.norm(self.gravity))

    @property
    def moves(self) -> bool:
        """Whether the sensor goes anywhere, or turns."""
        goes = self.position is not None and np.ptp(self.position, axis=0).max() > STILL_M
        return bool(goes or np.ptp(self.rotation, axis=0).max() > STILL_RAD)

    def __getitem__(self, rows: slice) -> Scene:
        """Some rows of the run, which keep its period."""
        cut: dict[str, Any] = {name: None if (x := getattr(self, name)) is None else x[rows] for name in PER_ROW}
        return replace(self, step=self.period, joint_twists=None, joint_waves=None, **cut)

    @property
    def period(self) -> float:
        """s."""
        return float(self.t[1] - self.t[0]) if self.step is None else self.step

    @property
    def elapsed(self) -> Array:
        """(N,), since the run's first row, s."""
        return np.asarray(self.t - self.past("start").first(self.t))

    def past(self, name: str) -> Past:
        """What the operator of this name remembers of the rows before the first."""
        return Past() if self.memory is None else self.memory[name]

    @cached_property
    def nominal(self) -> Array:
        """(N, 6), the wrench that the payload asks of the sensor, Eq. (1)."""
        return wrench(self.motion, self.phi)

    @cached_property
    def joint_inertia(self) -> Array:
        """(N, n, n), of arm and payload in joint coordinates, kg m2; of the payload alone where the arm's masses are not known."""
        if self.jacobian is None:
            raise ValueError("inertia in joint coordinates needs a scene with joints (see Effect.explain_lack)")
        size, axes = np.linalg.eigh(spatial_inertia(self.phi))
        body = (axes * np.maximum(size, 0.0)) @ axes.T  # a trial payload of a fit may be no body, which would swing without end
        payload = self.jacobian.transpose(0, 2, 1) @ (body @ self.jacobian)
        return np.asarray(payload if self.links is None else payload + self.links.loads.inertia)

    @cached_property
    def joint_load(self) -> Array:
        """(N, n), N m, that arm and payload ask of the joints; the payload alone where the arm's masses are not known."""
        if self.jacobian is None:
            raise ValueError("joint torques need a scene with joints (see Effect.explain_lack)")
        payload = np.einsum("ni,nij->nj", self.nominal, self.jacobian)
        return np.asarray(payload if self.links is None else payload + self.links.loads.torque)

    def with_phi(self, phi: Array) -> Scene:
        """The same run with another payload."""
        return replace(self, phi=phi)

    def with_motion(self, motion: Motion) -> Scene:
        """The same run and payload, the sensor moved otherwise; the inertia of arm and payload, which takes long, is the same."""
        moved = replace(self, motion=motion)
        if "joint_inertia" in vars(self):
            vars(moved)["joint_inertia"] = self.joint_inertia
        return moved

    def with_shaking(self, shaking: Array) -> Scene:
        """The same run and payload, with joints that are shaken, (N, n), rad/s2."""
        shaken = replace(self, shaking=shaking)
        vars(shaken).update(nominal=self.nominal, joint_inertia=self.joint_inertia, joint_load=self.joint_load)
        return shaken

    def turn_motion(self, error: Array) -> Motion:
        """Kinematics when the true sensor axes are turned by the small rotation vectors `error` (N, 3), sensor axes.

        Gravity and accelerations are the same vectors seen in turned axes; what the change of `error` itself adds to them is left out:
        it is slow against the motion.
        """
        m = self.motion
        return Motion(
            m.g - np.cross(error, m.g),
            m.a - np.cross(error, m.a),
            m.omega - np.cross(error, m.omega),
            m.alpha - np.cross(error, m.alpha),
        )
