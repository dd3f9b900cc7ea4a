"""Friction in the joints: it shows in the joint torques, or else in the tracking error, and never in the wrist's wrench."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.effects.effect import Finding, Parameter, Symptom, View
from core.effects.friction_fit import BELOW, FrictionFit, FrictionSignals, bound_friction, fit_joint, noise_of, sigma_of, tracking_error
from core.recording.recording import Recording
from core.words.message import Message

Flags = NDArray[np.bool_]

LOUD, LEAST = 3.0, 0.02
"""Times the noise of one motionless sample, and share of the signal's spread, above which a torque stands out."""
CERTAIN = 5.0
"""Standard deviations by which friction is there, or differs."""
HALF = 0.5
"""Share of the stated friction by which it may differ."""
TRACKING = float(np.radians(0.5))
"""rad, tracking error above which friction matters whatever is stated."""
TINY = 1e-12


class JointFriction(Symptom):
    """`tau_j = Y_j(q, dq, ddq) pi + A ddq_j + o + Fc sign(dq_j) + Fv dq_j`, per joint, over the samples in which the joint moves.

    Y is the rigid body's regressor (Atkeson, An, Hollerbach 1986), pi is free up to a weak pull towards the URDF, A the rotor's inertia,
    o the torque sensor's offset. What the wrist sensor feels goes in as `J^T W` with a free factor and offsets, so that a cable
    that rubs on the payload is not taken for friction of the joints.

    Without torques the tracking error `q_cmd - q` stands in their place, which a joint controller makes
    proportional to the torque; only its Coulomb part can be told from a lag then.

    Friction is there when in some joint its part (r.m.s. over the joint's moving samples) is above three times the noise of one
    motionless sample and above 2 % of the signal's spread, one of its coefficients stands five standard deviations above zero, and none
    three below it: friction takes energy away.

    Material where it differs, by the same measures, from what the cell states by more than half of that, or where the tracking error of
    such a joint exceeds 0.5 deg (r.m.s. while it moves). Where nobody states friction, or torques were not recorded, there is nothing
    that it could differ from.
    """

    id = "joint_friction"
    title = Message.of("effect-joint-friction-title")
    stage = "actuation"
    side = "joints"

    def parameters(self, recording: Recording) -> tuple[Parameter, ...]:
        """For each joint Coulomb, N m, and viscous friction, N m s/rad; without torques its Coulomb part of the tracking error, rad."""
        joints = range(0 if recording.q is None else recording.q.shape[1])
        if recording.tau is None:
            return tuple(Parameter(f"joint_{j + 1}_coulomb_rad", "rad", 0.0, 0.0, 0.1, 0.001) for j in joints)
        kinds = (("coulomb_nm", "N m", 5.0), ("viscous_nms_per_rad", "N m s/rad", 5.0))
        return tuple(Parameter(f"joint_{j + 1}_{name}", unit, 0.0, 0.0, 1e3, scale) for j in joints for name, unit, scale in kinds)

    def observe(self, recording: Recording, view: View) -> Finding | None:
        """Fits friction to each joint and compares it with the cell's; None without any fit, or where none is found or missed."""
        run = FrictionSignals.of(recording)
        if run is None:
            return None
        fits = [fit_joint(run, j) for j in range(run.q.shape[1])]
        if all(fit is None for fit in fits):
            return None
        count = 1 if recording.tau is None else 2
        unknown = np.full(count, np.nan)
        theta = np.concatenate([unknown if fit is None else fit.friction[:count] for fit in fits])
        std = np.concatenate([unknown if fit is None else np.sqrt(np.diag(fit.covariance))[:count] for fit in fits])
        seen = _Seen(run, fits, theta.reshape(-1, count), std.reshape(-1, count), noise_of(run.raw, view.holds), tracking_error(recording))
        stated = None if recording.tau is None else recording.friction
        verdict = seen.alone() if stated is None else seen.against(np.column_stack([stated.coulomb, stated.viscous]))
        if verdict is None:
            return None
        sigma = max(0.0 if fit is None else sigma_of(fit.friction[:count], fit.covariance[:count, :count]) for fit in fits)
        told = [seen.bound(j) for j in range(len(fits))]
        return Finding(
            np.concatenate([value for value, _ in told]),
            np.concatenate([spread for _, spread in told]),
            sigma,
            verdict.material,
            verdict.times,
            verdict.message,
        )

    def advice(self, finding: Finding) -> Message:
        """Advises warming up, a look at joints that rub more than before, and stating the friction that is left in cell.toml."""
        return Message.of("advice-joint-friction")


class _Verdict(NamedTuple):
    """Whether it matters, how many times what is expected it is, and what there is to say."""

    material: bool
    times: float | None
    message: Message


