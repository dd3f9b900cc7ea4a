"""When something touched the payload: stretches in which the wrench leaves the rigid body by a force at a point of the payload.

A hand pushes as it likes, several times; its force follows no curve that a model could have. What a contact leaves alone is the rest of
the recording: the payload is the one that most rows agree on, and a contact is where the others leave it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.stats import binom, chi2

from core.array import Array
from core.gap.effect_fit import EffectFit
from core.gap.most_rows import DRAWN, FREE, PARTS, fit_most
from core.gap.windows import Windows
from core.payload.rotations import cross

BEGINS, STANDS_OUT = 4.0, 10.0
"""A stretch reaches as far as rows are so many times the median of the free ones, and somewhere it is as large as that."""
EDGE = 0.02
"""Both ends are where a stretch rises above so small a share of its own largest row: what rings on after it is none of it."""
MARGIN_S = 0.5
"""Beside each stretch so much is left out with it, where enough remains: a push begins and ends below that share."""
LEAST = 0.05
"""A stretch whose largest row is a smaller share of the largest of all is what the payload's model gets wrong, not another contact."""
APART_S = 0.25
"""Two stretches with less between them are one."""
LETS_GO = 0.1
"""Share of a stretch's largest row below which nobody pushes in it, where that lasts: a sensor does not come back to nothing at once."""
AT_A_POINT = 0.8
"""Share of the torque's square that a force at one point of the payload accounts for in each stretch, over all of them."""
ONE_WAY = 0.5
"""Length of a stretch's mean force over its root mean square: who touches pushes; what shakes goes to and fro."""
MOVES = 0.9
"""Share of a stretch's rows in which the arm moves, from which on it lies within motion."""
BY_CHANCE = 0.01
"""Who touches chooses times and directions of his own: stretches that are so seldom all within motion by chance are made by it, like drag;
forces whose impulses so seldom come to so little in all are those of a base that is moved and stands again,"""
SEVERAL = 4
"""from so many on: one push there and one back are no such thing."""


@dataclass(frozen=True)
class Contact:
    """One stretch.

    Args:
        begin_s, end_s: times of the recording.
        force: (3,), the mean on the payload, N, base axes.
        most_n: the largest, N.
        point: (3,), where it acts, m, sensor axes.
        off_point, one_way: as `AT_A_POINT` (the rest of that share) and `ONE_WAY` count them.
        moving: share of its rows in which the arm moves.
    """

    begin_s: float
    end_s: float
    force: Array
    most_n: float
    point: Array
    off_point: float
    one_way: float
    moving: float

    @property
    def impulse(self) -> Array:
        """(3,), N s, base axes."""
        return self.force * (self.end_s - self.begin_s)


@dataclass(frozen=True)
class Contacts:
    """All pushes of a recording, in their order, and which rows (K,) are free of the stretches in which they are."""

    found: tuple[Contact, ...]
    free: NDArray[np.bool_]

    @property
    def strongest(self) -> Contact:
        """The one with the largest force."""
        return max(self.found, key=lambda contact: contact.most_n)


def find_contacts(windows: Windows, fit: EffectFit) -> Contacts | None:
    """When something touched the payload, beside what a fit has added to the twin; None where nothing did, or where what leaves the payload
    does not look like that."""
    seen = _find_astray(windows, fit)
    if seen is None:
        return None
    residual, stretches, free = seen
    if not stretches or stretches[0].start == 0 or free.mean() < FREE:
        return None  # who touches begins to touch: what is there from the first row on may be anything
    wider = _leave_margins(windows.centres, stretches)
    free = wider if wider.mean() >= FREE else free
    wrench, rotation, moves = -windows.unwhiten(residual), windows.average_rotation(), _find_motion(windows)

    def describe(some: list[slice]) -> tuple[Contact, ...]:
        return tuple(_describe(windows.centres[rows], wrench[rows], rotation[rows], float(moves[rows].mean())) for rows in some)

    found = describe(stretches)
    if _come_with_motion(found, float(moves.mean())) or _cancel_out(found) or not _are_pushes(found):
        return None
    size = _find_size(residual)
    return Contacts(describe([push for rows in stretches for push in split_pushes(windows.centres, size, rows)]), free)


def find_free(windows: Windows, fit: EffectFit) -> NDArray[np.bool_] | None:
    """(K,), the rows which most agree on beside what a fit has added to the twin; None where that is too few."""
    seen = _find_astray(windows, fit)
    return None if seen is None or seen[2].mean() < FREE else seen[2]


def keep_rows(windows: Windows, kept: NDArray[np.bool_]) -> Windows:
    """The same recording with some of its rows (K,) alone."""
    rows = windows.basis.rows
    rest = replace(rows, centres=rows.centres[kept], average=rows.average[kept], part=rows.part[kept])
    return Windows(replace(windows.basis, rows=rest), windows.held)


def _find_astray(windows: Windows, fit: EffectFit) -> tuple[Array, list[slice], NDArray[np.bool_]] | None:
    """The residual (6, K), whitened, of the payload that most rows agree on, the stretches in which it is large, and the rows (K,) outside
    of them; None of recordings that are too short."""
    if windows.basis.scene.apart or len(windows) < PARTS * DRAWN:
        return None
    target = windows.target - fit.change
    residual = target - windows.X @ fit_most(windows, target)
    stretches = find_stretches(windows.centres, _find_size(residual))
    free = np.ones(len(windows), dtype=bool)
    for rows in stretches:
        free[rows] = False
    return residual, stretches, free


