"""The play of a gear, against physics that is written down here."""

from __future__ import annotations

import numpy as np

from core.effects.joint_backlash import JointBacklash
from tests.core.effects.mechanical_truth import T, believed, change, load, rms, truth
from tests.core.effects.planted_mechanics import PLAY


def test_hard_contact_shifts_a_joint_by_all_of_its_play_while_it_is_pushed_to_one_side() -> None:
    """A second derivative from the rows before, twice four of them, sees a change of sides up to seven rows later."""
    pushed = (np.abs(load(T)) > 1.5).all(axis=1)
    settled = np.convolve(~pushed, np.ones(8))[: len(T)] == 0
    true = truth(lambda t: believed(t) - PLAY * np.sign(load(t))).wrench() - truth().wrench()
    found = change(JointBacklash(), np.append(PLAY, [0.1, 0.003]))
    assert settled.mean() > 0.4
    assert rms(true[settled]) > 0.5
    assert rms((found - true)[settled]) < 0.02 * rms(true[settled])
