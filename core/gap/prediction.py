"""How far another motion would put two explanations apart, before it is made.

If one of them is true, the other would be fitted to both recordings: its parameters, the payload, the new recording's offsets and the
small imperfections go as far as the present recording lets them. What cannot be made up for is the distance.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from core.array import Array
from core.effects.effect import Effect
from core.effects.link_loads import LazyLinkLoads, LinkLoads
from core.effects.scene import PER_ROW, Scene
from core.estimation.drift import STEP_STD
from core.estimation.kinematics import poses_of
from core.estimation.quadratic import Quadratic, descend, inverse
from core.gap.basis import build_unchecked_basis
from core.gap.effect_fit import EffectFit
from core.gap.problem import STEP, Problem
from core.gap.windows import OFFSET, Windows
from core.payload.inertia import Motion
from core.recording.recording import BETWEEN_RUNS_S, Recording

STEPS = 8
"""Looks at parameters, at most."""
SETTLED = 0.01
"""Share of the cost by which it still falls where it is done."""


class Prediction:
    """A motion that has not been made, with the nominal twin along it.

    Args:
        present: windows of the recording at hand.
        motion: the motion ahead, without a wrench.
        fit: whose payload is carried.
    """

    def __init__(self, present: Windows, motion: Recording, fit: EffectFit) -> None:
        poses = poses_of(motion)
        if poses is None or motion.wrench is None:
            raise ValueError("a motion ahead needs poses and a wrench of zeros")
        seen = present.basis.poses
        basis = build_unchecked_basis(motion, replace(poses, noise=seen.noise, jitter_s=seen.jitter_s), motion.wrench)
        ahead = replace(basis, noise=present.basis.noise, wrench=basis.V @ fit.phi)
        self._present = present
        self._windows = Windows(ahead)
        self._scene = append_scene(present.basis.scene, ahead.scene)
        self.seconds = float(motion.t[-1] - motion.t[0])

    def distance_sigma(self, a: EffectFit, b: EffectFit) -> float:
        """Standard deviations that this motion alone puts between two fits, whichever of them is true.

        An effect that both have is the same in both: that each carries its own course of a drift on, say, is no difference.
        """
        shared = _share(self._scene, a, b)
        rows_a, rows_b = self._rows(a)[0], self._rows(shared)[0]
        return min(self._find_distance(rows_b, a), self._find_distance(rows_a, shared))

    def _find_distance(self, rows: Array, fit: EffectFit) -> float:
        """What a fit cannot follow of rows (6K,): the root of the least `|rows - f(x)|^2 + x^T S^-1 x` within the bounds of its parameters,
        by Gauss-Newton's method.

        x is how far payload, small imperfections and effects go from where the present recording has them, S their covariance; the last
        six are the new offsets, of unit variance.
        """
        here = np.concatenate((fit.beta, fit.theta))
        bounds = np.full((2, len(here) + 6), np.inf) * [[-1.0], [1.0]]
        bounds[:, : len(here)] = Problem(self._present, fit.effects).bounds - here
        bounds = np.stack((np.minimum(bounds[0], 0.0), np.maximum(bounds[1], 0.0)))
        precision = np.eye(len(here) + 6)
        precision[: len(here), : len(here)] = inverse(fit.covariance)

        def look(x: Array, _: Quadratic | None) -> Quadratic:
            moved, offsets = np.split(here + x[: len(here)], [len(fit.beta)]), x[len(here) :]
            predicted, columns = self._rows(replace(fit, beta=moved[0], theta=moved[1]))
            r = rows - predicted - columns[:, len(here) :] @ offsets
            cost = float(r @ r + x @ precision @ x)
            return Quadratic(cost, columns.T @ columns + precision, columns.T @ r - precision @ x)

        _, best = descend(look, np.zeros(len(precision)), bounds, steps=STEPS, settled=SETTLED)
        return float(np.sqrt(best.cost))

    def _rows(self, fit: EffectFit) -> tuple[Array, Array]:
        """What a fit predicts (6K,), and how that depends on all its parameters and on new offsets (6K, n)."""
        X, ahead = self._windows.X, len(self._windows.basis.scene)
        problem = Problem(self._present, fit.effects)
        scene = self._scene.with_phi(fit.phi)
        steps = np.where(fit.theta + STEP * problem.scale <= problem.upper, 1.0, -1.0) * STEP * problem.scale
        changes = [problem.change(theta, scene)[-ahead:] for theta in (fit.theta, *(fit.theta + np.diag(steps)))]
        rows = self._windows.rows_of(changes)
        J = (rows[..., 1:] - rows[..., :1]) / steps
        earlier = np.zeros((*X.shape[:2], len(fit.beta) - X.shape[2]))  # offsets of the parts of the present recording
        columns = np.concatenate((X, earlier, J, STEP_STD * X[..., OFFSET]), axis=2)
        predicted = X @ fit.beta[: X.shape[2]] + rows[..., 0]
        return predicted.ravel(), columns.reshape(-1, columns.shape[2])


def _share(scene: Scene, a: EffectFit, b: EffectFit) -> EffectFit:
    """b with the parameters of a where both have the same effect in the same shape."""
    known, own = _split(scene, a), _split(scene, b)
    return replace(b, theta=np.concatenate([np.zeros(0), *(known.get(shape, theta) for shape, theta in own.items())]))


def _split(scene: Scene, fit: EffectFit) -> dict[type[Effect], Array]:
    """Parameters by shape of effect, in their order."""
    ends = np.cumsum([len(effect.parameters(scene)) for effect in fit.effects])
    return dict(zip(map(type, fit.effects), np.split(fit.theta, ends[:-1]), strict=False))


def append_scene(scene: Scene, ahead: Scene) -> Scene:
    """Both one after the other; what only the first one knows stays at its mean."""
    rows: dict[str, Any] = {
        name: _rows_of(getattr(scene, name), getattr(ahead, name), len(ahead)) for name in PER_ROW if name not in ("t", "motion", "links")
    }
    links = None if scene.links is None else LazyLinkLoads(partial(_append_loads, scene.links, ahead.links, len(ahead)))
    motion = Motion(*[np.concatenate((getattr(scene.motion, k), getattr(ahead.motion, k))) for k in ("g", "a", "omega", "alpha")])
    t = np.concatenate((scene.t, scene.t[-1] + BETWEEN_RUNS_S + ahead.t - ahead.t[0]))
    return replace(scene, t=t, motion=motion, links=links, joint_twists=None, joint_waves=None, **rows)


def _append_loads(first: LazyLinkLoads, then: LazyLinkLoads | None, count: int) -> LinkLoads:
    rest = (None, None, None) if then is None else then.loads
    return LinkLoads(*(_append_rows(a, b, count) for a, b in zip(first.loads, rest, strict=True)))


def _rows_of(first: Array | None, then: Array | None, count: int) -> Array | None:
    return None if first is None else _append_rows(first, then, count)


def _append_rows(first: Array, then: Array | None, count: int) -> Array:
    return np.concatenate((first, np.repeat(first.mean(axis=0)[None], count, axis=0) if then is None else then))