@dataclass(frozen=True)
class _Seen:
    """What was found in the joints.

    Args:
        fits: of each joint, None where it hardly moves.
        theta, std: (n, 1) or (n, 2), Coulomb and, where torques were recorded, viscous.
        noise: (n,), of one motionless sample.
        tracking: (n,), r.m.s. error, rad; None without commands.
    """

    run: FrictionSignals
    fits: list[FrictionFit | None]
    theta: Array
    std: Array
    noise: Array
    tracking: Array | None

    @property
    def sizes(self) -> Array:
        """(n,), r.m.s. of the friction part over the moving samples; 0 where nothing was fitted."""
        return self._sizes(self.theta)

    @property
    def rubs(self) -> Flags:
        """(n,), where friction is found."""
        z = np.nan_to_num(self.theta / self.std)
        return np.asarray(self._stands_out(self.sizes) & (z.max(axis=1) > CERTAIN) & self._takes_energy)

    @property
    def drags(self) -> Flags:
        """(n,), where it comes with a large tracking error."""
        return self.rubs & (False if self.tracking is None else self.tracking > TRACKING)

    def alone(self) -> _Verdict | None:
        """Nothing is stated to compare with; None where no joint rubs."""
        if not self.rubs.any():
            return None
        joint = self._worst(self.drags if self.drags.any() else self.rubs, self.sizes / np.maximum(self.noise, TINY))
        if self.theta.shape[1] == 1:
            lag, std = self.theta[joint, 0], self.std[joint, 0]
            return self._conclude(None, Message.of("symptom-friction-in-tracking", joint=joint + 1, lag_rad=lag, lag_std_rad=std))
        return self._conclude(None, Message.of("symptom-friction-not-stated", joint=joint + 1, friction=self._say_friction(joint)))

    def against(self, stated: Array) -> _Verdict | None:
        """Compared with (n, 2) what is stated; None where none is found and none is missed."""
        expected, apart = self._sizes(stated), self._sizes(self.theta - stated)
        missed = self._stands_out(expected) & self._takes_energy & (self.sizes < expected)
        certain = [fit is not None and sigma_of(fit.friction - row, fit.covariance) > CERTAIN for fit, row in self._by_joint(stated)]
        differs = (self.rubs | missed) & self._stands_out(apart) & np.array(certain) & (apart > HALF * expected)
        chosen = differs if differs.any() else self.rubs
        if not chosen.any():
            return None
        joint = self._worst(chosen, apart / np.maximum(expected, TINY))
        coulomb, viscous = (float(value) for value in stated[joint])
        times = float(self.sizes[joint] / expected[joint]) if expected[joint] > 0.0 else None
        found = self._say_friction(joint)
        beside = Message.of("symptom-stated-friction", coulomb_nm=coulomb, viscous_nms_per_rad=viscous)
        if differs.any():
            seen = Message.of("symptom-friction-differs", joint=joint + 1, friction=found, stated=beside)
            return self._conclude(times, seen, differs=True)
        return self._conclude(times, Message.of("symptom-friction-as-stated", joint=joint + 1, friction=found, stated=beside))

    @property
    def _takes_energy(self) -> Flags:
        return np.asarray(np.nan_to_num(self.theta / self.std).min(axis=1) > -BELOW)

    def _sizes(self, friction: Array) -> Array:
        """(n,), r.m.s. of what coefficients (n, 1 or 2) make over the moving samples."""
        made = [None if fit is None else fit.columns[:, : len(row)] @ row for fit, row in self._by_joint(friction)]
        return np.array([0.0 if torque is None else np.sqrt(np.mean(torque**2)) for torque in made])

    def _by_joint(self, friction: Array) -> zip[tuple[FrictionFit | None, Array]]:
        return zip(self.fits, friction, strict=True)

    def _stands_out(self, sizes: Array) -> Flags:
        return np.asarray((sizes > LOUD * self.noise) & (sizes > LEAST * self.run.spread))

    def _worst(self, among: Flags, measure: Array) -> int:
        return int(np.argmax(np.where(among, measure, -1.0)))

    def bound(self, joint: int) -> tuple[Array, Array]:
        """Coefficients and standard uncertainties of one joint, as they are told: none below zero."""
        fit, count = self.fits[joint], self.theta.shape[1]
        return (self.theta[joint], self.std[joint]) if fit is None else bound_friction(fit.friction[:count], fit.covariance[:count, :count])

    def _say_friction(self, joint: int) -> Message:
        (coulomb, viscous), (coulomb_std, viscous_std) = self.bound(joint)
        return Message.of(
            "symptom-friction",
            coulomb_nm=coulomb,
            coulomb_std_nm=coulomb_std,
            viscous_nms_per_rad=viscous,
            viscous_std_nms_per_rad=viscous_std,
        )

    def _conclude(self, times: float | None, seen: Message, *, differs: bool = False) -> _Verdict:
        """With the tracking error, where that matters."""
        drags = self.drags
        if self.tracking is None or not drags.any():
            return _Verdict(differs, times, seen)
        late = self._worst(drags, self.tracking)
        error = float(self.tracking[late])
        also_late = Message.of("symptom-friction-and-tracking", seen=seen, joint=late + 1, tracking_rad=error)
        return _Verdict(True, times if differs else error / TRACKING, also_late)
