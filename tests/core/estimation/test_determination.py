"""Why a parameter is not determined, and what a determined one rests on."""

from __future__ import annotations

import numpy as np
import pytest

from core.estimation.determination import find_determined, reasons
from core.payload.inertia import PHI_NAMES, Motion

PHI = np.array([2.0, 0.0, 0.0, 0.1, 0.02, 0.0, 0.0, 0.02, 0.0, 0.01])
HARDLY = Motion.still(np.tile([9.81, 0.0, 0.0], (50, 1)))
UNKNOWN = np.concatenate((np.full(4, 1e-4), np.full(6, 1.0)))


@pytest.mark.parametrize(
    ("turned", "expected"),
    [
        ("", {"Ixx": "x", "Ixy": "x or y", "Ixz": "x or z", "Iyy": "y", "Iyz": "y or z", "Izz": "z"}),
        ("x", {"Iyy": "y", "Iyz": "y or z", "Izz": "z"}),
        ("xy", {"Izz": "z"}),
        ("xyz", {}),
        (None, {}),
    ],
)
def test_a_parameter_that_no_rotation_shows_is_not_determined_for_that_reason_first(turned: str | None, expected: dict[str, str]) -> None:
    known = find_determined(PHI, UNKNOWN)
    why = reasons(PHI, UNKNOWN, known, static=False, motion=HARDLY, turned=turned)
    assert set(why) == set(PHI_NAMES[4:])
    told = {name: said.text.partition(";")[0] for name, said in why.items() if said.text.startswith("no rotation")}
    assert told == {name: f"no rotation about {axes}" for name, axes in expected.items()}
    assert all("standard uncertainty" in said.text for said in why.values())
