"""Several effects at once, along a run as a whole or row by row."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.effects.effect import STAGES, Effect
from core.effects.joint_elasticity import JointElasticity
from core.effects.memory import Memory
from core.effects.scene import Scene
from core.effects.transmission import Transmission


class Term(NamedTuple):
    """An effect with values for its parameters, in their order."""

    effect: Effect
    theta: Array


class Composition:
    """Effects that act on the wrench one after the other, from the robot to the reading.

    Args:
        terms: in any order.
    """

    def __init__(self, terms: Iterable[Term]) -> None:
        ordered = sorted(terms, key=lambda term: STAGES.index(term.effect.stage))
        self._terms = [(term, Memory(), Memory()) for term in ordered]

    def __len__(self) -> int:
        return len(self._terms)

    def change(self, scene: Scene) -> Array:
        """(N, 6), what the effects add to the scene's nominal wrench, N and N m.

        Scenes of several calls are blocks of one run, one behind the other.
        """
        w, shaken = scene.nominal, scene
        if any(isinstance(term.effect, JointElasticity) for term, *_ in self._terms):
            gears = ((term.effect, replace(scene, memory=memory), term.theta) for term, _, memory in self._terms)
            shaken = let_shake(scene, (gear.find_errors(own, x)[1] for gear, own, x in gears if isinstance(gear, Transmission)))
        for term, memory, _ in self._terms:
            seen = shaken if isinstance(term.effect, JointElasticity) else scene
            w = term.effect.wrench(replace(seen, memory=memory), w, term.theta)
        return w - scene.nominal


def let_shake(scene: Scene, shaking: Iterable[Array]) -> Scene:
    """The scene as springs in the joints feel it that bear what effects shake the links by, (N, n) each, rad/s2; itself where none does."""
    accelerations = list(shaking)
    return scene.with_shaking(np.sum(accelerations, axis=0)) if accelerations else scene
