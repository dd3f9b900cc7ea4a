"""The budget adds up, names what contributes most, and says what was assumed."""

from __future__ import annotations

import numpy as np

from core.estimation.budget import REPEATABILITY, Budget, Source

KNOWN = np.ones(10, dtype=bool)


def budget() -> Budget:
    gain = Source("sensor_gain", stated=False, directions=np.column_stack((np.linspace(3.0, 0.0, 10), np.zeros(10))))
    gravity = Source("gravity", stated=True, directions=np.full((10, 1), 0.5))
    return Budget(np.eye(10), (gain, gravity))


def test_variances_of_the_parts_add_to_the_whole() -> None:
    found = budget()
    squares = sum(std**2 for std in found.parts.values())
    np.testing.assert_allclose(np.diag(found.covariance), squares)
    assert list(found.parts) == [REPEATABILITY, "sensor_gain", "gravity"]


def test_each_parameter_names_its_largest_part() -> None:
    assert budget().largest[0] == "sensor_gain"
    assert budget().largest[9] == REPEATABILITY


def test_only_what_was_assumed_and_matters_is_said() -> None:
    assert [said.code for said in budget().assumptions(KNOWN)] == ["estimation-assumed-gain"]
    assert budget().assumptions(np.zeros(10, dtype=bool)) == ()
    small = Source("sensor_gain", stated=False, directions=np.full((10, 1), 0.01))
    assert Budget(np.eye(10), (small,)).assumptions(KNOWN) == ()
