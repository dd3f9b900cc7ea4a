"""Many fits to one recording, and looks at what to fit: on all cores, or one by one where others keep the cores busy already."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from typing import NamedTuple, Protocol, TypeVar

import numpy as np
from threadpoolctl import threadpool_limits

from core.array import Array
from core.effects.effect import STAGES, Effect
from core.gap.effect_fit import EffectFit, fit_effects
from core.gap.windows import Windows

Found = TypeVar("Found")
Found_co = TypeVar("Found_co", covariant=True)


class Job(Protocol[Found_co]):
    """Something to find in a recording by itself."""

    @property
    def size(self) -> int:
        """How long it lasts, in no unit."""

    def run(self, windows: Windows) -> Found_co:
        """What is found."""


class FitAll(Protocol):
    """Does each job on its own; what they find is in the order of the jobs."""

    def __call__(self, windows: Windows, jobs: Sequence[Job[Found]], /) -> list[Found]:
        """What each finds."""


class Task(NamedTuple):
    """Effects to fit together, the fit to start from, and starting values of their parameters; whether each has its smaller shape."""

    effects: tuple[Effect, ...]
    start: EffectFit
    thetas: list[Array]
    smaller: bool = False

    @property
    def name(self) -> str:
        """Of what is fitted, as `EffectFit.name`."""
        return "+".join(effect.id for effect in self.effects)

    @property
    def size(self) -> int:
        """By which fits last about as long: derivatives by each parameter, from each start."""
        return sum(len(theta) for theta in self.thetas)

    def run(self, windows: Windows) -> EffectFit:
        """The best fit from any of the starts."""
        return fit_effects(windows, *self)


def on_all_cores(windows: Windows, jobs: Sequence[Job[Found]], /) -> list[Found]:
    """In processes of their own, which inherit the windows; the longest first, so that no core waits for it at the end."""
    if not jobs:
        return []
    order = sorted(range(len(jobs)), key=lambda k: -jobs[k].size)
    with ProcessPoolExecutor(mp_context=get_context("fork"), initializer=_share, initargs=(windows,)) as pool:
        found = dict(zip(order, pool.map(_run, [jobs[k] for k in order]), strict=True))
    return [found[k] for k in range(len(jobs))]


def one_by_one(windows: Windows, jobs: Sequence[Job[Found]], /) -> list[Found]:
    """In this process."""
    return [job.run(windows) for job in jobs]


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


def _run(job: Job[Found]) -> Found:
    return job.run(_shared)
