"""The wrench of a rigid body, against the regressor."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from core.payload.inertia import regressor
from core.payload.rigid_wrench import wrench
from tests.core.effects.mechanical_truth import scene


@settings(max_examples=20)
@given(st.lists(st.floats(-2.0, 2.0), min_size=10, max_size=10))
def test_the_compiled_wrench_is_the_regressors(phi: list[float]) -> None:
    np.testing.assert_allclose(wrench(scene().motion, np.array(phi)), regressor(scene().motion) @ np.array(phi), atol=1e-9)