def _find_size(residual: Array) -> Array:
    """(K,), root mean square of each row of a residual (6, K)."""
    return np.asarray(np.sqrt((residual**2).mean(axis=0)))


def _find_motion(windows: Windows) -> NDArray[np.bool_]:
    """(K,), whether the arm moves in each row."""
    scene = windows.basis.scene
    moves = ~np.char.startswith(scene.phase, "hold")
    return np.asarray(np.interp(windows.centres, scene.t, moves.astype(float)) > 0.5)


def _leave_margins(t: Array, stretches: list[slice]) -> NDArray[np.bool_]:
    """(K,), rows at times t (K,) that are farther than the margin from every stretch."""
    free = np.ones(len(t), dtype=bool)
    for rows in stretches:
        free &= (t < t[rows.start] - MARGIN_S) | (t > t[rows.stop - 1] + MARGIN_S)
    return free


def find_stretches(t: Array, size: Array) -> list[slice]:
    """Rows of each stretch.

    Args:
        t: (K,), s.
        size: (K,), root mean square of each row.
    """
    unit = float(np.median(np.sort(size)[: round(FREE * len(size))]))
    high = np.flatnonzero(size > BEGINS * unit)
    apart = max(APART_S, 1.5 * float(np.median(np.diff(t))))  # rows of slow streams are farther from each other than that
    runs = np.split(high, np.flatnonzero(np.diff(t[high]) > apart) + 1)
    least = max(STANDS_OUT * unit, LEAST * float(size.max()))
    return [_trim(run, size) for run in runs if len(run) and float(size[run].max()) >= least]


def _trim(run: NDArray[np.intp], size: Array) -> slice:
    above = run[size[run] > EDGE * float(size[run].max())]
    return slice(int(above[0]), int(above[-1]) + 1)


def split_pushes(t: Array, size: Array, rows: slice) -> list[slice]:
    """The pushes in a stretch of rows, without what lies before, between and behind them, where each row is small and as large as before.

    Args:
        t: (K,), s.
        size: (K,), root mean square of each row.
    """
    peak, inside = float(size[rows].max()), np.arange(rows.start, rows.stop)
    low = inside[size[inside] < LETS_GO * peak]
    rests = np.zeros(len(size), dtype=bool)
    for run in np.split(low, np.flatnonzero(np.diff(low) > 1) + 1):
        if len(run) and t[run[-1]] - t[run[0]] >= APART_S:
            still = run[size[run] <= float(np.median(size[run])) + EDGE * peak]
            rests[still[0] : still[-1] + 1] = True
    pushed = inside[~rests[inside]]
    return [slice(int(run[0]), int(run[-1]) + 1) for run in np.split(pushed, np.flatnonzero(np.diff(pushed) > 1) + 1)]


def _describe(t: Array, wrench: Array, rotation: Array, moving: float) -> Contact:
    """A stretch with times t (K,), the wrench on the payload (K, 6), sensor axes, the sensor's axes in the base (K, 3, 3), and the share of
    it in which the arm moves."""
    force, torque = wrench[:, :3], wrench[:, 3:]
    arms = np.stack([cross(axis, force) for axis in np.eye(3)], axis=2).reshape(-1, 3)
    point = np.asarray(np.linalg.lstsq(arms, torque.ravel(), rcond=1e-2)[0], dtype=np.float64)
    off = float(np.square(torque.ravel() - arms @ point).sum() / max(float(np.square(torque).sum()), 1e-300))
    in_base = np.einsum("kij,kj->ki", rotation, force)
    mean, size = in_base.mean(axis=0), np.linalg.norm(force, axis=1)
    one_way = float(np.linalg.norm(mean) / max(float(np.sqrt(np.square(size).mean())), 1e-300))
    return Contact(float(t[0]), float(t[-1]), mean, float(size.max()), point, off, one_way, moving)


def _are_pushes(found: tuple[Contact, ...]) -> bool:
    """Whether the stretches, each by its largest force, look like somebody pushing at a point."""
    weights = np.square([contact.most_n for contact in found])
    off = np.average([contact.off_point for contact in found], weights=weights)
    return bool(off <= 1.0 - AT_A_POINT and np.average([contact.one_way for contact in found], weights=weights) >= ONE_WAY)


def _come_with_motion(found: tuple[Contact, ...], moving: float) -> bool:
    """Whether so many of the stretches lie within motion as chance hardly gives, `moving` being the share of motion in the recording."""
    within = sum(contact.moving >= MOVES for contact in found)
    return bool(binom.sf(within - 1, len(found), moving) < BY_CHANCE)


def _cancel_out(found: tuple[Contact, ...]) -> bool:
    """Whether the impulses come to less in all than those of independent directions do (Rayleigh's test in three dimensions, its lower
    tail)."""
    impulses = np.array([contact.impulse for contact in found])
    sums, squares = float(np.square(impulses.sum(axis=0)).sum()), float(np.square(impulses).sum())
    return len(found) >= SEVERAL and bool(chi2.cdf(3.0 * sums / max(squares, 1e-300), 3) < BY_CHANCE)
