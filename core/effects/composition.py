"""Several effects at once, along a run as a whole or row by row."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import NamedTuple

from core.array import Array
from core.effects.effect import STAGES, Effect
from core.effects.memory import Memory
from core.effects.scene import Scene


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
        self._terms = [(term, Memory()) for term in ordered]

    def __len__(self) -> int:
        return len(self._terms)

    def change(self, scene: Scene) -> Array:
        """(N, 6), what the effects add to the scene's nominal wrench, N and N m.

        Scenes of several calls are blocks of one run, one behind the other.
        """
        w = scene.nominal
        for term, memory in self._terms:
            w = term.effect.wrench(replace(scene, memory=memory), w, term.theta)
        return w - scene.nominal
