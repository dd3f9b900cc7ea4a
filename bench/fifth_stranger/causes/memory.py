"""The sensor remembers: rubbing in its clamped joints, glue that flows."""

from __future__ import annotations

import numpy as np

from bench.fourth_stranger.draws import spread_over_grid
from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Size
from bench.second_stranger.rig import Rig
from bench.second_stranger.signals import follow_dahl, lag

EVERY = 20
WIDTHS = (0.05, 0.25)
"""Shares of the load's span that the fine and the coarse contacts need to turn round."""
GLUE_S, GLUE_SHARES = (1.2, 6.0, 30.0), (0.35, 0.35, 0.3)


def hyst_clamp(rng: np.random.Generator, rig: Rig) -> Fault:
    """Clamped joints of the beams rub, fine contacts first and coarse ones later; some channels more than others."""
    span = np.ptp(rig.load, axis=0)
    share = 0.004 * rng.uniform(0.5, 1.2, 6)

    def rub(W: Array, scale: float) -> Array:
        coarse = W[::EVERY] / span
        loops = [sum(follow_dahl(np.diff(x), width) for width in WIDTHS) / len(WIDTHS) for x in coarse.T]
        return np.asarray(W - scale * share * span * spread_over_grid(rig, np.stack(loops, 1), EVERY))

    return Fault(size=lambda scale: Size("half width of the loop, fx, of its span", 100 * scale * share[0], "%"), distort=rub)


def creep_glue(rng: np.random.Generator, _: Rig) -> Fault:
    """Glue under the gauges flows over decades of time, so nearly as a logarithm; less under some than under others."""
    share = 0.006 * np.array([1, 0.8, 1.3, 0.5, 0.7, 1.0]) * rng.choice([-1, 1])

    def flow(W: Array, scale: float) -> Array:
        crept = sum(part * (lag(W, tau_s) - W) for tau_s, part in zip(GLUE_S, GLUE_SHARES, strict=True))
        return np.asarray(W + scale * share * crept)

    return Fault(size=lambda scale: Size("creeps after a step, fx, over 1 to 30 s", 100 * scale * share[0], "%"), distort=flow)
