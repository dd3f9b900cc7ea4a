"""A push from outside, against physics that is written down here."""

from __future__ import annotations

import numpy as np
import pytest

from core.effects.contact_that_changes import ContactThatChanges
from core.effects.external_contact import ExternalContact
from tests.core.effects.mechanical_truth import T
from tests.core.effects.plain_fit import fitted
from tests.core.effects.planted_mechanics import PUSH, inside, touched


def test_half_a_sine_of_contact_is_explained_by_a_tapered_window() -> None:
    shape = inside() * np.sin(np.pi * np.clip((T - 8.0) / 4.5, 0, 1))
    fit = fitted(ExternalContact(), touched(shape), 0.0)
    assert fit.closure > 0.98
    assert fit.theta[0] + 0.5 * fit.theta[1] == pytest.approx(10.25, abs=0.1)
    np.testing.assert_allclose(fit.theta[3:6], PUSH, rtol=0.1)


def test_a_push_that_grows_and_lets_go_at_once_is_explained_by_one_that_changes() -> None:
    grown = touched(inside() * (0.3 + 0.7 * np.clip((T - 8.0) / 4.5, 0, 1)))
    assert fitted(ExternalContact(), grown, 0.0).closure < 0.98
    fit = fitted(ContactThatChanges(), grown, 0.0)
    assert fit.closure > 0.99
    assert fit.theta[:2] == pytest.approx([8.0, 4.5], abs=0.1)
    np.testing.assert_allclose(fit.theta[3:6] + 0.5 * fit.theta[9:12], PUSH, rtol=0.1)
