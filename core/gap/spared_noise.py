"""What an effect spares itself of the twin's own noise.

The twin predicts from measured joints, and their noise goes through the payload and every effect with the rest. A filter takes some of it
away, and so does an effect that stands for the payload's weight and leaves it next to no mass: the residual gets smaller whether the effect
is there or not. That is no evidence, and is given back. An effect that jumps makes much noise of little, since it jumps early or late,
and so does one that swings without damping: what it predicts is that much less certain, which excuses a residual and has its price (the
normal density's two terms). What is far beyond it is not excused.
"""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.gap.problem import Problem
from core.gap.windows import BLUR, LATE, PHI, Windows
from core.payload.inertia import spatial_inertia

LEAST = 1.0
"""Of chi-square in all: less noise of the kinematics is not looked at."""
FEWER = 4
"""Draws, where nothing is filtered and hardly any noise is spared."""
LOUD = 1.0
"""Times the variance of the noise: what adds more of it, on a motion and in a channel, is as uncertain as what jumps."""
MOST_EXCUSED = 100.0
"""Times the variance that noise makes may be excused by it: what shakes an arm may be ten times what is known of it, and no more."""


def take_off_noise(held_out: Array, problem: Problem, theta: Array, beta: Array) -> Array:
    """(6, K), chi-square of motions left out as it is without what the effects have made of the twin's noise.

    Args:
        held_out: (6, K), as it was found.
        theta, beta: see `estimate_spared_noise`.
    """
    spared = estimate_spared_noise(problem, theta, beta)
    if not any(effect.jumps for effect in problem.effects) and spared.min() > -LOUD:
        return np.asarray(held_out + spared)
    held_out = share_among_channels(problem.windows, held_out)
    added = np.maximum(0.0, -spared)
    possible = MOST_EXCUSED * (1.0 + added)
    excused = possible / np.maximum(_by_motion(problem.windows, held_out), possible)
    return np.asarray(held_out * (1.0 - excused * added / (1.0 + added)) + np.maximum(0.0, spared) + np.log1p(added))


def estimate_spared_noise(problem: Problem, theta: Array, beta: Array) -> Array:
    """(6, K), chi-square that the noise of the kinematics loses on its way through payload, effects and small imperfections, against what
    it is taken to be, as expected for each motion and channel.

    Args:
        theta: of the effects.
        beta: payload, through which noise of the kinematics becomes a wrench, offsets, small imperfections.
    """
    windows, phi = problem.windows, beta[PHI]
    inertia = spatial_inertia(phi).T
    seen = windows.kinematic_noise
    taken, rows = (windows.whiten_windowed(seen.windowed @ through) for through in (spatial_inertia(windows.phi).T, inertia))
    late = windows.whiten_windowed((-beta[LATE] * seen.rate + 0.5 * beta[BLUR] * seen.rate_of_rate) @ inertia)
    expected = np.square(taken).mean(axis=0)
    if expected.sum() < LEAST:
        return np.zeros(windows.target.shape)
    passed = rows
    if problem.effects or problem.held:
        draws, scene = slice(FEWER if problem.only_adds else None), windows.basis.scene.with_phi(phi)
        expected = np.square(taken[draws]).mean(axis=0)
        passed = windows.rows_of(problem.pass_noise(theta, scene, seen.on_grid[draws])).transpose(2, 0, 1)
        late = late[draws]
    return _by_motion(windows, expected - np.square(passed + late).mean(axis=0))


def share_among_channels(windows: Windows, held_out: Array) -> Array:
    """(6, K), the same sum for each motion, of which no channel has a negative part: what one explains of another counts there, where it is
    excused with it."""
    sums = np.array([np.bincount(windows.group, weights=channel) for channel in held_out])
    positive = np.maximum(sums, 0.0)
    kept = np.where(sums > 0.0, np.maximum(sums.sum(axis=0), 0.0) / np.maximum(positive.sum(axis=0), 1e-12), 0.0)
    return np.asarray(held_out * kept[:, windows.group])


def _by_motion(windows: Windows, rows: Array) -> Array:
    """(6, K), each row replaced by the mean over its motion."""
    count = np.bincount(windows.group)
    means = [np.bincount(windows.group, weights=channel) / np.maximum(count, 1) for channel in rows]
    return np.array([mean[windows.group] for mean in means])
