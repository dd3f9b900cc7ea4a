"""Sound gears, found beside the payload: an arm that swings on them feels heavier in motion than it weighs.

Where something is left over, their stiffnesses are sought as the diagnosis does it (`core.gap.sound_gears`), within what is sound. Nothing
else may stand in for them: gains, zeros or a tilt would bend the payload.
"""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.joint_elasticity import JointElasticity
from core.effects.joint_error import joint_count
from core.effects.scene import Scene
from core.estimation.determination import find_determined
from core.estimation.fit import Beside, Fit
from core.estimation.generalised_least_squares import look_beside
from core.estimation.kinematics import Poses
from core.estimation.nuisances import LEAST_STRENGTH
from core.estimation.quadratic import descend, inverse
from core.estimation.twin_effects import TwinEffects
from core.estimation.weak_form import WeakForm
from core.twin.twin import Entry, Fitted
from core.words.message import Message

SOFTEST_RAD_PER_NM, USUAL_RAD_PER_NM = 5e-5, 2e-5
"""1 / (20 kN m/rad) and 1 / (50 kN m/rad), of a joint: a softer one is an effect and has to be named."""
STARTS_RAD_PER_NM = (1e-5, 2e-5, 4e-5)
NAME = JointElasticity.id
STEPS = 8
"""Looks at parameters, at most."""
STEP = 0.02
"""Of numerical derivatives, in plausible sizes."""
SETTLED = 1e-3
"""Share of the cost by which it still falls where the search is done."""
EXPLAIN = 0.5
"""Share of what is left over beyond the noise that they have to explain."""


class SoundGears(JointElasticity):
    """Elastic joints within what is sound."""

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """As of `JointElasticity`."""
        *compliances, inertia, damping = super().parameters(scene)
        bounded = (replace(each, upper=SOFTEST_RAD_PER_NM, scale=USUAL_RAD_PER_NM) for each in compliances)
        return (*bounded, replace(inertia, lower=0.5, upper=1.5, scale=0.1), damping)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:  # noqa: ARG002 - every effect is given the residual
        """All joints alike, hardly damped."""
        n = joint_count(scene)
        return [np.array([*[compliance] * n, 1.0, 0.1]) for compliance in STARTS_RAD_PER_NM]


def find_gears(poses: Poses, wrench: Array, found: Fit, effects: TwinEffects) -> Entry | None:
    """The gears that explain most of what a fit to the wrench (N, 6) leaves over beyond the noise; None where they do not.

    Args:
        effects: of the cell's twin along the recording; one that states the gears itself keeps them.
    """
    gears = SoundGears()
    if NAME in effects.ids or gears.explain_lack(effects.scene) is not None:
        return None
    if not find_determined(found.phi, np.sqrt(np.diag(found.covariance)[:10])).all():
        return None  # with an inertia that nothing excites they would swing as noise has it
    every = max(1, int(effects.scene.period / poses.period + 0.01))  # faster samples tell no more of what is that slow
    form, wrench = WeakForm(poses.take(slice(None, None, every))), wrench[::every]
    effects = TwinEffects(effects.twin, effects.scene, effects.t[::every], static=False)
    parameters = gears.parameters(effects.scene)
    absent, scale, lower, upper = (np.array([getattr(p, name) for p in parameters]) for name in ("absent", "scale", "lower", "upper"))
    start = replace(found, scale=np.ones(6), strength=np.full_like(found.strength, LEAST_STRENGTH))

    def look(theta: Array, best: Beside | None) -> Beside:
        fit, away = start if best is None else replace(start, x=best.x), (theta - absent) / scale
        here = _change(effects, fit.phi, parameters, theta)
        ways = np.diag(np.where(theta + STEP * scale <= upper, STEP, -STEP) * scale)
        columns = [(_change(effects, fit.phi, parameters, theta + way) - here) / way.sum() for way in ways]
        at = look_beside(form, wrench - here, fit, columns)
        return at._replace(cost=at.cost + float(away @ away), normal=at.normal + np.diag(scale**-2.0), right=at.right - away / scale)

    without = look_beside(form, wrench - effects.change(found.phi), start)
    thetas = gears.starts(effects.scene, np.zeros((0, 6)))
    nearest = min(thetas, key=lambda theta: look_beside(form, wrench - _change(effects, found.phi, parameters, theta), start).cost)
    theta, at = descend(look, nearest, np.stack((lower, upper)), steps=STEPS, settled=SETTLED)
    left, beyond = at.chi_square / at.rows, max(0.0, without.chi_square / without.rows - 1.0)
    if left - 1.0 > EXPLAIN * beyond or not theta[: joint_count(effects.scene)].any():
        return None
    return _entry(parameters, theta, inverse(at.normal) * max(1.0, left))


def describe_gears(gears: Entry) -> Message:
    """What is said of them: the softest joint, N m/rad."""
    softest = max(p.value for name, p in gears.parameters.items() if name.endswith("_rad_per_nm"))
    return Message.of("estimation-gears-accounted", softest_nm_per_rad=round(1.0 / softest, -3))


def _change(effects: TwinEffects, phi: Array, parameters: tuple[Parameter, ...], theta: Array) -> Array:
    """(N, 6), what the twin's effects and gears add to the wrench of the samples, N and N m."""
    return effects.change(phi, effects.twin.with_entry(_entry(parameters, theta, np.zeros((len(theta), len(theta))))))


def _entry(parameters: tuple[Parameter, ...], theta: Array, covariance: Array) -> Entry:
    """Gears as an entry of a twin; they are of this recording alone and stay with it."""
    std = np.sqrt(np.diag(covariance))
    fitted = {p.name: Fitted(value=float(v), std=float(s), unit=p.unit) for p, v, s in zip(parameters, theta, std, strict=True)}
    rows = tuple(tuple(row) for row in (0.5 * (covariance + covariance.T)).tolist())
    return Entry(
        effect=NAME,
        parameters=fitted,
        covariance=rows,
        recording="",
        sha256="0" * 64,
        added=datetime.now(UTC),
        gap_before=1.0,
        gap_after=1.0,
    )
