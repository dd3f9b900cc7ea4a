"""Parts of the procedure: what they do not show."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from core.payload.inertia import PHI_NAMES, Motion, regressor
from core.planning.settings import Scope

PARTS = [Scope(axes, rotations) for axes, rotations in product(("x", "y", "z", "xy", "xz", "yz", "xyz"), (True, False))]


@pytest.mark.parametrize("scope", PARTS, ids=str)
def test_what_is_not_excited_is_what_no_angular_acceleration_of_its_rotations_shows(scope: Scope) -> None:
    """The oracle is Eq. (1): columns of the regressor that stay zero while each axis that is turned about accelerates alone."""
    turned = np.eye(3)[["xyz".index(axis) for axis in scope.axes if scope.rotations]]
    rows = len(turned)
    still = np.zeros((rows, 3))
    shown = np.abs(regressor(Motion(g=still, omega=still, alpha=turned, a=still))).reshape(-1, 10).sum(axis=0) if rows else np.zeros(10)
    assert set(scope.not_excited) == {name for name, seen in zip(PHI_NAMES[4:], shown[4:], strict=True) if seen == 0.0}
