"""Identification with a twin: what its effects do to the wrench is taken off before the payload is estimated.

The effects depend on the payload, and the payload is what is sought: both are found in turns until the payload stands still.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from core.array import Array, interpolate
from core.effects.library import find_effect
from core.effects.scene import Scene
from core.estimation.budget import Budget, Source
from core.estimation.estimate import TwinShare
from core.estimation.fit import OFFSET, Fit
from core.estimation.generalised_least_squares import fit, refit
from core.estimation.kinematics import Poses, smooth_motion
from core.estimation.noise import WrenchNoise
from core.estimation.nuisances import Nuisances
from core.estimation.scene import scene_of
from core.estimation.segments import Segment, stretches
from core.estimation.weak_form import WeakForm
from core.payload.inertia import Motion
from core.recording.recording import Recording
from core.twin.model import compose_effects, explain_lacks
from core.twin.twin import Twin
from core.words.message import Message

GRID_S = 0.005
"""Period of the scene that effects are applied to, as in the diagnosis that fits them."""
SMOOTHING_S = 0.02
"""Of the motion that effects act on: a longer window rounds the corners off and biases the inertia, a shorter one lets noise in."""
ROUNDS = 8
STANDS_STILL = 0.02
"""Change of a parameter from round to round, in its standard uncertainty, below which the payload stands still."""


class TwinEffects:
    """A twin's effects on the wrench of one recording.

    Args:
        twin: whose effects; those that cannot be evaluated in this recording are in `lacking` with the reasons.
        scene: nominal run on a grid.
        t: (N,), times of the samples, s.
        static: each row is a pose by itself, at which the robot has been standing for long; nothing carries over between rows.
    """

    def __init__(self, twin: Twin, scene: Scene, t: Array, *, static: bool) -> None:
        self.twin, self.t = twin, t
        lacks = explain_lacks(twin, scene)
        self.lacking = tuple(Message.of("twin-lacking", effect=name, reason=reason) for name, reason in lacks.items())
        self.ids = tuple(name for name in twin.ids if name not in lacks)
        self.scene = scene
        self._blocks = [slice(k, k + 1) for k in range(len(scene))] if static else [slice(None)]

    def change(self, phi: Array, twin: Twin | None = None) -> Array:
        """(N, 6), what the effects add to the wrench of the samples, N and N m.

        Args:
            phi: (10,), payload.
            twin: the same effects with other parameters; those of the twin itself where absent.
        """
        scene = self.scene.with_phi(phi)
        twin = twin or self.twin
        rows = np.concatenate([compose_effects(twin, scene).change(scene[block]) for block in self._blocks])
        return interpolate(self.t, scene.t, rows)


def effects_on(recording: Recording, poses: Poses, segments: tuple[Segment, ...], twin: Twin, *, static: bool) -> TwinEffects:
    """A twin's effects along a recording.

    Args:
        static: the samples are poses, not motion.
    """
    t = recording.t
    if static:
        scene = scene_of(recording, poses, Motion.still(poses.g), segments, t)
        standing = None if scene.dq is None else np.zeros_like(scene.dq)
        return TwinEffects(twin, replace(scene, dq=standing), t, static=True)
    motion, _ = smooth_motion(poses, window_s=SMOOTHING_S)
    period = max(GRID_S, poses.period)
    grid = np.concatenate([np.arange(t[part][0], t[part][-1], period) for part in stretches(t)])
    channels = [interpolate(grid, t, x) for x in (motion.g, motion.a, motion.omega, motion.alpha)]
    return TwinEffects(twin, scene_of(recording, poses, Motion(*channels), segments, grid), t, static=False)


@dataclass(frozen=True)
class Corrected:
    """A fit to the wrench without the twin's effects.

    Args:
        found: the fit.
        change: (N, 6), what the effects add to the wrench.
        shares: what each of them does to the payload.
        accounted: identifiers of the effects.
        directions: (19, k), change of the fit for one standard deviation of each direction of the effects' parameters.
    """

    found: Fit
    change: Array
    shares: tuple[TwinShare, ...]
    accounted: tuple[str, ...]
    directions: Array

    def without_share(self, effect: str) -> Corrected:
        """The same where an effect is not the twin's, and nobody has to be told what it does."""
        shares = tuple(share for share in self.shares if share.effect != effect)
        return replace(self, shares=shares, accounted=tuple(name for name in self.accounted if name != effect))

    @property
    def covariance(self) -> Array:
        """(19, 19), of the fit with the uncertainty of the effects' parameters; what is not seen of the nuisances stands in `budget`."""
        n = OFFSET.stop
        return np.asarray(self.found.covariance[:n, :n] + self.directions @ self.directions.T)

    @property
    def budget(self) -> Budget:
        """Of the payload."""
        budget = self.found.budget
        twin = Source("twin", stated=True, directions=self.directions[:10])
        return budget if not self.directions.size else replace(budget, sources=(*budget.sources, twin))


def fit_with_effects(
    form: WeakForm,
    wrench: Array,
    noise: WrenchNoise,
    effects: TwinEffects | None,
    nuisances: Nuisances | None,
    found: Fit | None = None,
) -> Corrected:
    """Fits payload and offsets to a wrench (N, 6) in which a twin's effects show.

    The effects' parameters are taken as independent of the recording: identifying the very recording that they were fitted to counts its
    noise twice, on the safe side.

    Args:
        found: to begin with, where there is a fit already.
    """
    found = found or fit(form, wrench, noise, nuisances)
    if effects is None or not effects.ids:
        return Corrected(found, np.zeros_like(wrench), (), (), np.zeros((OFFSET.stop, 0)))
    change = effects.change(found.phi)
    for _ in range(ROUNDS):
        x = refit(form, wrench - change, found)
        moved = np.abs(x[:10] - found.phi) / np.sqrt(np.diag(found.budget.repeatability))
        found = replace(found, x=x)
        change = effects.change(found.phi)
        if (moved < STANDS_STILL).all():
            break
    found = fit(form, wrench - change, noise, nuisances)
    directions = _of_parameters(form, wrench, found, effects)
    return Corrected(found, change, tuple(_find_shares(form, wrench, found, effects)), effects.ids, directions)


def _find_shares(form: WeakForm, wrench: Array, found: Fit, effects: TwinEffects) -> Iterator[TwinShare]:
    """By refits without one entry at a time."""
    here = refit(form, wrench - effects.change(found.phi), found)
    for entry in effects.twin.effects:
        if entry.effect in effects.ids:
            without = refit(form, wrench - effects.change(found.phi, effects.twin.without(entry.effect)), found)
            yield TwinShare(entry.effect, find_effect(entry.effect).title, entry.recording, (here - without)[:10])


def _of_parameters(form: WeakForm, wrench: Array, found: Fit, effects: TwinEffects) -> Array:
    """(19, k), what each direction in which the effects' parameters are uncertain does to the fit, by finite differences."""
    here = refit(form, wrench - effects.change(found.phi), found)
    moved = [np.zeros((OFFSET.stop, 0))]
    for entry in effects.twin.effects:
        for direction in entry.directions if entry.effect in effects.ids else ():
            changed = effects.change(found.phi, effects.twin.with_entry(entry.move_parameters(direction)))
            moved.append((refit(form, wrench - changed, found) - here)[: OFFSET.stop, None])
    return np.concatenate(moved, axis=1)
