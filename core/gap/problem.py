"""One set of effects on one recording as a least-squares problem: `|y - X beta - D(theta, phi)|^2` over whitened rows, plus priors.

beta holds payload, offsets and the small imperfections, theta the effects' parameters. What the cell's twin has is always on.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.effects.composition import let_shake
from core.effects.effect import STAGES, Effect, Parameter
from core.effects.joint_elasticity import JointElasticity
from core.effects.scene import Scene
from core.effects.transmission import Transmission
from core.estimation.quadratic import find_bounded_minimum
from core.gap.limits import sizes
from core.gap.windows import PHI, Windows

PRIOR_WIDTH = 2.0
"""Standard deviation of the prior in plausible sizes."""
ABSENT_WIDTH = 1e-5
"""The same of a parameter that stays absent."""
STEP = 1e-3
"""Of the finite differences, in plausible sizes."""
SMALL = 2.5
"""Small imperfections stay within this many of their standard deviations; beyond, they are effects and have to be named."""


class _Look(NamedTuple):
    """What one point of the parameters gave.

    Args:
        theta: the point.
        scene: with the payload there.
        rows: (6K,), of the change.
        known: what each effect does there, by its parameters.
    """

    theta: Array
    scene: Scene
    rows: Array
    known: dict[bytes, Array]


class _Slope(NamedTuple):
    """Derivatives J (6K, n) of the rows (6K,) at one point of the parameters, with the payload phi."""

    theta: Array
    phi: Array
    rows: Array
    J: Array


class Problem:
    """Rows and derivatives for one set of effects.

    Args:
        smaller: whether each effect has its smaller shape, unless the twin has it already; the other parameters stay absent.
    """

    def __init__(self, windows: Windows, effects: tuple[Effect, ...], *, smaller: bool = False) -> None:
        self.windows = windows
        self.effects = tuple(sorted(effects, key=lambda effect: STAGES.index(effect.stage)))
        parameters = [parameters_of(windows, effect) for effect in self.effects]
        self.counts = [len(of_effect) for of_effect in parameters]
        self.parameters = tuple(p for of_effect in parameters for p in of_effect)
        free = {effect.id for effect in self.effects}
        self.held = tuple(term for term in windows.held if term.effect.id not in free)
        chain: list[tuple[Effect, int, Array | None]] = [(effect, n, None) for effect, n in zip(self.effects, self.counts, strict=True)]
        chain += [(term.effect, 0, term.theta) for term in self.held]
        self._chain = sorted(chain, key=lambda link: STAGES.index(link[0].stage))
        self.absent = np.array([p.absent for p in self.parameters])
        self.scale = np.array([p.scale for p in self.parameters])
        self.lower = np.array([p.lower for p in self.parameters])
        self.upper = np.array([p.upper for p in self.parameters])
        self.X, self.XX = windows.flat, windows.normal
        self._last: _Look | None = None
        self._slope: _Slope | None = None
        self._always: dict[int, Array] = {}
        """Derivatives by what follows the course of a run, which is linear in it: the same everywhere."""
        self.target = windows.target.ravel()
        sizes = [(find_smaller(windows, effect) if smaller else None) or n for effect, n in zip(self.effects, self.counts, strict=True)]
        self.fitted = np.concatenate([np.zeros(0, dtype=bool), *(np.arange(n) < size for n, size in zip(self.counts, sizes, strict=True))])
        width = np.where(self.fitted, PRIOR_WIDTH, ABSENT_WIDTH)
        self.precision = np.concatenate((windows.prior_std, width * self.scale)) ** -2.0
        small = np.full(len(windows.prior_std), np.inf)
        small[windows.background] = SMALL * windows.prior_std[windows.background]
        self.bounds = np.array([np.concatenate((-small, self.lower)), np.concatenate((small, self.upper))])

    def change(self, theta: Array, scene: Scene, known: dict[bytes, Array] | None = None) -> Array:
        """(N, 6) on the scene's grid.

        Args:
            known: what effects add, by their own parameters, and wrenches behind those that do not only add, by all parameters up to
                theirs; for calls in which the rest moves. Filled here.
        """
        return self._behind(theta, scene, scene.nominal, {} if known is None else known) - scene.nominal

    @property
    def only_adds(self) -> bool:
        """Whether changes of the nominal wrench pass all effects as they are."""
        return all(effect.only_adds for effect, *_ in self._chain)

    def pass_noise(self, theta: Array, scene: Scene, accelerations: Array) -> Iterator[Array]:
        """(N, 6) each, what payload and effects make of errors of the linear and angular acceleration (M, N, 6)."""
        m, without = scene.motion, self._behind(theta, scene, scene.nominal, {})
        for error in accelerations:
            seen = scene.with_motion(replace(m, a=m.a + error[:, :3], alpha=m.alpha + error[:, 3:]))
            yield self._behind(theta, seen, seen.nominal, {}) - without

    def _behind(self, theta: Array, scene: Scene, w: Array, known: dict[bytes, Array]) -> Array:
        """(N, 6), the wrench w behind all effects."""
        ends = np.cumsum([free for _, free, _ in self._chain], dtype=int)
        chain = [(effect, theta[end - n : end] if x is None else x, end) for (effect, n, x), end in zip(self._chain, ends, strict=True)]
        gears = [(effect, values) for effect, values, _ in chain if isinstance(effect, Transmission)]
        for effect, values, end in chain:
            if effect.only_adds:
                key, springs = b"added by " + effect.id.encode() + values.tobytes(), isinstance(effect, JointElasticity)
                if springs:
                    key += b"".join(x.tobytes() for _, x in gears)
                if key not in known:
                    seen = let_shake(scene, (_shake(*gear, scene, known) for gear in gears)) if springs else scene
                    known[key] = effect.wrench(seen, np.zeros_like(w), values)
                w = w + known[key]
            else:
                key = effect.id.encode() + theta[:end].tobytes()
                if key not in known:
                    known[key] = effect.wrench(scene, w, values)
                w = known[key]
        return w

    def linearise(self, theta: Array, phi: Array) -> tuple[Array, Array]:
        """Rows of the change (6K,), and their derivatives by theta (6K, n); where a step from there was in vain, they are still known."""
        known = self._slope
        if known is not None and np.array_equal(known.theta, theta) and np.array_equal(known.phi, phi):
            return known.rows, known.J
        here = self._look(theta, phi)
        steps = np.where(theta + STEP * self.scale <= self.upper, 1.0, -1.0) * STEP * self.scale
        J = np.empty((len(steps), len(here.rows)))
        for k, step in enumerate(steps):
            if k in self._always:
                J[k] = self._always[k]
                continue
            moved = theta.copy()
            moved[k] += step
            np.subtract(self.windows.row_of(self.change(moved, here.scene, dict(here.known))), here.rows, out=J[k])
            np.divide(J[k], step, out=J[k])
            if self.only_adds and not self.parameters[k].shown:
                self._always[k] = J[k].copy()
        self._slope = _Slope(theta, here.scene.phi, here.rows, J.T)
        return here.rows, J.T

    def _look(self, theta: Array, phi: Array) -> _Look:
        """The rows at one point; where the last look was there, or had the same payload, what it found is still known."""
        last = self._last
        if last is not None and np.array_equal(last.scene.phi, phi):
            if np.array_equal(last.theta, theta):
                return last
            scene = last.scene
        else:
            scene = self.windows.basis.scene.with_phi(phi)
        known: dict[bytes, Array] = {}
        self._last = _Look(theta, scene, self.windows.row_of(self.change(theta, scene, known)), known)
        return self._last

    def cost(self, beta: Array, theta: Array) -> float:
        """Chi-square plus priors."""
        rows = self._look(theta, beta[PHI]).rows if self.effects or self.held else 0.0
        r = self.target - self.X @ beta - rows
        away = np.concatenate((beta, theta - self.absent))
        return float(r @ r + away @ (self.precision * away))

    def columns(self, theta: Array, phi: Array) -> Array:
        """(6K, m), derivatives of the rows by beta: small imperfections and offsets as they are, and so the payload, unless an effect moves
        it."""
        if not any(effect.moves_payload for effect, *_ in self._chain):
            return self.X
        X, here = self.X.copy(), self._look(theta, phi)
        for k, size in enumerate(sizes(phi)):
            step = STEP * (size or 1.0)
            moved = here.scene.with_phi(phi + step * np.eye(len(phi))[k])
            X[:, k] += (self.windows.row_of(self.change(theta, moved)) - here.rows) / step
        return X

    def normal(self, X: Array, J: Array) -> Array:
        """Normal matrix of beta and theta, with priors."""
        XJ = X.T @ J
        XX = self.XX if X is self.X else X.T @ X
        return np.block([[XX, XJ], [XJ.T, J.T @ J]]) + np.diag(self.precision)

    def step(self, beta: Array, theta: Array, damping: float) -> tuple[Array, Array]:
        """One damped step."""
        rows, J = self.linearise(theta, beta[PHI])
        X = self.columns(theta, beta[PHI])
        r = self.target - self.X @ beta - rows
        right = np.concatenate(
            (X.T @ r - self.precision[: len(beta)] * beta, J.T @ r - self.precision[len(beta) :] * (theta - self.absent))
        )
        # what shows in nothing stays: its prior alone would take the time of a jump out of the gap in which it happened
        right[len(beta) :][~J.any(axis=0)] = 0.0
        normal = self.normal(X, J)
        normal[np.diag_indices_from(normal)] *= 1.0 + damping
        here = np.concatenate((beta, theta))
        room = self.bounds - here
        step = find_bounded_minimum(normal, right, room)
        # not by an addition, which may round to either side: what is at a bound has to be told from what is free
        found = np.select(list(step == room), list(self.bounds), here + step)
        return found[: len(beta)], np.clip(found[len(beta) :], self.lower, self.upper)


def _shake(gear: Transmission, theta: Array, scene: Scene, known: dict[bytes, Array]) -> Array:
    """(N, n), rad/s2, found once while the springs move."""
    key = b"shaken by " + gear.id.encode() + theta.tobytes()
    if key not in known:
        known[key] = gear.find_errors(scene, theta)[1]
    return known[key]


def parameters_of(windows: Windows, effect: Effect) -> tuple[Parameter, ...]:
    """The effect's parameters in this recording; those of an effect that the twin has are absent at what the twin has of it, and what a
    richer shape of it has besides stays as it is."""
    known = {term.effect.id: term.theta for term in windows.held}
    parameters = effect.parameters(windows.basis.scene.with_phi(windows.phi))
    if effect.id not in known:
        return parameters
    stated = tuple(replace(p, absent=float(value)) for p, value in zip(parameters, known[effect.id], strict=False))
    return (*stated, *parameters[len(stated) :])


def find_smaller(windows: Windows, effect: Effect) -> int | None:
    """How many of the effect's parameters, from the first on, make up its smaller shape; None where it has none, or the twin has the effect
    already."""
    is_known = effect.id in {term.effect.id for term in windows.held}
    return None if is_known else effect.smaller_shape(windows.basis.scene.with_phi(windows.phi))
