"""When something touched the payload: stretches in which the wrench leaves the rigid body by a force at a point of the payload.

A hand pushes as it likes, several times; its force follows no curve that a model could have. What a contact leaves alone is the rest of
the recording: the payload is the one that most rows agree on, and a contact is where the others leave it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

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
AT_A_POINT = 0.8
"""Share of the torque's square that a force at one point of the payload accounts for in each stretch, over all of them."""
ONE_WAY = 0.5
"""Length of a stretch's mean force over its root mean square: who touches pushes; what shakes goes to and fro."""


@dataclass(frozen=True)
class Contact:
    """One stretch.

    Args:
        begin_s, end_s: times of the recording.
        force: (3,), the mean on the payload, N, base axes.
        most_n: the largest, N.
        point: (3,), where it acts, m, sensor axes.
        off_point, one_way: as `AT_A_POINT` (the rest of that share) and `ONE_WAY` count them.
    """

    begin_s: float
    end_s: float
    force: Array
    most_n: float
    point: Array
    off_point: float
    one_way: float


@dataclass(frozen=True)
class Contacts:
    """All stretches of a recording, in their order, and which rows (K,) are free of them."""

    found: tuple[Contact, ...]
    free: NDArray[np.bool_]

    @property
    def strongest(self) -> Contact:
        """The one with the largest force."""
        return max(self.found, key=lambda contact: contact.most_n)

    def leave_out(self, windows: Windows) -> Windows:
        """The same recording without the rows in which something touched it."""
        rows = windows.basis.rows
        kept = replace(rows, centres=rows.centres[self.free], average=rows.average[self.free], part=rows.part[self.free])
        return Windows(replace(windows.basis, rows=kept), windows.held)


def find_contacts(windows: Windows, nominal: EffectFit) -> Contacts | None:
    """When something touched the payload; None where nothing did, or where what leaves the payload does not look like that."""
    if windows.basis.scene.apart or len(windows) < PARTS * DRAWN:
        return None
    target = windows.target - nominal.change
    residual = target - windows.X @ fit_most(windows, target)
    stretches = find_stretches(windows.centres, np.sqrt((residual**2).mean(axis=0)))
    free = np.ones(len(windows), dtype=bool)
    for rows in stretches:
        free[rows] = False
    if not stretches or stretches[0].start == 0 or free.mean() < FREE:
        return None  # who touches begins to touch: what is there from the first row on may be anything
    wider = _leave_margins(windows.centres, stretches)
    free = wider if wider.mean() >= FREE else free
    wrench, rotation = -windows.unwhiten(residual), windows.average_rotation()
    found = tuple(_describe(windows.centres[rows], wrench[rows], rotation[rows]) for rows in stretches)
    return Contacts(found, free) if _are_pushes(found) else None


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
    runs = np.split(high, np.flatnonzero(np.diff(t[high]) > APART_S) + 1)
    least = max(STANDS_OUT * unit, LEAST * float(size.max()))
    return [_trim(run, size) for run in runs if len(run) and float(size[run].max()) >= least]


def _trim(run: NDArray[np.intp], size: Array) -> slice:
    above = run[size[run] > EDGE * float(size[run].max())]
    return slice(int(above[0]), int(above[-1]) + 1)


def _describe(t: Array, wrench: Array, rotation: Array) -> Contact:
    """A stretch with times t (K,), the wrench on the payload (K, 6), sensor axes, and the sensor's axes in the base (K, 3, 3)."""
    force, torque = wrench[:, :3], wrench[:, 3:]
    arms = np.stack([cross(axis, force) for axis in np.eye(3)], axis=2).reshape(-1, 3)
    point = np.asarray(np.linalg.lstsq(arms, torque.ravel(), rcond=1e-2)[0], dtype=np.float64)
    off = float(np.square(torque.ravel() - arms @ point).sum() / max(float(np.square(torque).sum()), 1e-300))
    in_base = np.einsum("kij,kj->ki", rotation, force)
    mean, size = in_base.mean(axis=0), np.linalg.norm(force, axis=1)
    one_way = float(np.linalg.norm(mean) / max(float(np.sqrt(np.square(size).mean())), 1e-300))
    return Contact(float(t[0]), float(t[-1]), mean, float(size.max()), point, off, one_way)


def _are_pushes(found: tuple[Contact, ...]) -> bool:
    """Whether the stretches, each by its largest force, look like somebody pushing at a point."""
    weights = np.square([contact.most_n for contact in found])
    off = np.average([contact.off_point for contact in found], weights=weights)
    return bool(off <= 1.0 - AT_A_POINT and np.average([contact.one_way for contact in found], weights=weights) >= ONE_WAY)
