"""How far the links of an arm may be from what its URDF says of them."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.payload.inertia import InertialParameters, six_of

ASSUMED_LINK_STD = 0.1
"""Of each link's mass, relative."""
CENTRE_M = 0.02
"""Of each link's centre of mass, along each axis, for a relative error of the mass of `ASSUMED_LINK_STD`; otherwise in proportion."""
SPIN = 2.0
"""Relative error of the moments about the centre of mass, in units of that of the mass."""
SMALLEST_GYRATION_M = 0.05
"""Radius of gyration that a link is taken to have at least."""
UNKNOWN = np.array([5.0, 2.0, 2.0, 2.0, 1.0, 0.5, 0.5, 1.0, 0.5, 1.0])
"""kg, kg m, kg m2: a link of which the URDF states no mass."""


def link_modes(links: Array, std: float) -> Array:
    """(10 n, 10 n): a column for each independent error of size one standard deviation: n masses, 3 n centres, 6 n moments.

    Args:
        links: (n, 10), in the joints' frames; std: relative, of the masses.
    """
    n = len(links)
    modes = np.zeros((10 * n, 10 * n))
    for k, phi in enumerate(links):
        columns = np.concatenate(([k], n + 3 * k + np.arange(3), 4 * n + 6 * k + np.arange(6)))
        modes[10 * k : 10 * k + 10, columns] = np.diag(UNKNOWN) if phi[0] <= 0.0 else _modes_of(InertialParameters(phi), std)
    return modes


def _modes_of(body: InertialParameters, std: float) -> Array:
    """(10, 10): the whole heavier, its centre elsewhere along three axes, its moments and products about the centre larger."""
    m, c = body.mass, body.com
    aside = CENTRE_M * std / ASSUMED_LINK_STD
    spin = np.maximum(np.diag(body.inertia_com), m * SMALLEST_GYRATION_M**2)
    sizes = SPIN * std * six_of(np.sqrt(np.outer(spin, spin))) * np.where(_DIAGONAL, 1.0, 0.5)
    columns = [std * body.phi]
    for axis in np.eye(3):
        shifted = m * (2.0 * (c @ axis) * np.eye(3) - np.outer(c, axis) - np.outer(axis, c))
        columns.append(aside * np.concatenate(([0.0], m * axis, six_of(shifted))))
    return np.column_stack([*columns, np.vstack((np.zeros((4, 6)), np.diag(sizes)))])


_DIAGONAL = np.array([True, False, False, True, False, True])
