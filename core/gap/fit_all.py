"""Many fits to one recording: on all cores, or one by one where others keep the cores busy already."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from typing import NamedTuple, TypeAlias

import numpy as np
from threadpoolctl import threadpool_limits

from core.array import Array
from core.effects.effect import STAGES, Effect
from core.gap.effect_fit import EffectFit, fit_effects
from core.gap.windows import Windows


class Task(NamedTuple):
    """Effects to fit together, the fit to start from, and starting values of their parameters; how many of these, from the first on, where
    it is not all of them."""

    effects: tuple[Effect, ...]
    start: EffectFit
    thetas: list[Array]
    first: int | None = None

    @property
    def name(self) -> str:
        """Of what is fitted, as `EffectFit.name`."""
        return "+".join(effect.id for effect in self.effects)

    @property
    def size(self) -> int:
        """By which fits last about as long: derivatives by each parameter, from each start."""
        return sum(len(theta) for theta in self.thetas)


FitAll: TypeAlias = Callable[[Windows, list[Task]], list[EffectFit]]
"""Fits each task on its own; the results are in the order of the tasks."""


def on_all_cores(windows: Windows, tasks: list[Task]) -> list[EffectFit]:
    """In processes of their own, which inherit the windows; the longest first, so that no core waits for it at the end."""
    if not tasks:
        return []
    order = sorted(range(len(tasks)), key=lambda k: -tasks[k].size)
    with ProcessPoolExecutor(mp_context=get_context("fork"), initializer=_share, initargs=(windows,)) as pool:
        fits = dict(zip(order, pool.map(_fit, [tasks[k] for k in order]), strict=True))
    return [fits[k] for k in range(len(tasks))]


def one_by_one(windows: Windows, tasks: list[Task]) -> list[EffectFit]:
    """In this process."""
    return [fit_effects(windows, *task) for task in tasks]


def pair_of(a: EffectFit, b: EffectFit) -> Task:
    """Two effects at once, each from where it ended alone."""
    first, second = sorted((a, b), key=lambda fit: (STAGES.index(fit.effects[0].stage), fit.name))
    start = min(a, b, key=lambda fit: fit.cost)
    return Task((*first.effects, *second.effects), start, [np.concatenate((first.theta, second.theta))])


_shared: Windows
"""The windows in a worker process: inherited, never sent."""


def _share(windows: Windows) -> None:
    global _shared  # noqa: PLW0603 - set once for each worker
    _shared = windows
    threadpool_limits(1)


def _fit(task: Task) -> EffectFit:
    return fit_effects(_shared, *task)
